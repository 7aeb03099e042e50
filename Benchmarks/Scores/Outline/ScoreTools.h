#pragma once

#include "OutlineScores.h"

#include <antinode_base/MessageText.h>
#include <antinode_structure/BendingProblem.h>

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <ctime>
#include <numbers>
#include <random>
#include <stdexcept>

namespace antinode::scores
{
using namespace examples;
using std::numbers::pi;

/** Random numbers of a seed. */
class Random
{
public:
    explicit Random (unsigned seed) : engine (seed) {}

    double between (double least, double largest)
    {
        return least + (largest - least) * std::uniform_real_distribution<double>() (engine);
    }

    double byDecades (double least, double largest)
    {
        return std::exp (between (std::log (least), std::log (largest)));
    }

    int below (int count) { return std::min (count - 1, static_cast<int> (between (0, count))); }

private:
    std::mt19937 engine;
};

double ownSeconds()
{
    return static_cast<double> (std::clock()) / CLOCKS_PER_SEC;
}

/** Solves and notes the time. */
inline BendingModes timed (OutlineScore& score, const BendingProblem& problem, int count,
                           const ImmersedResolution& resolution)
{
    const auto before = ownSeconds();
    auto modes = bendingModes (problem, count, resolution);
    score.seconds = std::max (score.seconds, ownSeconds() - before);
    ++score.cases;
    return modes;
}

inline void note (double& worst, double error)
{
    worst = std::max (worst, error);
}

inline void note (OutlineScore& score, double error, const std::vector<double>& parameters)
{
    if (! (error > score.frequencyError))
        return;

    score.frequencyError = error;
    score.worst.clear();

    for (const auto parameter : parameters)
        score.worst += " " + inWords (parameter);
}

inline ImmersedResolution smaller (ImmersedResolution resolution, double factor)
{
    resolution.cell *= factor;
    resolution.holeCell *= factor;
    resolution.patchCell *= factor;
    return resolution;
}

inline double frequencyError (const BendingModes& modes, const BendingModes& reference)
{
    return ((modes.eigenvalues.array() / reference.eigenvalues.array()).sqrt() - 1).abs().maxCoeff();
}

/** Of sums over modes that are as close as their errors. The last two only take part in sums: what they are close to
    may not be known. */
inline double participationError (const BendingModes& modes, const BendingModes& reference)
{
    const auto largest = reference.participation.cwiseAbs().maxCoeff();
    double worst = 0;

    for (Eigen::Index k = 0; k + 2 < modes.eigenvalues.size(); ++k)
    {
        const Eigen::ArrayXd isNear = ((reference.eigenvalues.array() / reference.eigenvalues[k]).sqrt() - 1)
                                          .abs()
                                          .unaryExpr ([] (double distance) { return distance < 2e-3 ? 1.0 : 0.0; });
        const auto sum = [&] (const Eigen::MatrixXd& participation) -> Eigen::ArrayXd
        { return (isNear.matrix().asDiagonal() * participation).colwise().norm().transpose().array(); };
        note (worst, (sum (modes.participation) - sum (reference.participation)).abs().maxCoeff() / largest);
    }

    return worst;
}

inline tests::CircularEdge randomEdge (Random& random)
{
    const auto kind = random.below (4);
    return kind == 0   ? tests::CircularEdge {}
           : kind == 1 ? tests::CircularEdge { tests::rigid, 0 }
           : kind == 2 ? tests::CircularEdge { tests::rigid, tests::rigid }
                       : tests::CircularEdge { random.byDecades (1, 1e4), random.byDecades (0.01, 30) };
}

inline EdgeSupport supportOf (const tests::CircularEdge& edge)
{
    const auto isHeld = edge.translation >= tests::rigid, isClamped = edge.rotation >= tests::rigid;
    return { isHeld, isClamped, isHeld ? 0 : edge.translation, isClamped ? 0 : edge.rotation };
}

inline BendingSection less (const BendingSection& a, const BendingSection& b)
{
    return { a.stiffness - b.stiffness, a.massPerArea - b.massPerArea };
}

/** A ceramic pair on a plate of D = m = 1. */
inline BendingSection randomCeramic (Random& random)
{
    return less (isotropicSection (random.between (2, 10), random.between (0.15, 0.4), random.between (1.5, 5)),
                 isotropicSection (1, 0.3, 1));
}

/** Roots of an ascending frequency's function, by its changes of sign and bisection. */
template <typename Function>
std::vector<double> rootsOf (const Function& function, double from, double to, int steps)
{
    std::vector<double> roots;

    for (int i = 0; i < steps; ++i)
    {
        auto low = from + (to - from) * i / steps, high = from + (to - from) * (i + 1) / steps;
        const auto isNegative = function (low) < 0;

        if (isNegative == (function (high) < 0))
            continue;

        for (int step = 0; step < 60; ++step)
        {
            const auto middle = (low + high) / 2;
            ((function (middle) < 0) == isNegative ? low : high) = middle;
        }

        // At a pole the sign changes, too.
        if (std::abs (function (low)) < std::abs (function (from + (to - from) * i / steps)))
            roots.push_back (low);
    }

    return roots;
}
} // namespace antinode::scores
