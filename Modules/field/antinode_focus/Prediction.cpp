#include "Prediction.h"

#include "SampledPrediction.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/DenseKernels.h>

#include <cmath>

namespace antinode
{
namespace
{
using namespace std::complex_literals;
using Complex = std::complex<double>;

/** (e^{p L} - e^{s L}) / (p - s), also where p comes near s. */
Complex exponentialDifference (Complex p, Complex s, double length)
{
    const auto z = (p - s) * length;

    if (std::abs (z) > 0.5)
        return (std::exp (p * length) - std::exp (s * length)) / (p - s);

    // (e^z - 1)/z by its series: 14 terms leave 0.5^14 / 15! < 1e-16.
    Complex sum = 1, term = 1;

    for (int n = 2; n <= 15; ++n)
    {
        term *= z / static_cast<double> (n);
        sum += term;
    }

    return std::exp (s * length) * length * sum;
}

/** sum over n = 0 .. count-1 of r_p^n r_s^{count-1-n} with r = e^{(.) T}. */
Complex geometricDifference (Complex p, Complex s, double period, double count)
{
    const auto step = exponentialDifference (p, s, period);
    return exponentialDifference (p, s, period * count) / step;
}

template <typename Response>
Complex realResponse (const Oscillation& oscillation, Response&& response)
{
    const auto p = oscillation.exponent();
    const auto x = oscillation.phasor();
    return 0.5 * (x * response (p) + std::conj (x) * response (std::conj (p)));
}
} // namespace

Complex modalResponse (Complex pole, const Oscillation& oscillation, double time)
{
    const auto length = std::min (time, oscillation.end) - oscillation.start;

    if (length <= 0)
        return 0;

    const auto state = realResponse (oscillation, [&] (Complex p) { return exponentialDifference (p, pole, length); });
    return state * std::exp (pole * std::max (time - oscillation.end, 0.0));
}

Complex heldModalResponse (Complex pole, const Oscillation& oscillation, double time, double sampleRate)
{
    // The samples lie at time - m / rate, m = 1, 2, ...; those with start <= t < end act, each held for one period.
    constexpr double onSample = 1e-6;
    const auto period = 1 / sampleRate;
    const auto lastBack = std::max (1.0, std::floor ((time - oscillation.end) * sampleRate + onSample) + 1);
    const auto firstBack = std::floor ((time - oscillation.start) * sampleRate + onSample);
    const auto count = firstBack - lastBack + 1;

    if (count <= 0)
        return 0;

    const auto firstTime = time - firstBack * period - oscillation.start;
    const auto heldGain = exponentialDifference (0, pole, period); // integral of e^{s t} over one period
    const auto state =
        realResponse (oscillation, [&] (Complex p)
                      { return std::exp (p * firstTime) * geometricDifference (p, pole, period, count); });
    return state * heldGain * std::exp (pole * (lastBack - 1) * period);
}

Eigen::VectorXcd modalPoles (const ModalModel& model)
{
    Eigen::VectorXcd poles (model.modes());
    poles.real() = -decayRates (model);
    poles.imag() = dampedFrequencies (model);
    return poles;
}

Eigen::VectorXd modalVelocities (const ModalModel& model, const Eigen::VectorXcd& states)
{
    const Eigen::ArrayXd ratio = decayRates (model).array() / dampedFrequencies (model).array();
    Eigen::VectorXd velocities = (states.real().array() - ratio * states.imag().array()).matrix();

    if (! model.hasComplexModes())
        return velocities;

    Eigen::VectorXd all (2 * velocities.size());
    all << velocities, (-states.imag().array() - ratio * states.real().array()).matrix();
    return all;
}

Eigen::VectorXd modalDisplacements (const ModalModel& model, const Eigen::VectorXcd& states)
{
    const auto frequencies = dampedFrequencies (model);
    Eigen::VectorXd displacements = states.imag().cwiseQuotient (frequencies);

    if (! model.hasComplexModes())
        return displacements;

    Eigen::VectorXd all (2 * displacements.size());
    all << displacements, states.real().cwiseQuotient (frequencies);
    return all;
}

Eigen::MatrixXcd complexForces (const ModalModel& model, const Eigen::MatrixXd& forces)
{
    Eigen::MatrixXcd all = forces.topRows (model.modes()).cast<Complex>();

    if (model.hasComplexModes())
        all.imag() = forces.bottomRows (model.modes());

    return all;
}

Eigen::VectorXcd predictStates (const ModalModel& model, const VoltageProgram& program, double time)
{
    const auto poles = modalPoles (model);
    Eigen::MatrixXd forces =
        Eigen::MatrixXd::Zero (model.participation.rows(), program.allocation.cols()); // N_c x oscillations
    addProduct (forces, 1, model.participation, program.allocation);
    Eigen::VectorXcd states = Eigen::VectorXcd::Zero (model.modes());

    for (Eigen::Index k = 0; k < states.size(); ++k)
    {
        checkWatch();

        for (Eigen::Index c = 0; c < forces.cols(); ++c)
        {
            const auto response = modalResponse (poles[k], program.oscillations[static_cast<std::size_t> (c)], time);
            states[k] += forces (k, c) * response;

            if (model.hasComplexModes())
                states[k] += forces (model.modes() + k, c) * 1i * response;
        }
    }

    if (program.samples)
        states += sampledStates (model, *program.samples, time);

    return states;
}

double oscillationValue (const Oscillation& oscillation, double time)
{
    if (time < oscillation.start || time >= oscillation.end)
        return 0;

    return (oscillation.phasor() * std::exp (oscillation.exponent() * (time - oscillation.start))).real();
}
} // namespace antinode
