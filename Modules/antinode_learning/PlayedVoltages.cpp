#include "PlayedVoltages.h"

#include <antinode_numerics/Fourier.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace antinode
{
namespace
{
using Complex = std::complex<double>;

/** Gauss and Legendre's places and weights on 0 to 1. */
constexpr std::array<double, PlayedVoltages::places> gaussPlaces { 0.06943184420297371, 0.33000947820757187,
                                                                   0.6699905217924281, 0.9305681557970263 };
constexpr std::array<double, PlayedVoltages::places> gaussWeights { 0.17392742256872693, 0.32607257743127307,
                                                                    0.32607257743127307, 0.17392742256872693 };

/** How one sample interval takes a mode on: y becomes turn y + sum taps force. */
struct Interval
{
    Complex pole, turn;
    std::array<Complex, PlayedVoltages::places> taps, tapsByPole;
};

Interval makeInterval (double angularFrequency, double dampingRatio, double length)
{
    Interval interval;
    interval.pole = angularFrequency * Complex { -dampingRatio, std::sqrt (1 - dampingRatio * dampingRatio) };
    interval.turn = std::exp (interval.pole * length);

    for (std::size_t g = 0; g < gaussPlaces.size(); ++g)
    {
        const auto left = length * (1 - gaussPlaces[g]);
        interval.taps[g] = length * gaussWeights[g] * std::exp (interval.pole * left);
        interval.tapsByPole[g] = left * interval.taps[g];
    }

    return interval;
}
} // namespace

PlayedVoltages::PlayedVoltages (const Eigen::MatrixXd& voltages, double sampleRate)
    : values (voltages.cols() * places, voltages.rows()), count (voltages.cols()), rate (sampleRate)
{
    constexpr double silence = 256; // samples, until a sinc has gone below 1e-3 of a jump, before it comes round again
    const auto length = quickLength (static_cast<double> (count) + silence);
    FourierTables tables;

    for (Eigen::Index i = 0; i < voltages.rows(); ++i)
    {
        const auto spectrum = tables.forward (voltages.row (i).transpose(), length);

        for (Eigen::Index g = 0; g < places; ++g)
        {
            const auto turn =
                2 * std::numbers::pi * gaussPlaces[static_cast<std::size_t> (g)] / static_cast<double> (length);
            const Eigen::VectorXcd turns = Eigen::VectorXcd::NullaryExpr (
                spectrum.size(), [turn] (Eigen::Index k) { return std::polar (1.0, turn * static_cast<double> (k)); });
            const Eigen::VectorXd between = tables.inverse (spectrum.cwiseProduct (turns), length);

            for (Eigen::Index n = 0; n < count; ++n)
                values (n * places + g, i) = between[n];
        }
    }
}

ModeMotion modeMotion (double angularFrequency, double dampingRatio, const Eigen::VectorXd& force, double sampleRate,
                       Eigen::Index samples, bool withChanges)
{
    const auto interval = makeInterval (angularFrequency, dampingRatio, 1 / sampleRate);
    const auto turnByPole = interval.turn / sampleRate;
    // q' = Re y - (a / b) Im y; the ratio depends on the damping ratio alone.
    const auto root = std::sqrt (1 - dampingRatio * dampingRatio);
    const auto ratio = dampingRatio / root, ratioByDamping = ratio + std::pow (ratio, 3);
    const auto poleByDamping = angularFrequency * Complex { -dampingRatio, -dampingRatio * ratio };
    ModeMotion motion;
    motion.velocity.resize (samples);

    if (withChanges)
    {
        motion.byFrequency.resize (samples);
        motion.byDamping.resize (samples);
    }

    Complex y = 0, byPole = 0;

    for (Eigen::Index n = 0; n < samples; ++n)
    {
        motion.velocity[n] = y.real() - ratio * y.imag();

        if (withChanges)
        {
            const auto changed = [&] (Complex ofPole)
            {
                const auto change = byPole * ofPole;
                return change.real() - ratio * change.imag();
            };
            motion.byFrequency[n] = changed (interval.pole);
            motion.byDamping[n] = changed (poleByDamping) - ratioByDamping * y.imag();
        }

        Complex added = 0, addedByPole = 0;

        for (std::size_t g = 0; g < gaussPlaces.size(); ++g)
        {
            const auto value = force[n * PlayedVoltages::places + static_cast<Eigen::Index> (g)];
            added += interval.taps[g] * value;
            addedByPole += interval.tapsByPole[g] * value;
        }

        byPole = interval.turn * byPole + turnByPole * y + addedByPole;
        y = interval.turn * y + added;
    }

    return motion;
}

Eigen::MatrixXd modeVelocities (const ModalModel& model, const PlayedVoltages& voltages, Eigen::Index samples)
{
    Eigen::MatrixXd velocities (samples, model.modes());

    for (Eigen::Index k = 0; k < model.modes(); ++k)
        velocities.col (k) =
            modeMotion (model.angularFrequencies[k], model.dampingRatios[k],
                        voltages.force (model.participation.row (k)), voltages.sampleRate(), samples, false)
                .velocity;

    return velocities;
}
} // namespace antinode
