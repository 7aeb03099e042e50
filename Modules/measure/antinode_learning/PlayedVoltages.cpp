#include "PlayedVoltages.h"

#include "MovingMode.h"

#include <antinode_numerics/DenseKernels.h>
#include <antinode_numerics/Fourier.h>
#include <antinode_numerics/ParallelFor.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace antinode
{
namespace
{
static_assert (PlayedVoltages::places == MovingMode::places);
constexpr Eigen::Index tail = 256; // samples until a sinc has gone below 1e-3 of a jump

/** Samples until the last voltage. */
Eigen::Index lastPlayed (const Eigen::MatrixXd& voltages)
{
    auto last = voltages.cols();

    while (last > 0 && (voltages.col (last - 1).array() == 0).all())
        --last;

    return last;
}

/** Rows of samples at the places of Gauss and Legendre between them: driven * places x rows. */
Eigen::MatrixXd betweenSamples (const Eigen::MatrixXd& rows, Eigen::Index driven)
{
    constexpr auto places = PlayedVoltages::places;

    Eigen::MatrixXd values (driven * places, rows.rows());
    const auto length = quickLength (static_cast<double> (driven + tail)); // before it comes round again
    FourierTables tables;

    for (Eigen::Index i = 0; i < rows.rows(); ++i)
    {
        const auto spectrum = tables.forward (rows.row (i).head (driven).transpose(), length);

        for (Eigen::Index g = 0; g < places; ++g)
        {
            const auto turn = 2 * std::numbers::pi * ForceTaps::gaussPlaces[static_cast<std::size_t> (g)]
                              / static_cast<double> (length);
            const Eigen::VectorXcd turns = Eigen::VectorXcd::NullaryExpr (
                spectrum.size(), [turn] (Eigen::Index k) { return std::polar (1.0, turn * static_cast<double> (k)); });
            const Eigen::VectorXd between = tables.inverse (spectrum.cwiseProduct (turns), length);

            for (Eigen::Index n = 0; n < driven; ++n)
                values (n * places + g, i) = between[n];
        }
    }

    return values;
}

/** Samples of a motion until it ends. */
template <bool withChanges>
ModeMotion motionUntilRest (MovingMode mode, const Eigen::VectorXd& force, Eigen::Index samples)
{
    constexpr double rest = 1e-20; // of the largest energy
    const auto driven = std::min (samples, force.size() / PlayedVoltages::places);
    ModeMotion motion;
    motion.velocity.resize (samples);

    if constexpr (withChanges)
    {
        motion.byFrequency.resize (samples);
        motion.byDamping.resize (samples);
    }

    double largest = 0;
    Eigen::Index n = 0;

    for (; n < samples && (n < driven || mode.energy() > rest * largest); ++n)
    {
        motion.velocity[n] = mode.velocity();

        if constexpr (withChanges)
        {
            motion.byFrequency[n] = mode.byFrequency();
            motion.byDamping[n] = mode.byDamping();
        }

        largest = std::max (largest, mode.energy());
        mode.advance<withChanges> (n < driven ? force.data() + n * PlayedVoltages::places : nullptr);
    }

    motion.velocity.conservativeResize (n);

    if constexpr (withChanges)
    {
        motion.byFrequency.conservativeResize (n);
        motion.byDamping.conservativeResize (n);
    }

    return motion;
}

void fillUp (Eigen::VectorXd& values, Eigen::Index samples)
{
    const auto before = values.size();
    values.conservativeResize (samples);
    values.tail (samples - before).setZero();
}
} // namespace

PlayedVoltages::PlayedVoltages (const Eigen::MatrixXd& voltages, double sampleRate)
    : PlayedVoltages (voltages, {}, sampleRate)
{
}

PlayedVoltages::PlayedVoltages (const Eigen::MatrixXd& voltages, const Eigen::MatrixXd& cubes, double sampleRate)
    : count (voltages.cols()), driven (std::min (voltages.cols(), lastPlayed (voltages) + tail)),
      values (betweenSamples (voltages, driven)), cubed (betweenSamples (cubes, driven)), rate (sampleRate)
{
}

PlayedVoltages PlayedVoltages::distorted (const Eigen::VectorXd& distortions) const
{
    auto acting = *this;

    if (hasCubes())
        acting.values += cubed * distortions.asDiagonal();

    return acting;
}

Eigen::MatrixXd PlayedVoltages::forces (const Eigen::MatrixXd& participation) const
{
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero (values.rows(), participation.rows());
    addTransposedRight (all, 1, values, participation);
    return all;
}

ModeMotion modeMotionUntilRest (double angularFrequency, double dampingRatio, const Eigen::VectorXd& force,
                                double sampleRate, Eigen::Index samples, bool withChanges)
{
    const MovingMode mode (angularFrequency, dampingRatio, sampleRate);
    return withChanges ? motionUntilRest<true> (mode, force, samples) : motionUntilRest<false> (mode, force, samples);
}

ModeMotion modeMotion (double angularFrequency, double dampingRatio, const Eigen::VectorXd& force, double sampleRate,
                       Eigen::Index samples, bool withChanges)
{
    auto motion = modeMotionUntilRest (angularFrequency, dampingRatio, force, sampleRate, samples, withChanges);
    fillUp (motion.velocity, samples);

    if (withChanges)
    {
        fillUp (motion.byFrequency, samples);
        fillUp (motion.byDamping, samples);
    }

    return motion;
}

Eigen::MatrixXd modeVelocities (const ModalModel& model, const PlayedVoltages& voltages, Eigen::Index samples)
{
    Eigen::MatrixXd velocities = Eigen::MatrixXd::Zero (samples, model.modes());
    parallelFor (static_cast<std::size_t> (model.modes()),
                 [&] (std::size_t mode)
                 {
                     const auto k = static_cast<Eigen::Index> (mode);
                     const auto motion = modeMotionUntilRest (model.angularFrequencies[k], model.dampingRatios[k],
                                                              voltages.force (model.participation.row (k)),
                                                              voltages.sampleRate(), samples, false);
                     velocities.col (k).head (motion.velocity.size()) = motion.velocity;
                 });
    return velocities;
}

namespace
{
constexpr double ringing = 256; // samples until what comes round is inaudible
} // namespace

// At twice the rate: what a cube has above that folds back only to where it is removed.
Eigen::MatrixXd cubedVoltages (const Eigen::MatrixXd& voltages)
{
    const auto length = quickLength (static_cast<double> (voltages.cols()) + ringing);
    Eigen::MatrixXd cubes (voltages.rows(), voltages.cols());
    FourierTables tables;

    for (Eigen::Index i = 0; i < voltages.rows(); ++i)
    {
        Eigen::VectorXcd wide = Eigen::VectorXcd::Zero (length + 1);
        const auto lines = length / 2 + 1;
        wide.head (lines) = 2 * tables.forward (voltages.row (i).transpose(), length);
        wide[lines - 1] /= 2; // Half the rate, which is two lines now.
        const Eigen::VectorXd cubed = tables.inverse (wide, 2 * length).array().cube();
        cubes.row (i) = tables.inverse (tables.forward (cubed).head (lines) / 2, length).head (voltages.cols());
    }

    return cubes;
}
} // namespace antinode
