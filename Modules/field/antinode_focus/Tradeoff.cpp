#include "Tradeoff.h"

#include "DesignFocus.h"
#include "FocusScore.h"
#include "LimitUse.h"
#include "Prediction.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/ParallelFor.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <numbers>
#include <utility>

namespace antinode
{
namespace
{
constexpr auto usableError = 0.05;
constexpr std::array triedFolds { 0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0 };
constexpr std::array limitMultiples { 1.02, 1.1, 1.3, 1.6, 2.0, 0.0 };

Eigen::VectorXd evaluateVoltages (const VoltageProgram& program, double time)
{
    Eigen::VectorXd values (program.oscillations.size());

    for (Eigen::Index c = 0; c < values.size(); ++c)
        values[c] = oscillationValue (program.oscillations[static_cast<std::size_t> (c)], time);

    Eigen::VectorXd voltages = program.allocation * values;

    if (program.samples)
        voltages += voltagesAt (*program.samples, time);

    return voltages;
}

/** The focus as it is designed for a point. */
FocusDescription describedFor (FocusDescription focus, const TradeoffPoint& point, const Eigen::VectorXd& decay,
                               double lowerBound)
{
    const auto time = std::min (focus.focusTime, focus.transients.maximumDuration.value_or (focus.focusTime));
    focus.allocation.method = point.method;
    focus.allocation.timesBound.reset();

    if (point.method == AllocationMethod::leastVoltage)
        focus.allocation.timesBound = upToLimits;

    focus.allocation.voltageLimit = point.limitMultiple > 0 ? point.limitMultiple * lowerBound : noVoltageLimit;
    focus.transients.cycles.clear();
    focus.transients.growth.clear();
    focus.transients.brake.reset();
    focus.felt.reset();

    if (point.envelopeFolds > 0)
        for (const auto rate : decay)
            focus.transients.growth.push_back (point.envelopeFolds / (time * rate));

    return focus;
}

void look (TradeoffPoint& point, const ModalModel& model, const FocusDesign& design)
{
    const auto states = predictStates (model, design.program, design.program.focusTime);
    const Eigen::VectorXd field = model.shapes * modalVelocities (model, states);
    const auto score = scoreField (model.surface, field, design.truncatedField);
    point.peakVoltage = peakVoltage (design);
    point.timeInMotion = timeInMotion (model, design.program, design.controlledModes);
    point.vScore = score.vScore;
    point.fieldError = score.fieldError;
}

bool isUsable (const TradeoffPoint& point)
{
    return point.failure.empty() && point.fieldError < usableError;
}

void markFront (std::vector<TradeoffPoint>& points)
{
    for (auto& point : points)
        point.isOnFront = isUsable (point)
                          && std::none_of (points.begin(), points.end(),
                                           [&] (const TradeoffPoint& other) {
                                               return isUsable (other) && other.peakVoltage < point.peakVoltage
                                                      && other.timeInMotion < point.timeInMotion;
                                           });
}

std::vector<TradeoffPoint> plannedPoints()
{
    std::vector<TradeoffPoint> points;

    for (const auto method : { AllocationMethod::paper, AllocationMethod::exact })
        for (const auto folds : triedFolds)
        {
            TradeoffPoint point;
            point.method = method;
            point.envelopeFolds = folds;
            points.push_back (point);
        }

    for (const auto multiple : limitMultiples)
    {
        TradeoffPoint point;
        point.method = AllocationMethod::leastVoltage;
        point.limitMultiple = multiple;
        points.push_back (point);
    }

    return points;
}
/** What a design by a method usually takes, in multiples of the quickest one. */
double expectedCost (AllocationMethod method)
{
    return method == AllocationMethod::leastVoltage ? 5 : 1;
}

/** Collects points from several threads and tells of them. */
class SharedTradeoff
{
public:
    SharedTradeoff (Tradeoff bounds, std::vector<TradeoffPoint> planned,
                    const std::function<void (const Tradeoff&)>& progressToUse)
        : tradeoff (std::move (bounds)), points (std::move (planned)), isDone (points.size()), progress (progressToUse)
    {
        tradeoff.planned = points.size();
    }

