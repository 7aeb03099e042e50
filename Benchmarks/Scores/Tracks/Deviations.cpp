#include "ScoreTools.h"

#include <antinode_fingers/LoadedModel.h>
#include <antinode_learning/RecordingDelays.h>
#include <antinode_numerics/Fourier.h>
#include <antinode_numerics/KaiserSinc.h>
#include <antinode_numerics/Statistics.h>
#include <antinode_render/PlayedTracks.h>
#include <antinode_tracks/TrackSolver.h>
#include <antinode_tracks/TrackWork.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>

namespace antinode::scores
{
namespace
{
/** The suppression of a design for some fingers on the surface with others. */
double withFingers (const Device& device, WaveformsDescription description, const std::vector<Finger>& designed,
                    const std::vector<Finger>& real)
{
    if (! designed.empty())
        description.tracks[0].point.finger = designed[0];

    for (std::size_t p = 1; p < designed.size(); ++p)
        description.silent[p - 1].finger = designed[p];

    const auto design = designTracks (device.known, description, usualSettings());
    return worstBystander (judged (loadedModel (device.judge, real), design), &TrackScores::suppression);
}

/** The suppression of a design from responses that were measured at the points with the fingers on: noise of 1 % of
    their RMS in the band at every line, and what is not worth its volts ten times as much as usual. */
double withMeasuredResponses (const Device& device, const WaveformsDescription& description,
                              const std::vector<Finger>& real, int seed)
{
    constexpr double noise = 0.01, softer = 100;
    const auto work = trackWork (device.known, description, usualSettings());
    const auto& span = work.span;
    std::vector<SurfaceLoad> loads;

    for (const auto& finger : real)
        loads.push_back ({ contactShapes (device.judge, finger), finger.mass, finger.damping, finger.stiffness });

    auto measured =
        pointResponses (device.judge, touchedShapes (device.judge, description), loads, span.rate, span.length);
    const auto line = [&] (double frequency)
    { return static_cast<Eigen::Index> (frequency * static_cast<double> (span.length) / span.rate); };
    const auto first = line (description.band.lower), last = line (description.band.upper);
    const auto inBand = measured.values.middleRows (first, last - first);
    const auto deviation = noise * std::sqrt (inBand.cwiseAbs2().mean() / 2);
    RandomNumbers random (static_cast<std::uint64_t> (seed));
    const auto lines = measured.values.rows(), columns = measured.values.cols();
    measured.values.real() += deviation * random.normal (lines * columns).reshaped (lines, columns);
    measured.values.imag() += deviation * random.normal (lines * columns).reshaped (lines, columns);
    WindowedResponses responses (std::move (measured), span.window, softer * work.responses.compliance());
    const auto solution = solveTracks (responses, work.wanted);
    TrackDesign design;
    design.description = description;
    design.wanted = wantedAsPlayed (device.known, description, usualSettings());
    design.voltages = { { Reconstruction::bandLimited, work.sampleRate },
                        -static_cast<double> (span.lead + kaiserSincHalfWidth) / span.rate,
                        interpolated (solution.voltages, span.factor).transpose() };
    return worstBystander (judged (loadedModel (device.judge, real), design), &TrackScores::suppression);
}

/** A surface whose modes differ from those of a model, evenly up to these shares. */
ModalModel differing (ModalModel model, int seed)
{
    constexpr double frequency = 0.0025, damping = 0.1, participation = 0.05;
    RandomNumbers random (static_cast<std::uint64_t> (seed));
    const auto factors = [&] (Eigen::Index count, double deviation)
    {
        Eigen::ArrayXd result (count);

        for (auto& factor : result)
            factor = 1 + deviation * (2 * random.uniform() - 1);

        return result;
    };
    model.angularFrequencies.array() *= factors (model.modes(), frequency);
    model.dampingRatios.array() *= factors (model.modes(), damping);

    for (Eigen::Index k = 0; k < model.modes(); ++k)
        model.participation.row (k).array() *= factors (model.actuators(), participation).transpose();

    return model;
}

/** As ceramics distort them: by so much of the largest voltage of each. */
SampledVoltages distorted (SampledVoltages voltages, double cubic)
{
    for (Eigen::Index i = 0; i < voltages.values.rows(); ++i)
        if (const auto largest = voltages.values.row (i).cwiseAbs().maxCoeff(); largest > 0)
            voltages.values.row (i).array() *= 1 + cubic * (voltages.values.row (i).array() / largest).square();

    return voltages;
}

/** Signals that come later, also by parts of a sample. */
Eigen::MatrixXd later (const Eigen::MatrixXd& signals, double samples)
{
    constexpr double silence = 256; // samples, before the signal comes round again
    const auto length = quickLength (static_cast<double> (signals.cols()) + samples + silence);
    const auto turn = -2 * std::numbers::pi * samples / static_cast<double> (length);
    Eigen::MatrixXd late (signals.rows(), signals.cols());

    for (Eigen::Index p = 0; p < signals.rows(); ++p)
    {
        auto lines = forwardFourier (signals.row (p).transpose(), length);

        for (Eigen::Index k = 0; k < lines.size(); ++k)
            lines[k] *= std::polar (1.0, turn * static_cast<double> (k));

        late.row (p) = inverseFourier (lines, length).head (signals.cols()).transpose();
    }

    return late;
}

Eigen::MatrixXd whiteNoise (const Eigen::MatrixXd& like, double deviation, RandomNumbers& random)
{
    return deviation * random.normal (like.size()).reshaped (like.rows(), like.cols());
}

/** Noise of a thousandth of the level, white to half of the rate. */
RecordedPass recorded (const TrackDesign& design, const PlayedTracks& played, int seed)
{
    constexpr double noise = 1e-3;
    RandomNumbers random (static_cast<std::uint64_t> (seed));
    RecordedPass pass { design.voltages, played.displacements };
    pass.displacements +=
        whiteNoise (pass.displacements, noise * design.description.tracks[0].events[0].level.value, random);
    return pass;
}

/** As a bench records: white noise 40 dB below the loudest channel (RMS of the whole recording), and a latency of 2 to
    20 ms that nobody says, which is looked for. */
RecordedPass recordedByBench (const ModalModel& known, const TrackDesign& design, const PlayedTracks& played, int seed)
{
    constexpr double noise = 0.01, shortest = 0.002, longest = 0.02, lookedFor = 0.03;
    RandomNumbers random (static_cast<std::uint64_t> (seed));
    const auto latency = shortest + (longest - shortest) * random.uniform();
    const auto& moved = played.displacements;
    const auto loudest = moved.rowwise().norm().maxCoeff() / std::sqrt (static_cast<double> (moved.cols()));
    const Eigen::MatrixXd signals =
        later (moved, latency * played.sampleRate) + whiteNoise (moved, noise * loudest, random);
    const auto expected = predictedDisplacements (known, design.description, design.voltages, 0);
    return { design.voltages, alignedWith (signals, expected, played.sampleRate, lookedFor).signals };
}
} // namespace

void fingersTable (const Device& device, int layouts)
{
    Spread ignored, nominal, known, measured;

    for (int seed = 1; seed <= layouts; ++seed)
    {
        const auto description = layout (device.known.surface, 3, "Gabor", seed);
        RandomNumbers random (static_cast<std::uint64_t> (1000 + seed));
        const auto about = [&] (double value) { return value * (0.5 + random.uniform()); };
        std::vector<Finger> same, real;

        for (const auto& point : touchedPoints (description))
        {
            same.push_back (builtInFinger ("medium", point.x, point.y));
            auto finger = same.back();
            finger.mass = about (finger.mass);
            finger.damping = about (finger.damping);
            finger.stiffness = about (finger.stiffness);
            finger.x += 0.003 * (2 * random.uniform() - 1);
            finger.y += 0.003 * (2 * random.uniform() - 1);
            real.push_back (finger);
        }

        ignored.values.push_back (withFingers (device, description, {}, real));
        nominal.values.push_back (withFingers (device, description, same, real));
        known.values.push_back (withFingers (device, description, same, same));
        measured.values.push_back (withMeasuredResponses (device, description, real, seed));
    }

    std::printf ("| %s | %.0f / %.0f | %.0f / %.0f | %.0f / %.0f | %.0f / %.0f |\n", device.name.c_str(),
                 ignored.middle(), ignored.worst(), nominal.middle(), nominal.worst(), known.middle(), known.worst(),
                 measured.middle(), measured.worst());
}
void passesTable (const Device& device, int layouts, bool isBench)
{
    const double cubic = isBench ? 0.01 : 0;
    constexpr int passes = 4;
    constexpr double recording = 1; // s after the last voltage
    const auto settings = usualSettings();

    for (const std::string signal : { "click", "Gabor", "AM", "music" })
    {
        std::array<Spread, passes> found;
        int worse = 0;

        for (int seed = 1; seed <= layouts; ++seed)
        {
            const auto description = layout (device.known.surface, 3, signal, seed);
            const auto real = differing (device.judge, seed);
            std::vector<RecordedPass> records;
            std::vector<double> suppressions;

            for (int pass = 0; pass < passes; ++pass)
            {
                const auto shift =
                    pass > 0 ? correctionFrom (device.known, description, settings, records).shift : TrackShift {};
                const auto design = designTracks (device.known, description, settings, {}, shift);
                const auto played = playTracks (real, description, distorted (design.voltages, cubic), recording);
                const auto noiseSeed = 100 * seed + pass;
                records.push_back (isBench ? recordedByBench (device.known, design, played, noiseSeed)
                                           : recorded (design, played, noiseSeed));
                suppressions.push_back (
                    worstBystander (scoreTracks (played, design.wanted, description.band), &TrackScores::suppression));
                const auto best = correctionFrom (device.known, description, settings, records).best;
                found[static_cast<std::size_t> (pass)].values.push_back (suppressions[best]);
                worse += suppressions[best] > suppressions[0] ? 1 : 0;
            }
        }

        std::printf ("| %s | %s |", device.name.c_str(), signal.c_str());

        for (const auto& pass : found)
            std::printf (" %.0f / %.0f |", pass.middle(), pass.worst());

        std::printf (" %d |\n", worse);
        std::fflush (stdout);
    }
}
} // namespace antinode::scores
