#include "Prediction.h"

#include <antinode_base/Watch.h>
#include <antinode_model/ModalRecursion.h>
#include <antinode_numerics/DenseKernels.h>
#include <antinode_numerics/KaiserSinc.h>
#include <antinode_numerics/Quadrature.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

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

namespace
{
using Complex = std::complex<double>;

/** An oscillation so near a pole that 1 / (p - s) would leave no digit is moved off it, by too little to be seen in the
   motion: after a second it has changed by 1e-5, and ten digits are left. */
Oscillation offPoles (Oscillation oscillation, const Eigen::VectorXcd& poles)
{
    constexpr double nearest = 1e-5; // 1/s

    if ((poles.array() - oscillation.exponent()).abs().minCoeff() < nearest)
        oscillation.growth += 2 * nearest;

    return oscillation;
}
} // namespace

ProgramMotion::ProgramMotion (const ModalModel& model, const VoltageProgram& program) : poles (modalPoles (model))
{
    for (const auto& oscillation : program.oscillations)
        oscillations.push_back (offPoles (oscillation, poles));

    with = against = complexForces (model, model.participation * program.allocation);
    std::set<double> times { program.focusTime };

    for (Eigen::Index c = 0; c < with.cols(); ++c)
    {
        checkWatch();
        const auto& oscillation = oscillations[static_cast<std::size_t> (c)];
        const auto p = oscillation.exponent();
        const auto half = 0.5 * oscillation.phasor();
        times.insert ({ oscillation.start, oscillation.end });

        for (Eigen::Index k = 0; k < poles.size(); ++k)
        {
            with (k, c) *= half / (p - poles[k]);
            against (k, c) *= std::conj (half) / (std::conj (p) - poles[k]);
        }
    }

    Knot knot { *times.begin(), Eigen::VectorXcd::Zero (poles.size()), {} };

    for (const auto time : times)
    {
        checkWatch();
        knots.push_back (knot = knotAfter (knot, time));
    }
}

/** The particular motion under one oscillation, which begins and ends with a step that free motion makes up for. */
Eigen::VectorXcd ProgramMotion::forced (Eigen::Index c, double time) const
{
    const auto& oscillation = oscillations[static_cast<std::size_t> (c)];
    const auto turned = std::exp (oscillation.exponent() * (time - oscillation.start));
    return turned * with.col (c) + std::conj (turned) * against.col (c);
}

ProgramMotion::Knot ProgramMotion::knotAfter (const Knot& before, double time) const
{
    Knot knot { time, ((poles * (time - before.time)).array().exp() * before.free.array()).matrix(), {} };

    for (const auto c : before.playing)
        if (time < oscillations[static_cast<std::size_t> (c)].end)
            knot.playing.push_back (c);
        else
            knot.free += forced (c, time);

    for (std::size_t c = 0; c < oscillations.size(); ++c)
        if (oscillations[c].start == time && oscillations[c].end > time)
        {
            knot.playing.push_back (static_cast<Eigen::Index> (c));
            knot.free -= forced (static_cast<Eigen::Index> (c), time);
        }

    return knot;
}

Eigen::VectorXcd ProgramMotion::statesAt (double time) const
{
    const auto after =
        std::upper_bound (knots.begin(), knots.end(), time, [] (double t, const Knot& knot) { return t < knot.time; });

    if (after == knots.begin())
        return Eigen::VectorXcd::Zero (poles.size());

    const auto& knot = *std::prev (after);
    Eigen::VectorXcd states = ((poles * (time - knot.time)).array().exp() * knot.free.array()).matrix();

    for (const auto c : knot.playing)
        states += forced (c, time);

    checkWatch();
    return states;
}

