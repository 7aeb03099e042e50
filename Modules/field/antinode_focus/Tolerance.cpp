#include "Tolerance.h"

#include "Detuning.h"
#include "Prediction.h"

#include <antinode_numerics/EvaluatedCases.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace antinode
{
namespace
{
ModalModel realModes (const ModalModel& model)
{
    requireRealModes (model, "tolerance studies");
    return withoutShapes (model);
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

ToleranceStudy::ToleranceStudy (const ModalModel& modelToUse, const FocusDesign& designToUse,
                                const ToleranceOptions& optionsToUse)
    : model (modelToUse), design (designToUse), options (optionsToUse), modes (realModes (modelToUse)),
      wantedPeak (largestTruncated (modelToUse, designToUse, designToUse.moments.front()))
{
}

FocusScore ToleranceStudy::scoreOn (const ModalModel& device) const
{
    const auto states = predictStates (device, design.program, design.program.focusTime);
    return scoreFocus (model, modalVelocities (device, states), design.truncatedField, wantedPeak);
}

FocusScore ToleranceStudy::draw (std::size_t number) const
{
    return scoreOn (detuned (modes, options.spread, drawSeed (options.seed, number)));
}

Tolerance ToleranceStudy::summary (std::vector<FocusScore> draws) const
{
    Tolerance tolerance;
    tolerance.options = options;
    tolerance.known = scoreOn (modes);
    tolerance.draws = std::move (draws);
    tolerance.vScore = scorePercentiles (tolerance.draws, &FocusScore::vScore);
    tolerance.fieldError = scorePercentiles (tolerance.draws, &FocusScore::fieldError);
    tolerance.peakRatio = scorePercentiles (tolerance.draws, &FocusScore::peakRatio);
    tolerance.causes = toleranceCauses (model, design, options.spread);
    return tolerance;
}

Tolerance evaluateTolerance (const ModalModel& model, const FocusDesign& design, const ToleranceOptions& options,
                             const std::function<void (double)>& progress)
{
    const ToleranceStudy study (model, design, options);
    const std::function<FocusScore (std::size_t)> draw = [&] (std::size_t number) { return study.draw (number); };
    return study.summary (evaluateCases (static_cast<std::size_t> (options.draws), draw,
                                         [&] (std::uint64_t done)
                                         { progress (static_cast<double> (done) / options.draws); }));
}
} // namespace antinode
