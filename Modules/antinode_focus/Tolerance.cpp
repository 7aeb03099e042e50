#include "Tolerance.h"

#include "Detuning.h"
#include "Prediction.h"

#include <antinode_numerics/ParallelFor.h>

#include <algorithm>
#include <cmath>
#include <thread>

namespace antinode
{
namespace
{
/** A seed for each draw (SplitMix64, Steele et al. 2014): those of neighbouring seeds have nothing in common. */
std::uint64_t seedForDraw (std::uint64_t seed, int draw)
{
    constexpr std::uint64_t odd = 0x9e3779b97f4a7c15, first = 0xbf58476d1ce4e5b9, second = 0x94d049bb133111eb;
    const auto mix = [] (std::uint64_t z)
    {
        z = (z ^ (z >> 30)) * first;
        z = (z ^ (z >> 27)) * second;
        return z ^ (z >> 31);
    };
    return mix (mix (seed + odd) + odd * static_cast<std::uint64_t> (draw));
}

FocusScore scoreOn (const ModalModel& modes, const ModalModel& model, const FocusDesign& design,
                    const FieldPeak& wantedPeak)
{
    const auto states = predictStates (modes, design.program, design.program.focusTime);
    return scoreFocus (model, modalVelocities (modes, states), design.truncatedField, wantedPeak);
}

std::vector<FocusScore> drawScores (const ModalModel& model, const FocusDesign& design, const FieldPeak& wantedPeak,
                                    const ToleranceOptions& options, const std::function<void (double)>& progress)
{
    const auto modes = withoutShapes (model);
    std::vector<FocusScore> scores (static_cast<std::size_t> (options.draws));
    const auto caller = std::this_thread::get_id();
    parallelFor (scores.size(),
                 [&] (std::size_t draw)
                 {
                     scores[draw] =
                         scoreOn (detuned (modes, options.spread, seedForDraw (options.seed, static_cast<int> (draw))),
                                  model, design, wantedPeak);

                     if (std::this_thread::get_id() == caller)
                         progress (static_cast<double> (draw + 1) / options.draws);
                 });
    return scores;
}

Percentiles scorePercentiles (const std::vector<FocusScore>& scores, double FocusScore::*member)
{
    std::vector<double> values (scores.size());
    std::transform (scores.begin(), scores.end(), values.begin(),
                    [&] (const FocusScore& score) { return score.*member; });
    return computePercentiles (std::move (values));
}
} // namespace

Percentiles computePercentiles (std::vector<double> values)
{
    constexpr double whole = 100;
    std::sort (values.begin(), values.end());
    Percentiles result {};

    for (std::size_t i = 0; i < result.size(); ++i)
    {
        const auto place = tolerancePercents[i] / whole * static_cast<double> (values.size() - 1);
        const auto below = static_cast<std::size_t> (place);
        const auto above = std::min (below + 1, values.size() - 1);
        result[i] = std::lerp (values[below], values[above], place - std::floor (place));
    }

    return result;
}

Tolerance evaluateTolerance (const ModalModel& model, const FocusDesign& design, const ToleranceOptions& options,
                             const std::function<void (double)>& progress)
{
    requireRealModes (model, "tolerance studies");
    Tolerance tolerance;
    const auto wantedPeak = largestTruncated (model, design, design.moments.front());
    tolerance.options = options;
    tolerance.known = scoreOn (withoutShapes (model), model, design, wantedPeak);
    tolerance.draws = drawScores (model, design, wantedPeak, options, progress);
    tolerance.vScore = scorePercentiles (tolerance.draws, &FocusScore::vScore);
    tolerance.fieldError = scorePercentiles (tolerance.draws, &FocusScore::fieldError);
    tolerance.peakRatio = scorePercentiles (tolerance.draws, &FocusScore::peakRatio);
    tolerance.causes = toleranceCauses (model, design, options.spread);
    return tolerance;
}
} // namespace antinode