    const TradeoffPoint& planned (std::size_t index) const { return points[index]; }

    void add (std::size_t index, TradeoffPoint point)
    {
        const std::lock_guard lock (mutex);
        points[index] = std::move (point);
        isDone[index] = true;

        if (progress)
            progress (soFar());
    }

    Tradeoff soFar()
    {
        double done = 0, whole = 0;
        tradeoff.points.clear();

        for (std::size_t i = 0; i < points.size(); ++i)
        {
            const auto cost = expectedCost (points[i].method);
            whole += cost;

            if (isDone[i])
            {
                done += cost;
                tradeoff.points.push_back (points[i]);
            }
        }

        markFront (tradeoff.points);
        tradeoff.expectedShare = done / whole;
        return tradeoff;
    }

private:
    Tradeoff tradeoff;
    std::vector<TradeoffPoint> points;
    std::vector<bool> isDone;
    const std::function<void (const Tradeoff&)>& progress;
    std::mutex mutex;
};
} // namespace

Tradeoff sweepTradeoff (const ModalModel& device, const FocusDescription& focus, Playback playback,
                        const std::function<void (const Tradeoff&)>& progress, const FindFeltContrast& contrast)
{
    requireRealModes (device, "trade-off studies");
    const auto model = withoutVoltageLimits (device);
    TradeoffPoint first;
    first.method = AllocationMethod::paper;
    const auto start = designFocus (model, describedFor (focus, first, {}, 0), playback);
    const Eigen::VectorXd decay = decayRates (model) (start.controlledModes);
    Tradeoff bounds;
    bounds.lowerBoundVoltage = start.lowerBoundVoltage;
    bounds.lowerBoundGap = start.lowerBoundGap;
    SharedTradeoff shared (std::move (bounds), plannedPoints(), progress);

    parallelFor (plannedPoints().size(),
                 [&] (std::size_t i)
                 {
                     auto point = shared.planned (i);

                     try
                     {
                         const auto design =
                             designFocus (model, describedFor (focus, point, decay, start.lowerBoundVoltage), playback,
                                          DesignExtent::compared);
                         look (point, model, design);

                         if (contrast)
                             point.feltContrast = contrast (design);
                     }
                     catch (const InputError& error)
                     {
                         point.failure = error.what();
                     }

                     shared.add (i, std::move (point));
                 });

    return shared.soFar();
}

double timeInMotion (const ModalModel& model, const VoltageProgram& program, const std::vector<int>& modes)
{
    constexpr auto stepsPerCycle = 10.0;
    requireRealModes (model, "trade-off studies");
    const auto poles = modalPoles (model);
    const auto highest = poles (modes).cwiseAbs().maxCoeff() / (2 * std::numbers::pi);
    const auto steps = std::max (1.0, std::ceil (program.focusTime * highest * stepsPerCycle));
    const auto interval = program.focusTime / steps;
    const Eigen::ArrayXcd turn = (poles.array() * interval).exp();
    const Eigen::ArrayXcd gain = (turn - 1.0) / poles.array();
    Eigen::VectorXcd states = Eigen::VectorXcd::Zero (poles.size());
    std::vector<double> norms;

    for (Eigen::Index n = 0; n < static_cast<Eigen::Index> (steps); ++n)
    {
        checkWatch();
        const Eigen::VectorXd forces =
            model.participation * evaluateVoltages (program, (static_cast<double> (n) + 0.5) * interval);
        states = (turn * states.array() + gain * forces.array()).matrix();
        norms.push_back (modalVelocities (model, states).norm());
    }

    const auto half = 0.5 * norms.back();
    return interval
           * static_cast<double> (
               std::count_if (norms.begin(), norms.end(), [half] (double norm) { return norm > half; }));
}
} // namespace antinode
