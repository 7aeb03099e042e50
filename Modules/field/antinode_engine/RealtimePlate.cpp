#include "RealtimePlate.h"

#include <antinode_model/ModalRecursion.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace antinode
{
namespace
{
/** The place of a mode among those that are heard: complex modes are heard in two groups of 32, one after the other,
   for their two coordinates. */
Eigen::Index heardPlace (Eigen::Index mode, bool isComplex)
{
    return isComplex ? 2 * mode - mode % plateModeGroup : mode;
}
} // namespace

RealtimePlate::RealtimePlate (const ModalModel& model, double sampleRate, const Eigen::MatrixXd& probeShapes)
    : move (plateKernel()), probes (probeKernel())
{
    requirePlayable (model, probeShapes);
    const auto audible = (model.angularFrequencies.array() < std::numbers::pi * sampleRate).count(); // they ascend
    const auto groups = static_cast<int> ((audible + plateModeGroup - 1) / plateModeGroup);
    sizes.complex = model.hasComplexModes();
    sizes.modes = plateModeGroup * (sizes.complex ? 2 * groups : groups);
    sizes.ceramics = static_cast<int> (model.actuators());
    sizes.probes = static_cast<int> (probeShapes.rows());

    const auto padded = static_cast<std::size_t> (plateModeGroup) * static_cast<std::size_t> (groups);
    const auto heard = static_cast<std::size_t> (sizes.modes);
    const auto rows = static_cast<std::size_t> (sizes.probes), columns = static_cast<std::size_t> (sizes.ceramics);
    drive.resize (heard * columns);
    transition.resize (padded * 4);
    shapes.resize (heard * rows);
    state.resize (padded * 2);
    motion.resize (static_cast<std::size_t> (plateTile) * plateModesHeard);
    sums.resize (rows * plateTile * (plateModeGroup / 4));
    inputVoltages.resize (columns * plateTile);
    outputs.resize (rows * plateTile);
    setTransitions (model, sampleRate, audible);

    for (Eigen::Index k = 0; k < audible; ++k)
        setModeShapes (k, probeShapes);
}

void RealtimePlate::setTransitions (const ModalModel& model, double sampleRate, Eigen::Index audible)
{
    const auto recursion = modalRecursion (model, { Reconstruction::zeroOrderHold, sampleRate });
    const auto decay = decayRates (model);
    decayPerTurn = decay.array() / dampedFrequencies (model).array();

    for (Eigen::Index k = 0; k < audible; ++k)
    {
        const auto real = recursion.transitionReal[k], imaginary = recursion.transitionImaginary[k];
        const auto d = decayPerTurn[k];
        const auto lane = k % plateModeGroup, group = k - lane;
        auto* turn = transition.data() + group * 4 + lane;
        turn[0] = real - d * imaginary;
        turn[plateModeGroup] = -(1 + d * d) * imaginary;
        turn[2 * plateModeGroup] = imaginary;
        turn[3 * plateModeGroup] = real + d * imaginary;
        const auto half = std::tanh (decay[k] / (2 * sampleRate)) / decay[k];
        const auto heard = heardPlace (k, sizes.complex);

        if (! sizes.complex)
        {
            setDrive (heard, half * model.participation.row (k));
            continue;
        }

        const auto turned = model.participation.row (model.modes() + k);
        setDrive (heard, half * (model.participation.row (k) - d * turned));
        setDrive (heard + plateModeGroup, half * turned);
    }
}

void RealtimePlate::setDrive (Eigen::Index heard, const Eigen::RowVectorXd& perVolt)
{
    const auto lane = heard % plateModeGroup;

    for (Eigen::Index i = 0; i < sizes.ceramics; ++i)
        drive.data()[(heard - lane) * sizes.ceramics + i * plateModeGroup + lane] = perVolt[i];
}

/** The turned velocity of a complex mode is -(1 + d^2) x2 - d x1, d = a/b. */
void RealtimePlate::setModeShapes (Eigen::Index mode, const Eigen::MatrixXd& probeShapes)
{
    const auto heard = heardPlace (mode, sizes.complex);

    if (! sizes.complex)
    {
        setShapes (heard, probeShapes.col (mode));
        return;
    }

    const auto d = decayPerTurn[mode];
    const auto turned = probeShapes.col (decayPerTurn.size() + mode);
    setShapes (heard, probeShapes.col (mode) - d * turned);
    setShapes (heard + plateModeGroup, -(1 + d * d) * turned);
}

void RealtimePlate::setShapes (Eigen::Index heard, const Eigen::VectorXd& atProbes)
{
    const auto lane = heard % plateModeGroup;
    const auto eights = sizes.probes - sizes.probes % plateProbeGroup;
    auto* group = shapes.data() + (heard - lane) * sizes.probes;

    for (Eigen::Index p = 0; p < sizes.probes; ++p)
        if (const auto inEight = p % plateProbeGroup; p < eights)
            group[(p - inEight) * plateModeGroup + lane * plateProbeGroup + inEight] = atProbes[p];
        else
            group[p * plateModeGroup + lane] = atProbes[p];
}

void RealtimePlate::reset()
{
    std::fill (state.begin(), state.end(), 0.0);
    std::fill (motion.begin(), motion.end(), 0.0);
    std::fill (sums.begin(), sums.end(), 0.0);
    std::fill (inputVoltages.begin(), inputVoltages.end(), 0.0);
    position = 0;
}

void RealtimePlate::copyMotion (const RealtimePlate& other)
{
    std::copy (other.state.begin(), other.state.end(), state.begin());
    std::copy (other.motion.begin(), other.motion.end(), motion.begin());
    std::copy (other.inputVoltages.begin(), other.inputVoltages.end(), inputVoltages.begin());
    position = other.position;
    newest = other.newest;
}

/** One of the two coordinates of a mode. The state has all of what the sample's force adds, the motion at the sample
   half of it. */
double RealtimePlate::atLastSample (std::size_t mode, int coordinate) const
{
    const auto ceramics = static_cast<std::size_t> (sizes.ceramics), last = static_cast<std::size_t> (newest);
    const auto lane = mode % plateModeGroup, group = mode - lane, second = static_cast<std::size_t> (coordinate);
    auto value = state[(group * 2) + second * plateModeGroup + lane];

    if (coordinate > 0 && ! sizes.complex)
        return value;

    const auto heard = (sizes.complex ? 2 * group : group) + second * plateModeGroup;

    for (std::size_t i = 0; i < ceramics; ++i)
        value -= drive[heard * ceramics + i * plateModeGroup + lane] * inputVoltages[i * plateTile + last];

    return value;
}

void RealtimePlate::modalVelocities (std::span<double> velocities) const
{
    const auto modes = static_cast<std::size_t> (decayPerTurn.size()), padded = state.size() / 2;
    std::fill (velocities.begin(), velocities.end(), 0.0);

    for (std::size_t k = 0; k < std::min (modes, padded); ++k)
    {
        velocities[k] = atLastSample (k, 0);

        if (! sizes.complex)
            continue;

        const auto d = decayPerTurn[static_cast<Eigen::Index> (k)];
        velocities[modes + k] = -(1 + d * d) * atLastSample (k, 1) - d * velocities[k];
    }
}

void RealtimePlate::process (const double* const* voltages, double* const* velocities, int count)
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
        newest = tile.samples - 1;

        for (std::ptrdiff_t i = 0; i < tile.ceramics; ++i)
            std::copy_n (voltages[i] + done, tile.samples, inputVoltages.data() + i * plateTile);

        for (std::ptrdiff_t mode = 0; mode < tile.modes; mode += plateModesHeard)
        {
            move (tile, mode);
            probes.hear (tile, mode);
        }

        probes.write (tile);

        for (std::ptrdiff_t p = 0; p < tile.probes; ++p)
            std::copy_n (outputs.data() + p * plateTile, tile.samples, velocities[p] + done);
    }
}
} // namespace antinode
