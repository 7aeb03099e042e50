#include "Bench.h"

#include <antinode_base/InputError.h>
#include <antinode_model/ModalModel.h>

#include <limits>
#include <utility>

namespace antinode
{
SimulatedBenchPlayer::SimulatedBenchPlayer (ModalModel modelToMeasure, const Eigen::MatrixX2d& points,
                                            SimulatedBenchSettings settingsToUse)
    : model (std::move (modelToMeasure)), shapes (shapesAtPlaces (model, points)), settings (settingsToUse)
{
}

SimulatedBenchPlayer::SimulatedBenchPlayer (ModalModel modelToMeasure, Eigen::MatrixXd shapesToHear,
                                            SimulatedBenchSettings settingsToUse)
    : model (std::move (modelToMeasure)), shapes (std::move (shapesToHear)), settings (settingsToUse)
{
}

Eigen::Index SimulatedBenchPlayer::sensors() const
{
    constexpr Eigen::Index maximum = 16; // The memory for a recording of a long run stays below some 100 MB.
    return std::min (maximum, shapes.rows());
}

double SimulatedBenchPlayer::fullScaleVelocity() const
{
    return std::numeric_limits<double>::infinity();
}

RunRecording SimulatedBenchPlayer::play (const Excitation& excitation, Eigen::Index ceramic, Eigen::Index firstPoint,
                                         Eigen::Index points)
{
    if (ceramic >= model.actuators())
        throw InputError ("device '" + model.name + "'", "has fewer ceramics than the measurement");

    Eigen::MatrixXd played = playedRun (excitation, ceramic, 1);
    auto own = settings;
    own.sampleRate = excitation.settings.sampleRate;
    // No two runs have the same noise.
    own.seed += static_cast<std::uint64_t> (ceramic + excitation.ceramics() * firstPoint);
    return simulateBench (model, shapes.middleRows (firstPoint, points), played.topRows (model.actuators()),
                          played.bottomRows (1).transpose(), own);
}

RunRecording SimulatedBenchPlayer::playTogether (const Eigen::MatrixXd& voltages, const Eigen::VectorXd& sync,
                                                 double sampleRate, Eigen::Index points)
{
    auto own = settings;
    own.sampleRate = sampleRate;
    own.seed += plays++;
    return simulateBench (model, shapes.topRows (points), voltages, sync, own);
}
} // namespace antinode
