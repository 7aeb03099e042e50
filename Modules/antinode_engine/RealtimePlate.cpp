#include "RealtimePlate.h"

#include "ModalRecursion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace antinode
{
RealtimePlate::RealtimePlate (const ModalModel& model, double sampleRate, const Eigen::MatrixXd& probeShapes)
    : kernel (plateKernel())
{
    requirePlayable (model, probeShapes);
    const auto recursion = modalRecursion (model, { Reconstruction::zeroOrderHold, sampleRate });
    const auto audible = (model.angularFrequencies.array() < std::numbers::pi * sampleRate).count(); // they ascend

    sizes.modes = plateModeGroup * static_cast<int> ((audible + plateModeGroup - 1) / plateModeGroup);
    sizes.ceramics = static_cast<int> (model.actuators());
    sizes.probes = static_cast<int> (probeShapes.rows());
    const auto padded = static_cast<std::size_t> (sizes.modes);
    drive.resize (padded * static_cast<std::size_t> (sizes.ceramics));
    transition.resize (padded * 4);
    shapes.resize (padded * static_cast<std::size_t> (sizes.probes));

    const auto decay = decayRates (model);
    const Eigen::ArrayXd perTurn = decay.array() / dampedFrequencies (model).array();

    for (Eigen::Index k = 0; k < audible; ++k)
    {
        const auto mode = static_cast<std::size_t> (k);
        const auto group = mode / plateModeGroup, lane = mode % plateModeGroup;
        const auto real = recursion.transitionReal[k], imaginary = recursion.transitionImaginary[k], d = perTurn[k];
        auto* turn = transition.data() + group * (4 * plateModeGroup) + lane;
        turn[0] = real - d * imaginary;
        turn[plateModeGroup] = -(1 + d * d) * imaginary;
        turn[2 * plateModeGroup] = imaginary;
        turn[3 * plateModeGroup] = real + d * imaginary;
        const auto half = std::tanh (decay[k] / (2 * sampleRate)) / decay[k];
        const auto ceramics = static_cast<std::size_t> (sizes.ceramics),
                   probes = static_cast<std::size_t> (sizes.probes);

        for (std::size_t i = 0; i < ceramics; ++i)
            drive[(group * ceramics + i) * plateModeGroup + lane] =
                half * model.participation (k, static_cast<Eigen::Index> (i));

        for (std::size_t p = 0; p < probes; ++p)
        {
            const auto eights = probes / plateProbeGroup * plateProbeGroup;
            const auto within =
                p < eights ? (p / plateProbeGroup * plateModeGroup + lane) * plateProbeGroup + p % plateProbeGroup
                           : p * plateModeGroup + lane;
            shapes[group * probes * plateModeGroup + within] = probeShapes (static_cast<Eigen::Index> (p), k);
        }
    }

    state.resize (padded * 2);
    motion.resize (static_cast<std::size_t> (plateTile) * plateModesHeard);
    sums.resize (static_cast<std::size_t> (sizes.probes) * plateTile * (plateModeGroup / 4));
    inputVoltages.resize (static_cast<std::size_t> (sizes.ceramics) * plateTile);
    outputs.resize (static_cast<std::size_t> (sizes.probes) * plateTile);
}

void RealtimePlate::reset()
{
    std::fill (state.begin(), state.end(), 0.0);
    std::fill (motion.begin(), motion.end(), 0.0);
    std::fill (sums.begin(), sums.end(), 0.0);
    std::fill (inputVoltages.begin(), inputVoltages.end(), 0.0);
    position = 0;
}

template <typename Sample>
void RealtimePlate::process (const Sample* const* voltages, Sample* const* velocities, int count)
{
    auto tile = sizes;
    tile.drive = drive.data();
    tile.transition = transition.data();
    tile.shapes = shapes.data();
    tile.voltages = inputVoltages.data();
    tile.state = state.data();
    tile.motion = motion.data();
    tile.sums = sums.data();
    tile.velocities = outputs.data();

    for (int done = 0; done < count; done += tile.samples)
    {
        tile.samples = std::min (plateTile - position, count - done);
        position = (position + tile.samples) % plateTile;
        tile.last = position == 0;

        for (std::ptrdiff_t i = 0; i < tile.ceramics; ++i)
            std::copy_n (voltages[i] + done, tile.samples, inputVoltages.data() + i * plateTile);

        kernel (tile);

        for (std::ptrdiff_t p = 0; p < tile.probes; ++p)
            std::transform (outputs.data() + p * plateTile, outputs.data() + p * plateTile + tile.samples,
                            velocities[p] + done, [] (double value) { return static_cast<Sample> (value); });
    }
}

template void RealtimePlate::process (const double* const*, double* const*, int);
template void RealtimePlate::process (const float* const*, float* const*, int);
} // namespace antinode
