#include "KnownModes.h"

#include "NormalModes.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>
#include <antinode_numerics/DenseKernels.h>
#include <antinode_numerics/Statistics.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>
#include <vector>

namespace antinode
{
namespace
{
constexpr double modelError = 0.1; ///< What known shapes and participations leave of a line, relative.

/** Some lines, so near to each other that no resonance falls between them. */
std::vector<Eigen::Index> chosenLines (const PreparedResponses& data, double leastDamping)
{
    std::vector<Eigen::Index> result;
    double next = 0;

    for (Eigen::Index f = 0; f < data.lines(); ++f)
        if (data.omega[f] >= next)
        {
            result.push_back (f);
            next = data.omega[f] * (1 + 0.5 * leastDamping);
        }

    return result;
}

/** The mean square of a mode's receptance at a line, over all places where its frequency may be. */
double expectedSquare (double omega, double resonance, double damping, double spread)
{
    const auto distance = omega - resonance, half = damping * resonance;
    const auto wide = (spread * spread) * (resonance * resonance) + half * half;
    const auto peak = std::sqrt (std::numbers::pi / (32 * wide)) / half * std::exp (-distance * distance / (2 * wide));
    return peak + 1 / (4 * (distance * distance + wide));
}

/** All lines as what they have in common with each mode, and the mean square of each line. */
struct Projections
{
    Eigen::MatrixXd real, imaginary; ///< Lines x N_m
    Eigen::VectorXd powers, noise;   ///< Lines: sums over the columns of |value|^2 and of the noise's, weighted.
};

/** N_m x C: of all products of shape and participation. */
Eigen::MatrixXd signatures (const PreparedResponses& data, const KnownModes& modes)
{
    Eigen::MatrixXd result (modes.modes(), data.columns());

    for (Eigen::Index i = 0; i < data.references(); ++i)
        result.middleCols (i * data.points(), data.points()) =
            modes.participation.col (i).asDiagonal() * modes.shapes.transpose();

    return result * data.columnWeights.cwiseSqrt().asDiagonal();
}

/** @param weighted  signatures, as above */
Projections project (const PreparedResponses& data, const std::vector<Eigen::Index>& lines,
                     const Eigen::MatrixXd& weighted, double delay)
{
    const auto count = static_cast<Eigen::Index> (lines.size());
    Projections result { Eigen::MatrixXd (count, weighted.rows()), Eigen::MatrixXd (count, weighted.rows()),
                         Eigen::VectorXd (count), Eigen::VectorXd (count) };
    const Eigen::MatrixXd transposed = weighted.transpose();
    const auto roots = data.columnWeights.cwiseSqrt().eval();

    for (Eigen::Index n = 0; n < count; ++n)
    {
        checkWatch();
        // A line differs from the mean of its neighbours by noise, and by little else where lines are fine.
        const auto line = lines[static_cast<std::size_t> (n)];
        const auto first = std::clamp<Eigen::Index> (line - 1, 0, data.lines() - 3);
        auto block = dataBlock (data, first, advances (data, first, 3, delay));
        block.real *= roots.asDiagonal();
        block.imaginary *= roots.asDiagonal();
        result.real.row (n) = block.real.row (line - first) * transposed;
        result.imaginary.row (n) = block.imaginary.row (line - first) * transposed;
        result.powers[n] =
            block.real.row (line - first).squaredNorm() + block.imaginary.row (line - first).squaredNorm();
        const auto second = [] (const Eigen::MatrixXd& values)
        { return (values.row (1) - (values.row (0) + values.row (2)) / 2).squaredNorm() / 1.5; };
        result.noise[n] = second (block.real) + second (block.imaginary);
    }

    return result;
}

/** The modes whose frequency may be near a line: the first and the number of them, of all in ascending order. */
std::pair<Eigen::Index, Eigen::Index> nearModes (const KnownModes& modes, const Eigen::VectorXd& spreads, double omega)
{
    Eigen::Index first = modes.modes(), last = -1;

    for (Eigen::Index k = 0; k < modes.modes(); ++k)
        if (const auto reach = 4 * spreads[k] + 6 * modes.dampingRatios[k];
            std::abs (omega / modes.angularFrequencies[k] - 1) < reach)
        {
            first = std::min (first, k);
            last = std::max (last, k);
        }

    return { first, last < 0 ? 0 : last - first + 1 };
}
} // namespace

ModalReceptances separateModes (const PreparedResponses& data, const KnownModes& modes, const Eigen::VectorXd& spreads,
                                double delay)
{
    const auto lines = chosenLines (data, modes.dampingRatios.minCoeff());
    const auto weighted = signatures (data, modes);
    const auto given = project (data, lines, weighted, delay);
    const auto active = static_cast<double> ((data.columnWeights.array() > 0).count());
    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero (modes.modes(), modes.modes());
    addGram (gram, 1, weighted);
    gram = Eigen::MatrixXd (gram.selfadjointView<Eigen::Lower>());
    const auto count = static_cast<Eigen::Index> (lines.size());
    ModalReceptances result { Eigen::VectorXd (count), Eigen::MatrixXcd::Zero (count, modes.modes()),
                              Eigen::MatrixXd::Zero (count, modes.modes()) };

    for (Eigen::Index n = 0; n < count; ++n)
    {
        checkWatch();
        const auto omega = result.omega[n] = data.omega[lines[static_cast<std::size_t> (n)]];
        const auto [first, near] = nearModes (modes, spreads, omega);

        if (near == 0)
            continue;

        // Modes farther away, and errors of shapes, are as noise.
        const auto variance = (given.noise[n] + modelError * modelError * given.powers[n]) / active;
        Eigen::VectorXd priors (near);

        for (Eigen::Index a = 0; a < near; ++a)
            priors[a] = variance
                        / expectedSquare (omega, modes.angularFrequencies[first + a], modes.dampingRatios[first + a],
                                          spreads[first + a]);

        Eigen::MatrixXd inverse = gram.block (first, first, near, near);
        inverse.diagonal() += priors;

        if (variance <= 0 || ! factorLower (inverse))
            continue;

        inverse = solveFactored (inverse, Eigen::MatrixXd::Identity (near, near));
        const Eigen::VectorXd real = inverse * given.real.row (n).segment (first, near).transpose(),
                              imaginary = inverse * given.imaginary.row (n).segment (first, near).transpose();

        for (Eigen::Index a = 0; a < near; ++a)
        {
            const auto seen = 1 - inverse (a, a) * priors[a];

            if (seen <= 1e-6)
                continue;

            result.values (n, first + a) = std::complex<double> (real[a], imaginary[a]) / seen;
            result.precisions (n, first + a) = seen / (inverse (a, a) * variance);
        }
    }

    return result;
}

namespace
{
using Complex = std::complex<double>;

constexpr double reachOfSearch = 3.5; ///< Standard deviations.
constexpr double leastGain = 8;       ///< Of log likelihood: what chance gives one of some hundred places.
constexpr std::array dampingFactors { 0.55, 0.75, 1.0, 1.35, 1.8 };

/** What is known of one mode's pole before it is looked for. */
struct PolePrior
{
    double centre = 0;    ///< rad/s
    double frequency = 0; ///< Relative standard deviations.
    double dampingRatio = 0, damping = 0;
};

/** A pole that explains what lines say of a mode. */
struct FoundPole
{
    double angularFrequency = 0, dampingRatio = 0;
    double score = 0, gain = 0; ///< Of log posterior, and of log likelihood.
    Complex amplitude;
};

/** What lines near a mode say of it. */
struct NearLines
{
    Eigen::VectorXd omega, precisions;
    Eigen::VectorXcd values;
};

NearLines linesNear (const ModalReceptances& seen, Eigen::Index mode, const PolePrior& prior)
{
    const auto reach = reachOfSearch * prior.frequency + 4 * prior.dampingRatio;
    std::vector<Eigen::Index> lines;

    for (Eigen::Index n = 0; n < seen.omega.size(); ++n)
        if (seen.precisions (n, mode) > 0 && std::abs (seen.omega[n] / prior.centre - 1) < reach)
            lines.push_back (n);

    return { seen.omega (lines), seen.precisions (lines, mode), seen.values (lines, mode) };
}

/** How well one pole explains lines. The amplitude has any phase, a delay, and a length near 1. */
FoundPole tried (const NearLines& lines, double resonance, double damping, const PolePrior& prior)
{
    constexpr double amplitudeSpread = 0.2;
    Complex between;
    double square = 0;

    for (Eigen::Index n = 0; n < lines.omega.size(); ++n)
    {
        const auto omega = lines.omega[n];
        const auto g =
            Complex (0, omega) / Complex ((resonance - omega) * (resonance + omega), 2 * damping * resonance * omega);
        between += lines.precisions[n] * std::conj (g) * lines.values[n];
        square += lines.precisions[n] * std::norm (g);
    }

    FoundPole result { resonance, damping, 0, 0, {} };

    if (square <= 0)
        return result;

    result.amplitude = between / square;
    const auto away = std::abs (result.amplitude) - 1, shift = (resonance / prior.centre - 1) / prior.frequency,
               widening = std::log (damping / prior.dampingRatio) / prior.damping;
    result.gain = std::norm (between) / square / 2;
    result.score = result.gain - away * away / (2 / square + 2 * amplitudeSpread * amplitudeSpread) - shift * shift / 2
                   - widening * widening / 2;
    return result;
}

FoundPole mostProbable (const NearLines& lines, const PolePrior& prior)
{
    FoundPole best { prior.centre, prior.dampingRatio, -1e300, 0, {} };
    const auto step = std::min (prior.dampingRatio, prior.frequency) / 2;
    const auto steps = static_cast<long> (std::ceil (reachOfSearch * prior.frequency / step));

    for (auto n = -steps; n <= steps; ++n)
    {
        checkWatch();

        for (const auto factor : dampingFactors)
            if (const auto pole = tried (lines, prior.centre * (1 + static_cast<double> (n) * step),
                                         prior.dampingRatio * factor, prior);
                pole.score > best.score)
                best = pole;
    }

    return best;
}

/** All modes once, separated with these spreads. */
std::vector<FoundPole> searched (const PreparedResponses& data, const KnownModes& about, const Eigen::VectorXd& spreads,
                                 double dampingSpread, double delay)
{
    const auto seen = separateModes (data, about, spreads, delay);
    std::vector<FoundPole> result;
    result.reserve (static_cast<std::size_t> (about.modes()));

    for (Eigen::Index k = 0; k < about.modes(); ++k)
    {
        checkWatch();
        const PolePrior prior { about.angularFrequencies[k], spreads[k], about.dampingRatios[k], dampingSpread };
        result.push_back (mostProbable (linesNear (seen, k, prior), prior));
    }

    return result;
}

double medianDrift (const std::vector<FoundPole>& poles, const KnownModes& known)
{
    std::vector<double> drifts;

    for (std::size_t k = 0; k < poles.size(); ++k)
        if (poles[k].gain > leastGain)
            drifts.push_back (poles[k].angularFrequency / known.angularFrequencies[static_cast<Eigen::Index> (k)]);

    if (drifts.empty())
        throw InputError ("frequency responses", "contain no mode of the device");

    return median (drifts);
}

/** The delay that makes the amplitudes of all modes positive: signs of shapes and participations are known. */
double commonDelay (const std::vector<FoundPole>& poles)
{
    std::vector<const FoundPole*> seen;
    double highest = 0; // rad/s

    for (const auto& pole : poles)
        if (pole.gain > leastGain)
        {
            seen.push_back (&pole);
            highest = std::max (highest, pole.angularFrequency);
        }

    if (seen.empty())
        return 0;

    const auto score = [&] (double delay)
    {
        double sum = 0;

        for (const auto* pole : seen)
            sum += (pole->amplitude * std::polar (1.0, pole->angularFrequency * delay)).real()
                   / std::max (std::abs (pole->amplitude), 1e-300);

        return sum / static_cast<double> (seen.size());
    };

    // Of many modes fewer agree by chance.
    return searchDelay (score, highest, std::min (0.4, 2 / std::sqrt (static_cast<double> (seen.size()))));
}
} // namespace

KnownPoles findKnownPoles (const PreparedResponses& data, const KnownModes& known, const KnownSpread& spread)
{
    constexpr double found = 0.25; // of a spread: what is left of it where a mode was found
    auto about = known;
    Eigen::VectorXd spreads = Eigen::VectorXd::Constant (known.modes(), std::hypot (spread.frequency, spread.drift));
    // Each search finds what is left of the delay: taken out, it bends resonances no more.
    auto poles = searched (data, about, spreads, spread.damping, 0);
    const auto drift = medianDrift (poles, known);
    auto delay = commonDelay (poles);
    about.angularFrequencies = drift * known.angularFrequencies;
    spreads.setConstant (spread.frequency);
    poles = searched (data, about, spreads, spread.damping, delay);
    delay += commonDelay (poles);

    for (Eigen::Index k = 0; k < known.modes(); ++k)
        if (const auto& pole = poles[static_cast<std::size_t> (k)]; pole.gain > leastGain)
        {
            about.angularFrequencies[k] = pole.angularFrequency;
            about.dampingRatios[k] = pole.dampingRatio;
            spreads[k] = found * spread.frequency;
        }

    poles = searched (data, about, spreads, spread.damping, delay);
    KnownPoles result { about.angularFrequencies, about.dampingRatios, Eigen::VectorXd::Zero (known.modes()), drift,
                        0 };

    for (Eigen::Index k = 0; k < known.modes(); ++k)
        if (const auto& pole = poles[static_cast<std::size_t> (k)]; pole.gain > leastGain)
        {
            result.angularFrequencies[k] = pole.angularFrequency;
            result.dampingRatios[k] = pole.dampingRatio;
            result.gains[k] = pole.gain;
        }

    result.delay = delay + commonDelay (poles);
    return result;
}
} // namespace antinode
