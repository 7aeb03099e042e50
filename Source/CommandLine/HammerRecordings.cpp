#include "HammerRecordings.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/NumberText.h>
#include <antinode_responses/PointsFile.h>
#include <antinode_text/NaturalOrder.h>

#include <cmath>
#include <cstdio>

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

/** What the options say of the motion; nothing where they say nothing. */
std::optional<ResponseUnit> statedMotion (const HammerRecordingOptions& options)
{
    if (options.quantity.empty() && options.responseUnit.empty())
        return std::nullopt;

    auto unit = responseUnit (options.responseUnit).value_or (ResponseUnit {});

    if (! options.responseUnit.empty() && (! unit.quantity || unit.drive))
        throw InputError ("--response-unit", "is " + inQuotes (options.responseUnit)
                                                 + "; allowed: the unit of a motion, for example m/s^2, g, mm/s");

    if (! options.quantity.empty() && unit.quantity && *unit.quantity != quantityOf (options.quantity))
        throw InputError ("--quantity",
                          "is " + options.quantity + ", but the unit is " + inQuotes (options.responseUnit));

    if (! options.quantity.empty())
        unit.quantity = quantityOf (options.quantity);

    return unit;
}

HammerOptions hammerOptions (const HammerRecordingOptions& options, const std::string& pointsFile,
                             ResponseEstimator estimator)
{
    constexpr double percent = 100;
    HammerOptions hammer;
    hammer.hits = { options.trigger / percent, options.block, options.windowDecay };
    hammer.estimator = estimator;
    hammer.lowestFrequency = options.lowest.value_or (0);
    hammer.highestFrequency = options.highest.value_or (0);
    hammer.responseScale = options.responseScale;
    hammer.forceScale = options.forceScale;
    hammer.hitPoint = options.hitPoint;
    hammer.stated.response = statedMotion (options);

    if (! options.forceUnit.empty())
    {
        hammer.stated.drive = driveUnit (options.forceUnit);

        if (! hammer.stated.drive || hammer.stated.drive->drive != DriveQuantity::force)
            throw InputError ("--force-unit",
                              "is " + inQuotes (options.forceUnit) + "; allowed: a unit of force, for example N");
    }

    if (! pointsFile.empty())
    {
        const auto places = readPointsFile (pointsFile);

        for (Eigen::Index p = 0; p < places.rows(); ++p)
            hammer.stated.places.emplace (std::to_string (p + 1), places.row (p).transpose());
    }

    return hammer;
}

void printHits (const HammerMeasurement& measurement)
{
    for (std::size_t i = 0; i < measurement.recordings.size(); ++i)
    {
        const auto& hits = measurement.test.hits[i];
        const auto& recording = measurement.recordings[i];
        std::size_t used = 0;

        for (const auto& hit : hits)
            used += hit.fault.empty() ? 1 : 0;

        std::printf ("%s: %zu of %zu hits used\n", recording.source.c_str(), used, hits.size());

        for (std::size_t h = 0; h < hits.size(); ++h)
            if (! hits[h].fault.empty())
                std::printf ("  hit %zu at %.3f s left out: %s\n", h + 1,
                             static_cast<double> (hits[h].trigger) / recording.sampleRate, hits[h].fault.c_str());
    }
}

/** Over all lines and responses that have one; not a number where none has. */
double meanCoherenceOf (const HammerMeasurement& measurement)
{
    double sum = 0;
    Eigen::Index count = 0;

    for (const auto& coherence : measurement.coherence)
        for (const auto value : coherence.reshaped())
            if (std::isfinite (value))
            {
                sum += value;
                ++count;
            }

    return sum / static_cast<double> (count);
}

