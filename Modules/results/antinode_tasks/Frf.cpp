#include "Frf.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_documents/ExcitationFile.h>
#include <antinode_reports/MeasurementReport.h>
#include <antinode_responses/PointsFile.h>
#include <antinode_responses/UniversalFile.h>
#include <antinode_responses/UniversalResponses.h>
#include <antinode_text/NaturalOrder.h>
#include <antinode_text/WaveFile.h>

#include <algorithm>
#include <cmath>

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

namespace
{
/** Other words are h1. */
ResponseEstimator estimatorNamed (const std::string& word)
{
    return word == "h2" ? ResponseEstimator::h2 : word == "hv" ? ResponseEstimator::hv : ResponseEstimator::h1;
}

/** The roles of the channels of a recording, counted from 0; -1: none. */
struct ChannelRoles
{
    Eigen::Index sync = -1, reference = -1;
    std::vector<Eigen::Index> sensors;
};

ChannelRoles findRoles (const FrfRequest& request, Eigen::Index channels, const std::string& file)
{
    ChannelRoles roles;
    roles.sync = request.syncChannel < 0 ? channels - 1 : request.syncChannel - 1;
    roles.reference = request.referenceChannel - 1;

    for (Eigen::Index channel = 0; channel < channels; ++channel)
        if (channel != roles.sync && channel != roles.reference)
            roles.sensors.push_back (channel);

    if (roles.sync >= channels || roles.reference >= channels || (roles.sync == roles.reference && roles.sync >= 0)
        || roles.sensors.empty())
        throw InputError (file,
                          "has " + std::to_string (channels)
                              + " channels, which do not fit the sensors, sync channel and reference of the options; "
                                "--sync-channel 0 stands for no sync channel");

    return roles;
}

/** The sample of a recording at which the first run starts, or slightly before: the sync signal starts there. */
Eigen::Index findOnset (const Eigen::VectorXd& sync, double sampleRate, const std::string& file)
{
    constexpr double threshold = 0.05, leadTime = 0.02;
    const auto minimum = threshold * sync.cwiseAbs().maxCoeff();

    if (! (minimum > 0))
        throw InputError (file, "is silent on its sync channel; --sync-channel gives its number, 0 for none");

    Eigen::Index first = 0;

    while (std::abs (sync[first]) < minimum)
        ++first;

    return std::max<Eigen::Index> (0, first - static_cast<Eigen::Index> (leadTime * sampleRate));
}

/** The channels and runs of a recording. */
struct PlacedRecording
{
    WaveSamples wave;
    ChannelRoles roles;
    Eigen::Index first = 0;
    std::string file;
};

PlacedRecording placed (const FrfRequest& request, const ExcitationSheet& sheet, const std::string& file)
{
    PlacedRecording recording { readWaveFile (file), {}, 0, file };
    const auto rate = sheet.excitation.settings.sampleRate;

    if (recording.wave.sampleRate != rate)
        throw InputError (file, "has a sample rate of " + std::to_string (std::lround (recording.wave.sampleRate))
                                    + " Hz; allowed: " + std::to_string (std::lround (rate))
                                    + " Hz, the rate of the excitation");

    recording.roles = findRoles (request, recording.wave.samples.rows(), file);

    if (recording.roles.sync >= 0)
        recording.first = findOnset (recording.wave.samples.row (recording.roles.sync), rate, file);

    return recording;
}

RunRecording extractRun (const PlacedRecording& recording, const FrfRequest& request, const Excitation& excitation,
                         Eigen::Index ceramic)
{
    const auto& samples = recording.wave.samples;
    const auto first = recording.first + ceramic * excitation.runLength;
    const auto count = std::min (excitation.runLength, samples.cols() - first);

    if (count < excitation.signal.size())
        throw InputError (recording.file, "ends before ceramic " + std::to_string (ceramic + 1) + " of "
                                              + std::to_string (excitation.ceramics()) + " has finished its run");

    RunRecording run;
    run.sensors = samples (recording.roles.sensors, Eigen::seqN (first, count)) * request.sensor.fullScaleVelocity();

    if (recording.roles.sync >= 0)
        run.sync = samples.row (recording.roles.sync).segment (first, count);

    if (recording.roles.reference >= 0)
        run.reference = samples.row (recording.roles.reference).segment (first, count) * request.referenceFullScale;

    return run;
}

void analyse (SurfaceMeasurement& measurement, const PlacedRecording& recording, const FrfRequest& request,
              const Excitation& excitation, Eigen::Index firstPoint)
{
    RunAnalysisSettings settings;
    settings.latency = request.latency * excitation.settings.sampleRate;
    settings.estimator = estimatorNamed (request.estimator);

    for (Eigen::Index ceramic = 0; ceramic < excitation.ceramics(); ++ceramic)
        try
        {
            place (measurement, ceramic, firstPoint,
                   analyseRun (excitation, ceramic, extractRun (recording, request, excitation, ceramic), settings));
        }
        catch (const InputError& error)
        {
            throw InputError (recording.file + ": ceramic " + std::to_string (ceramic + 1), error.what());
        }
}

/** The positions in the file of points, or 1 mm apart on a line. */
Eigen::MatrixX2d readPlaces (const FrfRequest& request, Eigen::Index sensors)
{
    if (request.pointsFile.empty())
    {
        Eigen::MatrixX2d places = Eigen::MatrixX2d::Zero (sensors, 2);
        places.col (0) = Eigen::VectorXd::LinSpaced (sensors, 0, 1e-3 * static_cast<double> (sensors - 1));
        return places;
    }

    auto places = readPointsFile (request.pointsFile.string());

    if (places.rows() != sensors)
        throw InputError (request.pointsFile.string(), "has " + std::to_string (places.rows()) + " points; allowed: "
                                                           + std::to_string (sensors) + ", as in the recordings");

    return places;
}

SurfaceMeasurement estimateResponses (const ExcitationSheet& sheet, const std::vector<std::string>& files,
                                      const FrfRequest& request)
{
    if (files.empty())
        throw InputError ("frf", "has no recording; allowed: the sheet and WAV files");

    requireSensitivity (request.sensor);

    std::vector<Eigen::Index> counts;
    Eigen::Index sensors = 0;

    // Which point is whose is known only when all files' channels are counted; they are too large to be kept.
    for (const auto& file : files)
    {
        counts.push_back (
            static_cast<Eigen::Index> (findRoles (request, readWaveFile (file).samples.rows(), file).sensors.size()));
        sensors += counts.back();
    }

    auto measurement = unmeasured (sheet.excitation, sheet.ceramics, readPlaces (request, sensors));
    Eigen::Index first = 0;

    for (std::size_t i = 0; i < counts.size(); first += counts[i++])
        analyse (measurement, placed (request, sheet, files[i]), request, sheet.excitation, first);

    return measurement;
}

RecordedResponses ofExcitation (const FrfRequest& request)
{
    std::vector<std::string> given (request.files.begin(), request.files.end());
    auto sheet = request.sheet;

    if (! sheet)
    {
        sheet = readSheet (given.front());
        given.erase (given.begin());
    }

    const auto files = inNaturalOrder (given);
    const auto measured = estimateResponses (*sheet, files, request);
    return { measured.responses,         measured.coherence,        measured, std::move (sheet), {},
             collectWarnings (measured), orderRemark (given, files) };
}

RecordedResponses ofHammer (const FrfRequest& request)
{
    const auto measured =
        measureHammerFiles ({ request.files.begin(), request.files.end() }, request.pointsFile.string(),
                            estimatorNamed (request.estimator), request.hammer);
    return { measured.responses, measured.coherence, {}, {}, measured, measured.remarks, {} };
}
} // namespace

