#include "WaveformsTolerance.h"

#include "PerformedWaveforms.h"
#include "PlayedTracks.h"

#include <antinode_base/MessageText.h>
#include <antinode_focus/Detuning.h>
#include <antinode_numerics/Fourier.h>
#include <antinode_numerics/ParallelFor.h>
#include <antinode_tracks/TrackWork.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <functional>
#include <utility>

namespace antinode
{
namespace
{
/** With all fingers in the responses: the surface has those too that the design does not know. */
WaveformsDescription withAllFingers (WaveformsDescription description)
{
    const auto know = [] (TouchedPoint& point)
    {
        if (point.finger)
            point.finger->isKnown = true;
    };

    for (auto& track : description.tracks)
        know (track.point);

    for (auto& point : description.silent)
        know (point);

    return description;
}

/** The lines of voltages, lines x ceramics, for transforms of a problem: its first sample is span.lead before the
    trigger, and voltages before it stand at the end of the period. */
Eigen::MatrixXcd linesOf (const SampledVoltages& voltages, const TrackSpan& span)
{
    const auto length = span.length * span.factor;
    const auto first = std::llround (voltages.firstTime * voltages.playback.sampleRate) + span.lead * span.factor;
    Eigen::MatrixXcd lines (span.length / 2 + 1, voltages.values.rows());

    for (Eigen::Index i = 0; i < voltages.values.rows(); ++i)
    {
        Eigen::VectorXd period = Eigen::VectorXd::Zero (length);

        for (Eigen::Index n = 0; n < voltages.values.cols(); ++n)
            period[((n + first) % length + length) % length] += voltages.values (i, n);

        lines.col (i) = forwardFourier (period, length).head (lines.rows()) / static_cast<double> (span.factor);
    }

    return lines;
}

/** The motion at the touched points: points x length, m. */
Eigen::MatrixXd motionOf (const TrackProblem& problem, const Eigen::MatrixXcd& voltages)
{
    const auto& [span, moving, responses, wanted] = problem;
    Eigen::MatrixXd motion = Eigen::MatrixXd::Zero (wanted.cols(), span.length);

    for (Eigen::Index node = 0; node < responses.points; ++node)
    {
        Eigen::VectorXcd lines = Eigen::VectorXcd::Zero (voltages.rows());

        for (Eigen::Index i = 0; i < responses.actuators; ++i)
            lines += responses.values.col (node + responses.points * i).cwiseProduct (voltages.col (i));

        const auto own = inverseFourier (lines, span.length);

        if (moving.points.empty())
            motion.row (node) = own.transpose();
        else
            motion.row (moving.points[static_cast<std::size_t> (node)]) +=
                own.cwiseProduct (moving.weights.col (node)).transpose();
    }

    return motion;
}

/** Levels and suppression of all points on one device. */
std::pair<Eigen::RowVectorXd, Eigen::RowVectorXd> answerOf (const ModalModel& device, const TrackDesign& design,
                                                            const WaveformsDescription& description,
                                                            const SkinThreshold& threshold)
{
    TrackSettings settings;
    settings.sampleRate = design.voltages.playback.sampleRate;
    settings.threshold = threshold;
    const auto problem = trackProblem (device, description, settings);
    const auto& span = problem.span;
    PlayedTracks played;
    played.sampleRate = span.rate;
    played.trigger = span.lead;
    played.displacements = motionOf (problem, linesOf (design.voltages, span));
    const auto scores = scoreTracks (played, problem.wanted.middleRows (span.lead, span.wanted), description.band);
    const auto points = played.displacements.rows();
    std::pair<Eigen::RowVectorXd, Eigen::RowVectorXd> answer (points, points);

    constexpr Eigen::Index closer = 2; // so that peaks lie on samples, as those of modes that are played
    const auto motions = finer (played.displacements.transpose(), closer);
    const auto rate = closer * span.rate;

    for (Eigen::Index p = 0; p < points; ++p)
    {
        answer.first[p] = sensationLevel (feltAmount (feltDisplacement (motions.col (p), rate, threshold), rate));
        answer.second[p] = scores.suppression (static_cast<std::size_t> (p));
    }

    return answer;
}

Percentiles percentilesOf (const Eigen::VectorXd& draws)
{
    return computePercentiles ({ draws.begin(), draws.end() });
}
} // namespace

WaveformsTolerance waveformsTolerance (const ModalModel& judge, const TrackDesign& design,
                                       const SkinThreshold& threshold, const ToleranceOptions& options,
                                       const ShowProgress& progress)
{
    requireRealModes (judge, "tolerance studies");
    const auto description = withAllFingers (design.description);
    using Answer = std::pair<Eigen::RowVectorXd, Eigen::RowVectorXd>;
    const std::function<Answer (std::size_t)> answerOn = [&] (std::size_t number) {
        return answerOf (detuned (judge, options.spread, drawSeed (options.seed, number)), design, description,
                         threshold);
    };
    const auto show = [&] (std::uint64_t done)
    {
        if (progress)
            progress ("Drawing devices", static_cast<double> (done) / options.draws);
    };
    const auto answers = evaluateCases (static_cast<std::size_t> (options.draws), answerOn, show);
    WaveformsTolerance tolerance { options, {}, {} };
    tolerance.levels.resize (options.draws, answers.front().first.size());
    tolerance.suppression.resize (options.draws, answers.front().first.size());

    for (Eigen::Index draw = 0; draw < options.draws; ++draw)
    {
        const auto& [levels, suppression] = answers[static_cast<std::size_t> (draw)];
        tolerance.levels.row (draw) = levels;
        tolerance.suppression.row (draw) = suppression;
    }

    return tolerance;
}

nlohmann::ordered_json toleranceToJson (const WaveformsDescription& description, const WaveformsTolerance& tolerance)
{
    constexpr double percent = 100;
    const auto& [spread, draws, seed] = tolerance.options;
    nlohmann::ordered_json json { { "draws", draws },
                                  { "seed", seed },
                                  { "frequency_percent", percent * spread.frequency },
                                  { "damping_percent", percent * spread.damping },
                                  { "participation_percent", percent * spread.participation },
                                  { "drift_percent", percent * spread.drift },
                                  { "percentiles", tolerancePercents } };

    for (Eigen::Index p = 0; p < tolerance.levels.cols(); ++p)
        json["fingers"].push_back ({ { "name", fingerName (description, static_cast<std::size_t> (p)) },
                                     { "level_dB_SL", percentilesOf (tolerance.levels.col (p)) },
                                     { "suppression_dB", percentilesOf (tolerance.suppression.col (p)) } });

    return json;
}

std::string toleranceToCsv (const WaveformsTolerance& tolerance)
{
    std::string text = "device";

    for (const auto* const heading : { "level_dB_SL", "suppression_dB" })
        for (Eigen::Index p = 0; p < tolerance.levels.cols(); ++p)
            text += formatted (",%s_%td", heading, p + 1);

    text += "\n";

    for (Eigen::Index draw = 0; draw < tolerance.levels.rows(); ++draw)
    {
        text += std::to_string (draw + 1);

        for (const auto* const numbers : { &tolerance.levels, &tolerance.suppression })
            for (const auto number : numbers->row (draw))
                text += formatted (",%.9g", number);

        text += "\n";
    }

    return text;
}

std::string toleranceInWords (const WaveformsDescription& description, const WaveformsTolerance& tolerance)
{
    auto text = formatted ("  %-30s", "percentile");
    const auto addRow = [&] (const std::string& name, const Percentiles& values)
    {
        text += formatted ("\n  %-30s", name.c_str());

        for (const auto value : values)
            text += formatted (" %8.1f", value);
    };

    for (const auto percent : tolerancePercents)
        text += formatted (" %8.0f", percent);

    for (Eigen::Index p = 0; p < tolerance.levels.cols(); ++p)
    {
        const auto name = fingerName (description, static_cast<std::size_t> (p));
        addRow (name + ", felt/dB SL", percentilesOf (tolerance.levels.col (p)));
        addRow (name + ", error/dB", percentilesOf (tolerance.suppression.col (p)));
    }

    return text + "\n";
}
} // namespace antinode