void printOutcome (const HammerMeasurement& measurement)
{
    const auto& frequencies = measurement.responses.frequencies;
    const auto rate = measurement.recordings.front().sampleRate;
    const auto spacing = rate / static_cast<double> (measurement.test.block);
    const auto coherence = meanCoherenceOf (measurement);

    for (const auto& remark : measurement.remarks)
        std::printf ("%s\n", remark.c_str());

    constexpr double disturbing = 0.01;

    if (const auto before = measurement.test.motionBefore; before > disturbing)
        std::printf ("Warning: before a hit the signal has %.1f %% of the hit's motion: wait longer between hits, or "
                     "lower the noise\n",
                     100 * before);

    if (measurement.test.windowDecay > 0)
        std::printf ("Exponential window of %.4g 1/s: identify takes its damping off again\n",
                     measurement.test.windowDecay);
    else
        std::printf ("No exponential window: the motion has decayed at the end of a hit\n");

    std::printf ("%s to %s Hz every %.4g Hz, responses of %td points and directions to %zu references, ",
                 inWords (frequencies[0]).c_str(), inWords (frequencies[frequencies.size() - 1]).c_str(), spacing,
                 measurement.responses.points.rows(), measurement.responses.references.size());
    std::printf ("%s\n", std::isfinite (coherence) ? formatted ("mean coherence %.4f", coherence).c_str()
                                                   : "no coherence: one hit each");
}
} // namespace

void addHammerRecordingOptions (CLI::App& command, HammerRecordingOptions& options)
{
    const auto keep = [&options] (CLI::Option* option) { options.options.push_back (option); };
    keep (command
              .add_option ("--channels", options.channels,
                           "Hammer: channels of WAV and text files in their order, for example force,1:x,1:y,1:z")
              ->delimiter (','));
    keep (command.add_option ("--hit-point", options.hitPoint, "Hammer: point that is hit; default: as the files say"));
    keep (command.add_option ("--quantity", options.quantity, "Hammer: measured quantity; default: as the files say")
              ->check (CLI::IsMember ({ "displacement", "velocity", "acceleration" })));
    keep (command.add_option ("--response-unit", options.responseUnit,
                              "Hammer: unit of the motion, for example m/s^2 or g"));
    keep (
        command.add_option ("--response-scale", options.responseScale, "Hammer: motion of a sample of 1, in its unit")
            ->check (CLI::PositiveNumber)
            ->capture_default_str());
    keep (command.add_option ("--force-unit", options.forceUnit,
                              "Hammer: unit of the force; default: as the files say, or N"));
    keep (command.add_option ("--force-scale", options.forceScale, "Hammer: force of a sample of 1, in its unit")
              ->check (CLI::PositiveNumber)
              ->capture_default_str());
    keep (
        command.add_option ("--trigger-percent", options.trigger, "Hammer: trigger, % of the largest force of a file")
            ->check (CLI::Range (0.1, 99.0))
            ->capture_default_str());
    keep (command
              .add_option ("--block-s", options.block,
                           "Hammer: duration of a hit, s; default: up to the next one, at most 4 s or 4096 samples")
              ->check (CLI::Range (1e-3, 600.0)));
    keep (command
              .add_option ("--window-decay", options.windowDecay,
                           "Hammer: decay rate of the exponential window, 1/s; 0: none; default: chosen")
              ->check (CLI::NonNegativeNumber));
    keep (command
              .add_option ("--lowest-hz", options.lowest, "Hammer: lower end of the band, Hz; default: the first line")
              ->check (CLI::Range (0.0, 1e6)));
    keep (command
              .add_option ("--highest-hz", options.highest,
                           "Hammer: upper end of the band, Hz; default: where the force has fallen by 30 dB")
              ->check (CLI::Range (1e-3, 1e6)));
}

HammerMeasurement measureHammerFiles (const std::vector<std::string>& files, const std::string& pointsFile,
                                      ResponseEstimator estimator, const HammerRecordingOptions& options)
{
    std::vector<RecordingFile> recordings;
    recordings.reserve (files.size());

    const auto names = inNaturalOrder (files);

    for (const auto& name : names)
        recordings.push_back (readRecordings (name, options.channels));

    auto measurement = measureByHammer (recordings, hammerOptions (options, pointsFile, estimator));

    if (const auto remark = orderRemark (files, names); ! remark.empty())
        measurement.remarks.push_back (remark);

    return measurement;
}

ReportPage hammerReport (const HammerMeasurement& measurement)
{
    return hammerReport (measurement.recordings, measurement.test,
                         { measurement.responses, measurement.coherence, {}, {} });
}

void printHammer (const HammerMeasurement& measurement)
{
    printHits (measurement);
    printOutcome (measurement);
}
} // namespace antinode
