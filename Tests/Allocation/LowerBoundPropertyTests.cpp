#include <antinode_allocation/WaveformBound.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <random>
#include <string>

using namespace antinode;

namespace
{
/** What is odd about a random problem. */
enum class Oddity
{
    none,
    decoupled,       // a ceramic of its own for each mode
    equalPoles,      // modes that differ in participation only
    nearPoles,       // two frequencies 1e-6 to 1e-2 apart
    oneCeramic,      // for all modes
    noParticipation, // a mode that nothing moves and nothing is wanted of, a ceramic that moves nothing
    scales,          // limits, participations and wanted velocities over six decades each
    lightlyDamped,   // down to none
    heavilyDamped,   // up to a = 5 b
    shortDuration,   // a tenth of a cycle of the slowest to one of the fastest
    partlyWanted,    // most modes are to rest
    dependentRows,   // one mode twice: velocities that a waveform brings
    count
};

using Random = std::mt19937;

double uniform (Random& random, double low, double high)
{
    return std::uniform_real_distribution<double> (low, high) (random);
}

double logarithmic (Random& random, double low, double high)
{
    return std::exp (uniform (random, std::log (low), std::log (high)));
}

/** Velocities after a held waveform, by the states of each mode from cell to cell in the order of time: exact for a
   force that is held, and not the integrals of impulse responses that the bound is made of. */
Eigen::VectorXd reachedVelocities (const WaveformBoundProblem& problem, const std::vector<HeldWaveform>& waveforms)
{
    Eigen::VectorXd reached = Eigen::VectorXd::Zero (problem.poles.size());

    for (Eigen::Index k = 0; k < reached.size(); ++k)
    {
        const auto a = -problem.poles[k].real(), b = problem.poles[k].imag(), stiffness = a * a + b * b;

        for (std::size_t i = 0; i < waveforms.size(); ++i)
        {
            const auto& [edges, ratios] = waveforms[i];
            const auto column = static_cast<Eigen::Index> (i);
            const auto gain = problem.participation (k, column) * problem.voltageLimits[column];
            double displacement = 0, velocity = 0;

            for (auto n = ratios.size() - 1; n >= 0; --n)
            {
                const auto time = edges[n + 1] - edges[n], decay = std::exp (-a * time);
                const auto cosine = std::cos (b * time), sine = std::sin (b * time);
                const auto rest = gain * ratios[n] / stiffness, away = displacement - rest;
                displacement = rest + decay * (away * cosine + (velocity + a * away) / b * sine);
                velocity = decay * (velocity * cosine - (a * velocity + stiffness * away) / b * sine);
            }

            reached[k] += velocity;
        }
    }

    return reached;
}

/** Velocities that some waveform brings: cells of random voltages. */
Eigen::VectorXd reachable (const WaveformBoundProblem& problem, Random& random)
{
    std::vector<HeldWaveform> waveforms;

    for (Eigen::Index i = 0; i < problem.voltageLimits.size(); ++i)
    {
        waveforms.push_back ({ Eigen::VectorXd::LinSpaced (8, 0, problem.duration), Eigen::VectorXd (7) });

        for (auto& ratio : waveforms.back().ratios)
            ratio = uniform (random, -1, 1);
    }

    return reachedVelocities (problem, waveforms);
}

WaveformBoundProblem randomProblem (Oddity oddity, Random& random)
{
    const auto fewest =
        oddity == Oddity::noParticipation || oddity == Oddity::dependentRows || oddity == Oddity::nearPoles ? 2 : 1;
    const auto modes = std::uniform_int_distribution<Eigen::Index> (fewest, 4) (random);
    auto ceramics = std::uniform_int_distribution<Eigen::Index> (1, 3) (random);
    ceramics = oddity == Oddity::decoupled ? modes : oddity == Oddity::oneCeramic ? 1 : ceramics;
    ceramics = oddity == Oddity::equalPoles ? std::max (modes, ceramics) : ceramics;
    WaveformBoundProblem problem;
    problem.poles.resize (modes);
    problem.participation.resize (modes, ceramics);
    problem.wanted.resize (modes);
    problem.voltageLimits.resize (ceramics);
    const auto scale = oddity == Oddity::scales ? 1e3 : 2.0;
    const auto damping = [&]
    {
        if (oddity == Oddity::lightlyDamped)
            return uniform (random, 0, 1) < 0.3 ? 0 : logarithmic (random, 1e-9, 1e-4);

        return oddity == Oddity::heavilyDamped ? logarithmic (random, 0.1, 5) : logarithmic (random, 1e-3, 0.1);
    };
    double slowest = 1e9, fastest = 0;

    for (Eigen::Index k = 0; k < modes; ++k)
    {
        const auto frequency = logarithmic (random, 3e3, 3e4);
        slowest = std::min (slowest, frequency);
        fastest = std::max (fastest, frequency);
        problem.poles[k] = { -frequency * damping(), frequency };
        problem.wanted[k] = logarithmic (random, 1 / scale, scale) * (uniform (random, -1, 1) < 0 ? -1 : 1);

        for (Eigen::Index i = 0; i < ceramics; ++i)
            problem.participation (k, i) = logarithmic (random, 1 / scale, scale) * uniform (random, -1, 1);
    }

    for (auto& limit : problem.voltageLimits)
        limit = logarithmic (random, 1 / scale, scale);

    problem.duration = oddity == Oddity::shortDuration
                           ? logarithmic (random, 0.6 / slowest, std::max (6 / fastest, 0.7 / slowest))
                           : logarithmic (random, 6 / slowest, 60 / fastest + 7 / slowest);

    if (oddity == Oddity::decoupled)
        problem.participation = Eigen::VectorXd (problem.participation.diagonal()).asDiagonal();

    if (oddity == Oddity::equalPoles)
        problem.poles.setConstant (problem.poles[0]);

    if (oddity == Oddity::nearPoles)
        problem.poles[modes - 1] = problem.poles[0] * (1 + logarithmic (random, 1e-6, 1e-2));

    if (oddity == Oddity::noParticipation)
    {
        problem.participation.row (0).setZero();
        problem.wanted[0] = 0;

        if (ceramics > 1)
            problem.participation.col (0).setZero();
    }

    if (oddity == Oddity::partlyWanted)
        problem.wanted.tail (modes - 1).setZero();

    if (oddity == Oddity::dependentRows)
    {
        problem.poles[modes - 1] = problem.poles[0];
        problem.participation.row (modes - 1) = 1.7 * problem.participation.row (0);
        problem.wanted = reachable (problem, random);
    }

    return problem;
}

const char* oddityName (Oddity oddity)
{
    constexpr std::array names { "none",           "decoupled",        "equal poles",   "near poles",
                                 "one ceramic",    "no participation", "scales",        "lightly damped",
                                 "heavily damped", "short duration",   "partly wanted", "dependent rows" };
    return names[static_cast<std::size_t> (oddity)];
}
} // namespace

