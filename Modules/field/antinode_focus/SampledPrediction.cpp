#include "SampledPrediction.h"

#include "Prediction.h"

#include <antinode_base/Watch.h>
#include <antinode_model/ModalRecursion.h>
#include <antinode_numerics/DenseKernels.h>
#include <antinode_numerics/GaussLegendre.h>
#include <antinode_numerics/KaiserSinc.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace antinode
{
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