namespace
{
using Complex = std::complex<double>;

/** Voltages at a place counted in samples from the first one. */
Eigen::VectorXd voltagesAtPlace (const SampledVoltages& voltages, double place)
{
    const auto& values = voltages.values;
    const auto below = static_cast<Eigen::Index> (std::floor (place));

    if (voltages.playback.reconstruction == Reconstruction::zeroOrderHold)
        return below >= 0 && below < values.cols() ? Eigen::VectorXd (values.col (below))
                                                   : Eigen::VectorXd::Zero (values.rows());

    Eigen::VectorXd sum = Eigen::VectorXd::Zero (values.rows());
    const auto first = std::max<Eigen::Index> (0, below - kaiserSincHalfWidth + 1);
    const auto last = std::min (values.cols() - 1, below + kaiserSincHalfWidth);

    for (auto n = first; n <= last; ++n)
        sum += kaiserSinc (place - static_cast<double> (n)) * values.col (n);

    return sum;
}

/** What a part of a sample interval adds to the states, by Gauss and Legendre's rule. */
Eigen::VectorXcd addedWithin (const ModalModel& model, const SampledVoltages& voltages, double place, double part)
{
    const auto poles = modalPoles (model);
    const auto interval = 1 / voltages.playback.sampleRate;
    const auto phase = poles.imag().maxCoeff() * interval * part;
    const auto rule = gaussLegendre (16, std::max (1, static_cast<int> (std::ceil (phase / std::numbers::pi))));
    Eigen::VectorXcd sum = Eigen::VectorXcd::Zero (poles.size());

    for (Eigen::Index i = 0; i < rule.nodes.size(); ++i)
    {
        const Eigen::VectorXcd forces =
            complexForces (model, model.participation * voltagesAtPlace (voltages, place + part * rule.nodes[i]));
        const Eigen::ArrayXcd decayed = (poles.array() * (interval * part * (1 - rule.nodes[i]))).exp();
        sum.array() += rule.weights[i] * part * interval * decayed * forces.array();
    }

    return sum;
}

constexpr Eigen::Index stepsByProducts = 32; // their rounding stays below 1e-14

/** Sums over the taps from each one on, as the state sees them. */
std::vector<Complex> tapsFromEach (const ModalRecursion& recursion, Eigen::Index mode, Complex turn)
{
    std::vector<Complex> sums (static_cast<std::size_t> (recursion.tapsReal.cols()));
    Complex sum = 0;

    for (auto l = recursion.tapsReal.cols() - 1; l >= 0; --l)
    {
        sum += Complex (recursion.tapsReal (mode, l), recursion.tapsImaginary (mode, l))
               * std::exp (turn * static_cast<double> (l));
        sums[static_cast<std::size_t> (l)] = sum;
    }

    return sums;
}

/** What a unit of force in each sample leaves in the state of a mode. Sample n is tap l of the step that ends at sample
    m = n + reach - l. */
Eigen::VectorXcd modeResponses (const ModalRecursion& recursion, Eigen::Index mode, Complex turn, Eigen::Index samples,
                                Eigen::Index focus)
{
    const auto reach = recursion.tapsReal.cols() - 1 - recursion.latency;
    const auto later = tapsFromEach (recursion, mode, turn);
    const auto taps = static_cast<Eigen::Index> (later.size());
    const auto back = std::exp (-turn);
    Eigen::VectorXcd responses = Eigen::VectorXcd::Zero (samples);
    Complex whole = 0;

    for (Eigen::Index n = 0; n < std::min (samples, focus - reach + taps); ++n)
    {
        const auto firstTap = n + reach - focus;

        if (firstTap > 0)
        {
            responses[n] =
                later[static_cast<std::size_t> (firstTap)] * std::exp (-turn * static_cast<double> (firstTap));
            continue;
        }

        // Products from one exponential to the next.
        whole = n % stepsByProducts == 0 ? later[0] * std::exp (-turn * static_cast<double> (firstTap)) : whole * back;
        responses[n] = whole;
    }

    return responses;
}

Complex weighted (const Eigen::VectorXcd& responses, const Eigen::MatrixXd::ConstColXpr& forces)
{
    return { responses.real().dot (forces), responses.imag().dot (forces) };
}

/** The states of all modes at the instant of a sample. */
Eigen::VectorXcd statesAtSample (const ModalModel& model, const SampledVoltages& voltages, Eigen::Index focus)
{
    const auto recursion = modalRecursion (model, voltages.playback);
    const auto poles = modalPoles (model);
    const Eigen::MatrixXd &values = voltages.values, turned = values.transpose();
    Eigen::MatrixXd forces = Eigen::MatrixXd::Zero (values.cols(), model.participation.rows()); // N_s x N_c
    addTransposedRight (forces, 1, turned, model.participation);
    Eigen::VectorXcd states (model.modes());

    for (Eigen::Index k = 0; k < states.size(); ++k)
    {
        checkWatch();
        const auto responses =
            modeResponses (recursion, k, poles[k] / voltages.playback.sampleRate, values.cols(), focus);
        states[k] = weighted (responses, std::as_const (forces).col (k));

        if (model.hasComplexModes())
            states[k] += Complex (0, 1) * weighted (responses, std::as_const (forces).col (states.size() + k));
    }

    return states;
}
} // namespace

Eigen::MatrixXcd sampleResponses (const ModalModel& model, const std::vector<int>& modes, Playback playback,
                                  Eigen::Index samples, Eigen::Index focus)
{
    const auto recursion = modalRecursion (model, playback);
    const auto poles = modalPoles (model);
    Eigen::MatrixXcd responses (modes.size(), samples);
    constexpr Eigen::Index together = 8; // rows that are written as whole cache lines
    Eigen::MatrixXcd some (samples, together);

    for (Eigen::Index first = 0; first < responses.rows(); first += together)
    {
        checkWatch();
        const auto count = std::min (together, responses.rows() - first);

        for (Eigen::Index k = 0; k < count; ++k)
        {
            const auto mode = modes[static_cast<std::size_t> (first + k)];
            some.col (k) = modeResponses (recursion, mode, poles[mode] / playback.sampleRate, samples, focus);
        }

        responses.middleRows (first, count) = some.leftCols (count).transpose();
    }

    return responses;
}

Eigen::VectorXd voltagesAt (const SampledVoltages& voltages, double time)
{
    return voltagesAtPlace (voltages, (time - voltages.firstTime) * voltages.playback.sampleRate);
}

Eigen::VectorXcd sampledStates (const ModalModel& model, const SampledVoltages& voltages, double time)
{
    constexpr auto onSample = 1e-6;
    const auto place = (time - voltages.firstTime) * voltages.playback.sampleRate;
    const auto below = std::floor (place + onSample);
    Eigen::VectorXcd states = statesAtSample (model, voltages, static_cast<Eigen::Index> (below));

    if (place - below > onSample)
    {
        const auto part = place - below;
        const Eigen::ArrayXcd decayed = (modalPoles (model).array() * (part / voltages.playback.sampleRate)).exp();
        states = (decayed * states.array()).matrix() + addedWithin (model, voltages, below, part);
    }

    return states;
}

double intersamplePeak (const SampledVoltages& voltages)
{
    constexpr auto placesPerSample = 8;
    const auto first = -static_cast<Eigen::Index> (kaiserSincHalfWidth);
    const auto last = voltages.values.cols() + kaiserSincHalfWidth;
    auto peak = voltages.values.size() > 0 ? voltages.values.cwiseAbs().maxCoeff() : 0.0;

    for (auto n = first * placesPerSample; n < last * placesPerSample; ++n)
    {
        checkWatch();
        peak = std::max (peak,
                         voltagesAtPlace (voltages, static_cast<double> (n) / placesPerSample).cwiseAbs().maxCoeff());
    }

    return peak;
}
} // namespace antinode
