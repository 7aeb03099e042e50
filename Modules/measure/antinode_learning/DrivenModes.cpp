#include "DrivenModes.h"

#include "MovingMode.h"

#include <antinode_numerics/ParallelFor.h>

#include <algorithm>
#include <numeric>

namespace antinode
{
namespace
{
Histories emptyHistories (Eigen::Index samples, Eigen::Index count)
{
    return { Eigen::MatrixXd (samples, count), std::vector<FreeDecay> (static_cast<std::size_t> (count)) };
}

MovingMode modeAtRest (const ModalModel& model, Eigen::Index k, const PlayedVoltages& voltages)
{
    return { model.angularFrequencies[k], model.dampingRatios[k], voltages.sampleRate() };
}

/** Calls a function with the force of every row of participations; many rows share one product. */
template <typename Use>
void forEachForce (const PlayedVoltages& voltages, const Eigen::MatrixXd& participations, const Use& use)
{
    constexpr Eigen::Index together = 32;
    const auto count = participations.rows();
    parallelFor (static_cast<std::size_t> ((count + together - 1) / together),
                 [&] (std::size_t group)
                 {
                     const auto first = static_cast<Eigen::Index> (group) * together;
                     const auto some = std::min (together, count - first);
                     const auto forces = voltages.forces (participations.middleRows (first, some));

                     for (Eigen::Index i = 0; i < some; ++i)
                         use (first + i, forces.col (i).data());
                 });
}

/** The velocity of one mode into one column. */
void drive (Histories& histories, Eigen::Index column, MovingMode mode, const double* force)
{
    for (Eigen::Index n = 0; n < histories.driven.rows(); ++n, force += PlayedVoltages::places)
    {
        histories.driven (n, column) = mode.velocity();
        mode.advance<false> (force);
    }

    histories.after[static_cast<std::size_t> (column)] = mode.velocityAfter();
}

/** The same per unit of the force, times a factor. */
void driveScaled (Histories& histories, Eigen::Index column, const MovingMode& mode, const double* force, double factor)
{
    drive (histories, column, mode, force);
    histories.driven.col (column) *= factor;
    histories.after[static_cast<std::size_t> (column)].constant *= factor;
}

std::complex<double> lastMotion (MovingMode mode, const double* force, Eigen::Index samples)
{
    for (Eigen::Index n = 0; n < samples; ++n, force += PlayedVoltages::places)
        mode.advance<false> (force);

    return mode.velocityAfter().constant;
}
} // namespace

Eigen::Matrix4Xd Histories::parts() const
{
    Eigen::Matrix4Xd all (4, std::ssize (after));

    for (std::size_t p = 0; p < after.size(); ++p)
        all.col (static_cast<Eigen::Index> (p)) = after[p].parts();

    return all;
}

DrivenModes driveModes (const ModalModel& model, const PlayedVoltages& voltages, Eigen::Index samples)
{
    const auto count = std::min (samples, voltages.drivenSamples());
    const auto empty = emptyHistories (count, model.modes());
    DrivenModes all { empty, empty, empty };
    forEachForce (voltages, model.participation,
                  [&] (Eigen::Index k, const double* force)
                  {
                      auto mode = modeAtRest (model, k, voltages);
                      const auto index = static_cast<std::size_t> (k);

                      for (Eigen::Index n = 0; n < count; ++n, force += PlayedVoltages::places)
                      {
                          all.velocity.driven (n, k) = mode.velocity();
                          all.byFrequency.driven (n, k) = mode.byFrequency();
                          all.byDamping.driven (n, k) = mode.byDamping();
                          mode.advance<true> (force);
                      }

                      all.velocity.after[index] = mode.velocityAfter();
                      all.byFrequency.after[index] = mode.byFrequencyAfter();
                      all.byDamping.after[index] = mode.byDampingAfter();
                  });
    return all;
}

Histories drivenBy (const ModalModel& model, const std::vector<Eigen::Index>& modes,
                    const Eigen::MatrixXd& participations, const PlayedVoltages& voltages, Eigen::Index samples)
{
    auto histories = emptyHistories (std::min (samples, voltages.drivenSamples()), participations.rows());
    forEachForce (voltages, participations,
                  [&] (Eigen::Index p, const double* force)
                  { drive (histories, p, modeAtRest (model, modes[static_cast<std::size_t> (p)], voltages), force); });
    return histories;
}

Histories modeHistories (const ModalModel& model, const PlayedVoltages& voltages, Eigen::Index samples)
{
    std::vector<Eigen::Index> modes (static_cast<std::size_t> (model.modes()));
    std::iota (modes.begin(), modes.end(), Eigen::Index { 0 });
    return drivenBy (model, modes, model.participation, voltages, samples);
}

Histories drivenByCube (const ModalModel& model, const PlayedVoltages& voltages, Eigen::Index ceramic,
                        Eigen::Index samples)
{
    auto histories = emptyHistories (std::min (samples, voltages.drivenSamples()), model.modes());
    parallelFor (static_cast<std::size_t> (model.modes()),
                 [&] (std::size_t mode)
                 {
                     const auto k = static_cast<Eigen::Index> (mode);
                     driveScaled (histories, k, modeAtRest (model, k, voltages), voltages.cubeOf (ceramic).data(),
                                  model.participation (k, ceramic));
                 });
    return histories;
}

LastMotions lastMotions (const ModalModel& model, const PlayedVoltages& voltages, Eigen::Index samples)
{
    const auto count = std::min (samples, voltages.drivenSamples());
    LastMotions last { Eigen::MatrixXcd (model.modes(), model.actuators()),
                       Eigen::MatrixXcd (model.modes(), model.actuators()) };
    parallelFor (static_cast<std::size_t> (model.modes()),
                 [&] (std::size_t mode)
                 {
                     const auto k = static_cast<Eigen::Index> (mode);
                     const auto atRest = modeAtRest (model, k, voltages);

                     for (Eigen::Index i = 0; i < model.actuators(); ++i)
                     {
                         const auto participation = model.participation (k, i);
                         last.byVoltages (k, i) = participation * lastMotion (atRest, voltages.of (i).data(), count);
                         last.byCubes (k, i) = participation * lastMotion (atRest, voltages.cubeOf (i).data(), count);
                     }
                 });
    return last;
}

Histories drivenByEachCeramic (const ModalModel& model, Eigen::Index mode, const PlayedVoltages& voltages,
                               Eigen::Index samples)
{
    auto histories = emptyHistories (std::min (samples, voltages.drivenSamples()), model.actuators());

    for (Eigen::Index i = 0; i < model.actuators(); ++i)
        driveScaled (histories, i, modeAtRest (model, mode, voltages), voltages.of (i).data(),
                     model.participation (mode, i));

    return histories;
}

std::complex<double> decayLogarithm (const ModalModel& model, Eigen::Index mode, double sampleRate)
{
    return MovingMode::poleOf (model.angularFrequencies[mode], model.dampingRatios[mode]) / sampleRate;
}

Eigen::VectorXcd decayLogarithms (const ModalModel& model, double sampleRate)
{
    return Eigen::VectorXcd::NullaryExpr (model.modes(),
                                          [&] (Eigen::Index k) { return decayLogarithm (model, k, sampleRate); });
}
} // namespace antinode
