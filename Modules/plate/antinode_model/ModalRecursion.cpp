#include "ModalRecursion.h"

#include <antinode_base/InputError.h>
#include <antinode_numerics/KaiserSinc.h>
#include <antinode_numerics/Quadrature.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antinode
{
namespace
{
constexpr double highestModePerRate = 64;

void requireUsable (const ModalModel& model, double sampleRate)
{
    if (! std::isfinite (sampleRate) || sampleRate <= 0)
        throw InputError ("sample rate", "must be finite and positive to play samples");

    const auto xi = model.dampingRatios.array();
    const auto omega = model.angularFrequencies.array();
    const auto sane = xi.size() == omega.size() && xi.isFinite().all() && omega.isFinite().all() && (xi > 0).all()
                      && (xi < 1).all() && (omega > 0).all();

    if (! sane)
        throw InputError ("device '" + model.name + "'",
                          "every mode needs a finite frequency above 0 and a damping ratio between 0 and 1");

    if ((omega > highestModePerRate * 2 * std::numbers::pi * sampleRate).any())
        throw InputError ("sample rate",
                          "is less than 1/64 of the highest mode's frequency; take a higher rate or fewer modes");
}

/** K (x - j) at the nodes x of one sample interval (rows), for the samples in the order of the taps (columns). */
Eigen::MatrixXd interpolationAt (const Eigen::VectorXd& nodes, Reconstruction reconstruction)
{
    if (reconstruction == Reconstruction::zeroOrderHold)
    {
        // The sample before is held throughout; the newest one acts from now on only.
        Eigen::MatrixXd hold = Eigen::MatrixXd::Zero (nodes.size(), 2);
        hold.col (0).setOnes();
        return hold;
    }

    Eigen::MatrixXd kernel (nodes.size(), 2 * kaiserSincHalfWidth);

    for (Eigen::Index tap = 0; tap < kernel.cols(); ++tap)
        for (Eigen::Index i = 0; i < nodes.size(); ++i)
            kernel (i, tap) = kaiserSinc (nodes[i] - static_cast<double> (tap - (kaiserSincHalfWidth - 1)));

    return kernel;
}
} // namespace

ModalRecursion modalRecursion (const ModalModel& model, Playback playback)
{
    requireUsable (model, playback.sampleRate);
    const auto interval = 1 / playback.sampleRate;
    const Eigen::ArrayXd decay = decayRates (model).array() * interval;
    const Eigen::ArrayXd turn = dampedFrequencies (model).array() * interval;

    const auto largestPhase = turn.size() > 0 ? turn.maxCoeff() : 0.0;
    const auto panels = std::max (1, static_cast<int> (std::ceil (largestPhase / std::numbers::pi)));
    const auto quadrature = gaussLegendre (16, panels);
    const auto kernel = interpolationAt (quadrature.nodes, playback.reconstruction);

    // T w_i e^{sT (1 - x_i)}: modes x nodes
    const Eigen::RowVectorXd rest = 1 - quadrature.nodes.transpose().array();
    const Eigen::ArrayXXd phase = (turn.matrix() * rest).array();
    const Eigen::ArrayXXd size = (-(decay.matrix() * rest).array()).exp()
                                 * (interval * quadrature.weights.transpose().array()).replicate (turn.size(), 1);

    ModalRecursion recursion;
    recursion.transitionReal = (-decay).exp() * turn.cos();
    recursion.transitionImaginary = (-decay).exp() * turn.sin();
    recursion.tapsReal = ((size * phase.cos()).matrix() * kernel).array();
    recursion.tapsImaginary = ((size * phase.sin()).matrix() * kernel).array();
    recursion.latency = playback.reconstruction == Reconstruction::bandLimited ? kaiserSincHalfWidth - 1 : 0;
    return recursion;
}

void requirePlayable (const ModalModel& model, const Eigen::MatrixXd& probeShapes)
{
    const auto coordinates = model.coordinates();

    if (model.participation.rows() != coordinates || ! model.participation.allFinite())
        throw InputError ("device '" + model.name + "'", "needs one row of finite participations for every mode");

    if (probeShapes.cols() != coordinates || ! probeShapes.allFinite())
        throw InputError ("probes", "need one finite shape value for every mode");
}
} // namespace antinode