FrfFields fieldsByKind (FrfRequest& request)
{
    constexpr double milliseconds = 1000;
    constexpr int mostChannels = 16383;
    FrfFields kinds;
    kinds.common = {
        Field (
            "files", &request.files,
            "Sheet of the excitation (excitation.json) and WAV files, each of one or more points, in the order of the "
            "points; or recordings of a hammer alone")
            .as ("recordings")
            .required()
            .positional(),
        Field ("", OptionalSheet { &request.sheet }, "Played excitation: excitation.json, or the result of excite")
            .as ("sheet")
            .by ("the first file, or a hammer was used"),
        Field ("--points", &request.pointsFile, "CSV of the points, x and y in mm")
            .written ("FILE")
            .by ("1 mm apart on a line, or as the files of a hammer say"),
        Field ("--estimator", &request.estimator, "Estimator for noise: h1, h2 or their geometric mean hv")
            .oneOf ({ "h1", "h2", "hv" }),
    };
    kinds.ofExcitation = fields (request.sensor);
    append (kinds.ofExcitation,
            { Field ("--sync-channel", &request.syncChannel,
                     "Channel with the sync output, counted from 1; 0: none; -1: the last channel")
                  .within (-1, mostChannels),
              Field ("--reference-channel", &request.referenceChannel,
                     "Channel with the measured voltage of the amplifiers, counted from 1; 0: none")
                  .within (0, mostChannels),
              Field ("--reference-full-scale", &request.referenceFullScale,
                     "Voltage at the ceramics for a reference sample of 1, V")
                  .as ("reference_full_scale_V"),
              Field ("--latency-ms", &request.latency, "Latency of the sensors without a sync channel, ms")
                  .in (milliseconds)
                  .within (0, 200) });
    kinds.ofHammer = fields (request.hammer);
    return kinds;
}

std::vector<Field> fields (FrfRequest& request)
{
    auto kinds = fieldsByKind (request);
    append (kinds.common, std::move (kinds.ofExcitation));
    append (kinds.common, std::move (kinds.ofHammer));
    return std::move (kinds.common);
}

bool isOfExcitation (const FrfRequest& request)
{
    return request.sheet || (! request.files.empty() && request.files.front().extension() == ".json");
}

RecordedResponses frf (const FrfRequest& request, const ShowProgress&)
{
    return isOfExcitation (request) ? ofExcitation (request) : ofHammer (request);
}

std::string universalFile (const RecordedResponses& estimated)
{
    return encodeUniversalFile (estimated.hammer ? hammerSets (*estimated.hammer) : responseSets (estimated.responses));
}

ReportPage frfReport (const RecordedResponses& estimated)
{
    if (! estimated.hammer)
        return measurementReport (*estimated.surface, *estimated.sheet);

    const auto& measured = *estimated.hammer;
    return hammerReport (measured.recordings, measured.test, { measured.responses, measured.coherence, {}, {} });
}
} // namespace antinode
