#include "DriftEstimate.h"

#include <antinode_base/InputError.h>
#include <antinode_numerics/DenseKernels.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace antinode
{
namespace
{
constexpr double largestDampingRatio = 0.9;

void requireSpread (const DriftSpread& spread)
{
    for (const auto value : { spread.drift, spread.driftRate, spread.frequency, spread.frequencyRate, spread.damping,
                              spread.dampingRate, spread.gain, spread.gainRate, spread.feedthrough, spread.delay })
        if (! (value >= 0 && value <= 1))
            throw InputError ("drift", "has a relative deviation outside 0 to 1");
}

/** A lower triangle L with L L' = a, also where a is singular: parameters without a deviation stay as they are. */
Eigen::MatrixXd factorOf (Eigen::MatrixXd covariance)
{
    // Far below any deviation, and above rounding.
    constexpr double floor = 1e-12;
    covariance.diagonal().array() += floor * covariance.diagonal().maxCoeff() + std::numeric_limits<double>::min();
    factorLower (covariance);
    return covariance.triangularView<Eigen::Lower>();
}

/** Adds what is common to all frequencies and what each has of its own. */
void addFrequencies (Eigen::MatrixXd& covariance, const DriftLayout& layout, double common, double own)
{
    auto block = covariance.topLeftCorner (layout.modes, layout.modes);
    block.array() += common * common;
    block.diagonal().array() += own * own;
}

void addDampingAndGains (Eigen::MatrixXd& covariance, const DriftLayout& layout, double damping, double gain)
{
    auto diagonal = covariance.diagonal();
    diagonal.segment (layout.damping (0), layout.modes).array() += damping * damping;
    diagonal.segment (layout.gain (0, 0), layout.sensors * layout.modes).array() += gain * gain;
}
} // namespace

DriftLayout driftLayout (const ModalModel& model, Eigen::Index sensors)
{
    return { model.modes(), sensors, model.actuators() };
}

DriftEstimate startOfDrift (const DriftLayout& layout, const DriftSpread& spread)
{
    requireSpread (spread);
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero (layout.size(), layout.size());
    addFrequencies (covariance, layout, spread.drift, spread.frequency);
    addDampingAndGains (covariance, layout, spread.damping, spread.gain);
    covariance.diagonal().segment (layout.feedthrough (0, 0), layout.sensors * layout.ceramics).array() +=
        spread.feedthrough * spread.feedthrough;
    covariance.diagonal().tail (layout.sensors).array() += spread.delay * spread.delay;
    return { Eigen::VectorXd::Zero (layout.size()), factorOf (std::move (covariance)) };
}

DriftEstimate afterTime (DriftEstimate estimate, const DriftLayout& layout, const DriftSpread& spread, double elapsed)
{
    const auto root = std::sqrt (elapsed);
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero (layout.size(), layout.size());
    addGram (covariance, 1, estimate.factor);
    covariance.triangularView<Eigen::StrictlyUpper>() = covariance.transpose();
    addFrequencies (covariance, layout, spread.driftRate * root, spread.frequencyRate * root);
    addDampingAndGains (covariance, layout, spread.dampingRate * root, spread.gainRate * root);
    estimate.factor = factorOf (std::move (covariance));
    return estimate;
}

DriftEstimate afterJump (DriftEstimate estimate, const DriftLayout& layout, const DriftSpread& spread, double logarithm,
                         double left)
{
    estimate.values.head (layout.modes).array() += logarithm;
    auto start = spread;
    start.drift = left;
    estimate.factor = startOfDrift (layout, start).factor;
    return estimate;
}

DriftEstimate estimateOfFirst (const DriftEstimate& estimate, const DriftLayout& layout, const ModalModel& nominal,
                               const std::vector<Sensor>& sensors, Eigen::Index count)
{
    const DriftLayout few { count, layout.sensors, layout.ceramics };
    std::vector<Eigen::Index> rows;
    const auto add = [&rows] (Eigen::Index first, Eigen::Index number)
    {
        for (Eigen::Index i = 0; i < number; ++i)
            rows.push_back (first + i);
    };
    add (layout.frequency (0), count);
    add (layout.damping (0), count);

    for (Eigen::Index m = 0; m < layout.sensors; ++m)
        add (layout.gain (m, 0), count);

    add (layout.feedthrough (0, 0), layout.sensors * layout.ceramics + layout.sensors);
    DriftEstimate first { estimate.values (rows), estimate.factor (rows, Eigen::all) };
    const auto above = layout.modes - count;
    const Eigen::VectorXd compliances = nominal.angularFrequencies.tail (above).cwiseAbs2().cwiseInverse();

    for (Eigen::Index m = 0; m < layout.sensors; ++m)
        first.values.segment (few.feedthrough (m, 0), few.ceramics) +=
            nominal.participation.bottomRows (above).transpose()
            * sensors[static_cast<std::size_t> (m)].shapes.tail (above).transpose().cwiseProduct (compliances);

    return first;
}

ModalModel driftedModel (const ModalModel& nominal, const DriftLayout& layout, const Eigen::VectorXd& values)
{
    auto model = nominal;
    model.angularFrequencies.array() *= values.segment (layout.frequency (0), layout.modes).array().exp();
    model.dampingRatios =
        (model.dampingRatios.array() * values.segment (layout.damping (0), layout.modes).array().exp())
            .min (largestDampingRatio);
    return model;
}

Eigen::VectorXd frequencyChanges (const DriftEstimate& estimate, const DriftLayout& layout, Eigen::Index modes)
{
    const auto followed = layout.modes;
    const Eigen::VectorXd values = estimate.values.head (followed);
    const Eigen::VectorXd weights =
        estimate.factor.topRows (followed).rowwise().squaredNorm().cwiseMax (1e-24).cwiseInverse();
    Eigen::VectorXd changes = Eigen::VectorXd::Constant (modes, weights.dot (values) / weights.sum());
    changes.head (std::min (modes, followed)) = values.head (std::min (modes, followed));
    return changes;
}

ModalModel retunedModel (const ModalModel& nominal, const DriftEstimate& estimate, const DriftLayout& layout)
{
    const auto followed = std::min (layout.modes, nominal.modes());
    auto model = nominal;
    model.angularFrequencies.array() *= frequencyChanges (estimate, layout, nominal.modes()).array().exp();
    model.dampingRatios.head (followed) = (nominal.dampingRatios.head (followed).array()
                                           * estimate.values.segment (layout.damping (0), followed).array().exp())
                                              .min (largestDampingRatio);
    return model;
}
} // namespace antinode
