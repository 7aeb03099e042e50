#include "EstimatedFiles.h"

#include <antinode_base/InputError.h>
#include <antinode_responses/PointsFile.h>
#include <antinode_responses/UniversalResponses.h>
#include <antinode_text/WaveReader.h>
#include <antinode_universal/UniversalFile.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
/** The roles of the channels of a recording, counted from 0; -1: none. */
struct ChannelRoles
{
    Eigen::Index sync = -1, reference = -1;
    std::vector<Eigen::Index> sensors;
};

ChannelRoles findRoles (const RecordingOptions& options, Eigen::Index channels, const std::string& file)
{
    ChannelRoles roles;
    roles.sync = options.syncChannel < 0 ? channels - 1 : options.syncChannel - 1;
    roles.reference = options.referenceChannel - 1;

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

PlacedRecording placed (const RecordingOptions& options, const ExcitationSheet& sheet, const std::string& file)
{
    PlacedRecording recording { readWaveFile (file), {}, 0, file };
    const auto rate = sheet.excitation.settings.sampleRate;

    if (recording.wave.sampleRate != rate)
        throw InputError (file, "has a sample rate of " + std::to_string (std::lround (recording.wave.sampleRate))
                                    + " Hz; allowed: " + std::to_string (std::lround (rate))
                                    + " Hz, the rate of the excitation");

    recording.roles = findRoles (options, recording.wave.samples.rows(), file);

    if (recording.roles.sync >= 0)
        recording.first = findOnset (recording.wave.samples.row (recording.roles.sync), rate, file);

    return recording;
}

RunRecording extractRun (const PlacedRecording& recording, const RecordingOptions& options,
                         const Excitation& excitation, Eigen::Index ceramic)
{
    const auto& samples = recording.wave.samples;
    const auto first = recording.first + ceramic * excitation.runLength;
    const auto count = std::min (excitation.runLength, samples.cols() - first);

    if (count < excitation.signal.size())
        throw InputError (recording.file, "ends before ceramic " + std::to_string (ceramic + 1) + " of "
                                              + std::to_string (excitation.ceramics()) + " has finished its run");

    RunRecording run;
    run.sensors = samples (recording.roles.sensors, Eigen::seqN (first, count)) * options.sensor.fullScaleVelocity();

    if (recording.roles.sync >= 0)
        run.sync = samples.row (recording.roles.sync).segment (first, count);

    if (recording.roles.reference >= 0)
        run.reference = samples.row (recording.roles.reference).segment (first, count) * options.referenceFullScale;

    return run;
}

void analyse (SurfaceMeasurement& measurement, const PlacedRecording& recording, const RecordingOptions& options,
              const Excitation& excitation, Eigen::Index firstPoint)
{
    RunAnalysisSettings settings;
    settings.latency = options.latency / 1000 * excitation.settings.sampleRate;
    settings.estimator = options.estimator;

    for (Eigen::Index ceramic = 0; ceramic < excitation.ceramics(); ++ceramic)
        try
        {
            place (measurement, ceramic, firstPoint,
                   analyseRun (excitation, ceramic, extractRun (recording, options, excitation, ceramic), settings));
        }
        catch (const InputError& error)
        {
            throw InputError (recording.file + ": ceramic " + std::to_string (ceramic + 1), error.what());
        }
}

/** The positions in the options' file, or 1 mm apart on a line. */
Eigen::MatrixX2d readPlaces (const RecordingOptions& options, Eigen::Index sensors)
{
    if (options.pointsFile.empty())
    {
        Eigen::MatrixX2d places = Eigen::MatrixX2d::Zero (sensors, 2);
        places.col (0) = Eigen::VectorXd::LinSpaced (sensors, 0, 1e-3 * static_cast<double> (sensors - 1));
        return places;
    }

    auto places = readPointsFile (options.pointsFile);

    if (places.rows() != sensors)
        throw InputError (options.pointsFile, "has " + std::to_string (places.rows()) + " points; allowed: "
                                                  + std::to_string (sensors) + ", as in the recordings");

    return places;
}
} // namespace

ResponseEstimator estimatorNamed (const std::string& word)
{
    return word == "h2" ? ResponseEstimator::h2 : word == "hv" ? ResponseEstimator::hv : ResponseEstimator::h1;
}

SurfaceMeasurement estimateResponses (const ExcitationSheet& sheet, const RecordingOptions& options)
{
    if (options.files.empty())
        throw InputError ("frf", "has no recording; allowed: the sheet and WAV files");

    if (! (options.sensor.sensitivity > 0))
        throw InputError ("--sensitivity-mm-s-per-v", "is missing; give the sensitivity of the sensor in mm/s per V");

    std::vector<Eigen::Index> counts;
    Eigen::Index sensors = 0;

    // Which point is whose is known only when all files' channels are counted; they are too large to be kept.
    for (const auto& file : options.files)
    {
        counts.push_back (
            static_cast<Eigen::Index> (findRoles (options, readWaveFile (file).samples.rows(), file).sensors.size()));
        sensors += counts.back();
    }

    auto measurement = unmeasured (sheet.excitation, sheet.ceramics, readPlaces (options, sensors));
    Eigen::Index first = 0;

    for (std::size_t i = 0; i < counts.size(); first += counts[i++])
        analyse (measurement, placed (options, sheet, options.files[i]), options, sheet.excitation, first);

    return measurement;
}

std::string measurementText (const SurfaceMeasurement& measurement)
{
    return encodeUniversalFile (responseSets (measurement.responses));
}
} // namespace antinode