TEST_CASE ("Any waveform's bound has both sides within half a per cent, whatever the modes", "[lowerBound][processors]")
{
    constexpr int problems = 10000;

    for (int n = 0; n < problems; ++n)
    {
        Random random (static_cast<unsigned> (n));
        const auto oddity = static_cast<Oddity> (n % static_cast<int> (Oddity::count));
        const auto problem = randomProblem (oddity, random);
        const auto bound = anyWaveformPeakBound (problem);
        INFO ("problem " << n << ", " << oddityName (oddity) << ", lower " << bound.lower << ", upper " << bound.upper);
        double peak = 0;

        for (const auto& waveform : bound.waveforms)
            peak = std::max (peak, waveform.ratios.cwiseAbs().maxCoeff());

        // Held to the bound's own promise: rows to 1e-9 of what is wanted, or to rounding beside what the voltages
        // bring one by one.
        const Eigen::VectorXd reached = reachedVelocities (problem, bound.waveforms);
        const Eigen::VectorXd single =
            (problem.participation.cwiseAbs() * problem.voltageLimits).cwiseQuotient (problem.poles.cwiseAbs());
        const Eigen::ArrayXd allowed = 2e-9 * problem.wanted.array().abs() + 1e-11 * peak * single.array();
        const auto isReached = ((reached - problem.wanted).array().abs() <= allowed).all();

        // One check a problem keeps the report of 10000 short.
        const auto isRight = bound.gap <= 0.005 && bound.lower <= bound.upper && bound.lower > 0
                             && bound.waveforms.size() > 0 && isReached && peak <= bound.upper * (1 + 1e-12)
                             && bound.gap == Approx (1 - bound.lower / bound.upper).margin (1e-12);
        CHECK (isReached);
        CHECK (isRight);
    }
}
