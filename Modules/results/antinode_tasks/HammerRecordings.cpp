#include "HammerRecordings.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_responses/PointsFile.h>
#include <antinode_text/NaturalOrder.h>

namespace antinode
{
namespace
{
ResponseQuantity quantityOf (const std::string& word)
{
    return word == "displacement"   ? ResponseQuantity::displacement
           : word == "acceleration" ? ResponseQuantity::acceleration
                                    : ResponseQuantity::velocity;
}

/** What the request say of the motion; nothing where they say nothing. */
std::optional<ResponseUnit> statedMotion (const HammerRequest& request)
{
    if (! request.quantity && request.responseUnit.empty())
        return std::nullopt;

    auto unit = responseUnit (request.responseUnit).value_or (ResponseUnit {});

    if (! request.responseUnit.empty() && (! unit.quantity || unit.drive))
        throw InputError ("--response-unit", "is " + inQuotes (request.responseUnit)
                                                 + "; allowed: the unit of a motion, for example m/s^2, g, mm/s");

    if (request.quantity && unit.quantity && *unit.quantity != quantityOf (*request.quantity))
        throw InputError ("--quantity",
                          "is " + *request.quantity + ", but the unit is " + inQuotes (request.responseUnit));

    if (request.quantity)
        unit.quantity = quantityOf (*request.quantity);

    return unit;
}

HammerOptions hammerOptions (const HammerRequest& request, const std::string& pointsFile, ResponseEstimator estimator)
{
    HammerOptions hammer;
    hammer.hits = { request.trigger, request.block, request.windowDecay };
    hammer.estimator = estimator;
    hammer.lowestFrequency = request.lowest.value_or (0);
    hammer.highestFrequency = request.highest.value_or (0);
    hammer.responseScale = request.responseScale;
    hammer.forceScale = request.forceScale;
    hammer.hitPoint = request.hitPoint;
    hammer.stated.response = statedMotion (request);

    if (! request.forceUnit.empty())
    {
        hammer.stated.drive = driveUnit (request.forceUnit);

        if (! hammer.stated.drive || hammer.stated.drive->drive != DriveQuantity::force)
            throw InputError ("--force-unit",
                              "is " + inQuotes (request.forceUnit) + "; allowed: a unit of force, for example N");
    }

    if (! pointsFile.empty())
    {
        const auto places = readPointsFile (pointsFile);

        for (Eigen::Index p = 0; p < places.rows(); ++p)
            hammer.stated.places.emplace (std::to_string (p + 1), places.row (p).transpose());
    }

    return hammer;
}
} // namespace

std::vector<Field> fields (HammerRequest& request)
{
    constexpr double percent = 100;
    std::vector<Field> all {
        Field ("--channels", &request.channels,
               "channels of WAV and text files in their order, for example force,1:x,1:y,1:z")
            .written ("TEXT", ','),
        Field ("--hit-point", &request.hitPoint, "point that is hit").by ("as the files say"),
        Field ("--quantity", &request.quantity, "measured quantity")
            .oneOf ({ "displacement", "velocity", "acceleration" })
            .by ("as the files say"),
        Field ("--response-unit", &request.responseUnit, "unit of the motion, for example m/s^2 or g")
            .by ("as the files say"),
        Field ("--response-scale", &request.responseScale, "motion of a sample of 1, in its unit")
            .within (1e-300, 1e300),
        Field ("--force-unit", &request.forceUnit, "unit of the force").by ("as the files say, or N"),
        Field ("--force-scale", &request.forceScale, "force of a sample of 1, in its unit").within (1e-300, 1e300),
        Field ("--trigger-percent", &request.trigger, "trigger, % of the largest force of a file")
            .in (percent)
            .within (0.1, 99),
        Field ("--block-s", &request.block, "duration of a hit, s")
            .within (1e-3, 600)
            .by ("up to the next one, at most 4 s or 4096 samples"),
        Field ("--window-decay", &request.windowDecay, "decay rate of the exponential window, 1/s; 0: none")
            .as ("window_decay_per_s")
            .within (0, 1e300)
            .by ("chosen"),
        Field ("--lowest-hz", &request.lowest, "lower end of the band, Hz")
            .as ("lowest_frequency_Hz")
            .within (0, 1e6)
            .by ("the first line"),
        Field ("--highest-hz", &request.highest, "upper end of the band, Hz")
            .as ("highest_frequency_Hz")
            .within (1e-3, 1e6)
            .by ("where the force has fallen by 30 dB"),
    };

    for (auto& field : all)
        field.text.insert (0, "Hammer: ");

    return all;
}

HammerMeasurement measureHammerFiles (const std::vector<std::string>& files, const std::string& pointsFile,
                                      ResponseEstimator estimator, const HammerRequest& request)
{
    std::vector<RecordingFile> recordings;
    recordings.reserve (files.size());

    const auto names = inNaturalOrder (files);

    for (const auto& name : names)
        recordings.push_back (readRecordings (name, request.channels));

    auto measurement = measureByHammer (recordings, hammerOptions (request, pointsFile, estimator));

    if (const auto remark = orderRemark (files, names); ! remark.empty())
        measurement.remarks.push_back (remark);

    return measurement;
}
} // namespace antinode
