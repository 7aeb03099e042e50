#include "OutlineScores.h"

#include <antinode_base/NumberText.h>
#include <antinode_immersed/PatchShapes.h>

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <ctime>
#include <numbers>
#include <random>
#include <stdexcept>

namespace antinode::scores
{
namespace
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
BendingModes timed (OutlineScore& score, const BendingProblem& problem, int count, const ImmersedResolution& resolution)
{
    const auto before = ownSeconds();
    auto modes = bendingModes (problem, count, resolution);
    score.seconds = std::max (score.seconds, ownSeconds() - before);
    ++score.cases;
    return modes;
}

void note (double& worst, double error)
{
    worst = std::max (worst, error);
}

void note (OutlineScore& score, double error, const std::vector<double>& parameters)
{
    if (! (error > score.frequencyError))
        return;

    score.frequencyError = error;
    score.worst.clear();

    for (const auto parameter : parameters)
        score.worst += " " + inWords (parameter);
}

ImmersedResolution smaller (ImmersedResolution resolution, double factor)
{
    resolution.cell *= factor;
    resolution.holeCell *= factor;
    resolution.patchCell *= factor;
    return resolution;
}

double frequencyError (const BendingModes& modes, const BendingModes& reference)
{
    return ((modes.eigenvalues.array() / reference.eigenvalues.array()).sqrt() - 1).abs().maxCoeff();
}

/** Of sums over modes that are as close as their errors. The last two only take part in sums: what they are close to
    may not be known. */
double participationError (const BendingModes& modes, const BendingModes& reference)
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

tests::CircularEdge randomEdge (Random& random)
{
    const auto kind = random.below (4);
    return kind == 0   ? tests::CircularEdge {}
           : kind == 1 ? tests::CircularEdge { tests::rigid, 0 }
           : kind == 2 ? tests::CircularEdge { tests::rigid, tests::rigid }
                       : tests::CircularEdge { random.byDecades (1, 1e4), random.byDecades (0.01, 30) };
}

EdgeSupport supportOf (const tests::CircularEdge& edge)
{
    const auto isHeld = edge.translation >= tests::rigid, isClamped = edge.rotation >= tests::rigid;
    return { isHeld, isClamped, isHeld ? 0 : edge.translation, isClamped ? 0 : edge.rotation };
}

BendingSection less (const BendingSection& a, const BendingSection& b)
{
    return { a.stiffness - b.stiffness, a.massPerArea - b.massPerArea };
}

/** A ceramic pair on a plate of D = m = 1. */
BendingSection randomCeramic (Random& random)
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
} // namespace

OutlineScore roundPlates (int cases, unsigned seed, ModeAccuracy accuracy)
{
    Random random (seed);
    OutlineScore score { accuracy == ModeAccuracy::usual ? "circles and rings, any edges, 50 modes, usual cells"
                                                         : "the same on request" };

    for (int i = 0; i < cases; ++i)
    {
        const auto hole = i % 2 == 0 ? 0 : random.between (0.05, 0.8);
        const auto inner = randomEdge (random), outer = randomEdge (random);
        const auto ratio = random.between (0.05, 0.45);
        std::vector<ClosedPath> paths { circlePath ({ random.between (0, 1), random.between (0, 1) }, 1, 0) };

        if (hole > 0)
            paths.push_back (circlePath (paths[0][0].centre, hole, 1));

        const auto problem = unitPlate (ratio, paths, { supportOf (outer), supportOf (inner) });
        const auto modes = timed (score, problem, 50, resolutionFor (problem, 50, accuracy));
        const tests::CircularPlate exact { hole, { { 1, 1, ratio, 1 } }, inner, outer };
        note (score, deviationFrom (frequencies (modes), exact),
              { hole, ratio, inner.translation, inner.rotation, outer.translation, outer.rotation });
    }

    return score;
}

OutlineScore shiftedAndTurned (int cases, unsigned seed)
{
    Random random (seed);
    OutlineScore score { "rounded rectangles with a hole, shifted and turned, 30 modes" };
    const auto support = std::array { freeEdge, supportedEdge, clampedEdge };

    for (int i = 0; i < cases; ++i)
    {
        const auto sizeY = random.between (0.4, 1), radius = random.between (0.05, 0.15),
                   ratio = random.between (0.1, 0.4);
        const auto& edge = support[static_cast<std::size_t> (i % 3)];
        auto problem =
            unitPlate (ratio,
                       { rectanglePath ({ 0.5, sizeY / 2 }, { 1, sizeY }, 0, { radius, radius, radius, radius }, 0),
                         circlePath ({ random.between (0.3, 0.7), sizeY / 2 }, random.between (0.03, 0.1), 4) },
                       { edge, edge, edge, edge, freeEdge });
        const auto straight = bendingModes (problem, 30, resolutionFor (problem, 30, ModeAccuracy::high));
        problem.outline =
            moved (problem.outline, random.between (0, 2 * pi), { random.between (0, 1), random.between (0, 1) });
        auto resolution = resolutionFor (problem, 30, ModeAccuracy::usual);
        resolution.offset = random.between (0.01, 0.99);
        const auto modes = timed (score, problem, 30, resolution);

        if (modes.rigidBodyModes != (i % 3 == 0 ? 3 : 0))
            throw std::runtime_error ("a rigid motion is missing or false");

        note (score.frequencyError, frequencyError (modes, straight));
    }

    return score;
}

OutlineScore plateaus (int cases, unsigned seed)
{
    Random random (seed);
    OutlineScore score { "a disc of a ceramic amid a circle, 50 modes" };

    for (int i = 0; i < cases; ++i)
    {
        const auto radius = random.between (0.08, 0.3);
        const auto outer =
            i % 2 == 0 ? tests::CircularEdge {} : tests::CircularEdge { tests::rigid, i % 4 == 1 ? 0 : tests::rigid };
        const tests::PlateRing inner { radius, random.between (2, 8), random.between (0.1, 0.4),
                                       random.between (1.5, 4) };
        const Eigen::Vector2d centre (random.between (0, 1), random.between (0, 1));
        auto problem = unitPlate (0.22, { circlePath (centre, 1, 0) }, { supportOf (outer) });
        auto disc = discPatch (centre, radius);
        disc.added = less (isotropicSection (inner.stiffness, inner.poissonRatio, inner.massPerArea), problem.section);
        disc.moment << 1, 1, 0;
        problem.patches = { disc };
        const auto modes = timed (score, problem, 50, resolutionFor (problem, 50, ModeAccuracy::usual));
        const tests::CircularPlate exact { 0, { inner, { 1, 1, 0.22, 1 } }, {}, outer };
        const auto expected = tests::circularModes (exact, 50);
        Eigen::VectorXd fluxes (50), found (50);

        for (Eigen::Index k = 0; k < 50; ++k)
        {
            const auto& mode = expected[static_cast<std::size_t> (k)];
            fluxes[k] =
                mode.diameters > 0 ? 0 : 2 * pi * radius * std::abs (slopeAtFirstRing (exact, mode.angularFrequency));
            note (
                score, std::abs (std::sqrt (modes.eigenvalues[k]) / mode.angularFrequency - 1),
                { radius, inner.stiffness, inner.poissonRatio, inner.massPerArea, outer.translation, outer.rotation });
        }

        // Of modes as close as their errors the sum counts.
        for (Eigen::Index k = 0; k < 50; ++k)
        {
            double sum = 0, exactSum = 0;

            for (Eigen::Index l = 0; l < 50; ++l)
                if (std::abs (expected[static_cast<std::size_t> (l)].angularFrequency
                                  / expected[static_cast<std::size_t> (k)].angularFrequency
                              - 1)
                    < 1e-3)
                {
                    sum += std::pow (modes.participation (l, 0), 2);
                    exactSum += fluxes[l] * fluxes[l];
                }

            note (score.participationError, std::abs (std::sqrt (sum) - std::sqrt (exactSum)) / fluxes.maxCoeff());
        }
    }

    return score;
}

OutlineScore turnedSquares (int cases, unsigned seed)
{
    Random random (seed);
    OutlineScore score { "a square of a ceramic, turned, 20 modes, against smaller cells" };

    for (int i = 0; i < cases; ++i)
    {
        const auto sizeY = random.between (0.5, 1), width = random.between (0.1, 0.2);
        auto problem = unitPlate (0.3, { rectanglePath ({ 0.5, sizeY / 2 }, { 1, sizeY }, 0, { 0, 0, 0, 0 }, 0) },
                                  { 4, i % 2 == 0 ? supportedEdge : freeEdge });
        auto square = rectanglePatch ({ random.between (0.2, 0.8), random.between (0.2, sizeY - 0.2) },
                                      { width, width * random.between (0.6, 1) }, random.between (0.05, pi / 2 - 0.05));
        square.added = randomCeramic (random);
        square.moment << 1, 1, 0;
        problem.patches = { square };
        const auto resolution = resolutionFor (problem, 20, ModeAccuracy::usual);
        const auto modes = timed (score, problem, 22, resolution);
        const auto reference = bendingModes (problem, 22, smaller (resolution, 0.5));
        note (score.frequencyError, frequencyError (modes, reference));
        note (score.participationError, participationError (modes, reference));
    }

    return score;
}

OutlineScore reentrantCorners (int cases, unsigned seed)
{
    Random random (seed);
    OutlineScore score { "L and notches, 12 modes, against cells of a half" };

    for (int i = 0; i < cases; ++i)
    {
        const auto x = random.between (0.3, 0.6), y = random.between (0.3, 0.6), end = x + random.between (0.1, 0.3);
        const auto corners =
            i % 2 == 0 ? std::vector<Eigen::Vector2d> { { 0, 0 }, { 1, 0 }, { 1, y }, { x, y }, { x, 1 }, { 0, 1 } }
                       : std::vector<Eigen::Vector2d> { { 0, 0 },   { 1, 0 }, { 1, 0.7 }, { end, 0.7 },
                                                        { end, y }, { x, y }, { x, 0.7 }, { 0, 0.7 } };
        auto problem =
            unitPlate (random.between (0.1, 0.4), { polygonPath (corners, 0) }, { corners.size(), freeEdge });

        if (i % 4 > 1)
            problem.edges.back() = clampedEdge;

        const auto resolution = resolutionFor (problem, 20, ModeAccuracy::usual);
        const auto modes = timed (score, problem, 12, resolution);
        note (score.frequencyError, frequencyError (modes, bendingModes (problem, 12, smaller (resolution, 0.5))));
    }

    return score;
}

OutlineScore levyPlates (int cases, unsigned seed)
{
    Random random (seed);
    OutlineScore score { "rectangles, two sides supported, two on springs, 20 modes" };

    for (int i = 0; i < cases; ++i)
    {
        const auto b = random.between (0.4, 1), ratio = random.between (0.1, 0.4);
        const EdgeSupport low { false, false, random.byDecades (1, 3e3), random.byDecades (0.05, 20) };
        const EdgeSupport high { false, false, random.byDecades (1, 3e3), random.byDecades (0.05, 20) };
        const auto problem = unitPlate (ratio, { rectanglePath ({ 0.5, b / 2 }, { 1, b }, 0, { 0, 0, 0, 0 }, 0) },
                                        { low, supportedEdge, high, supportedEdge });
        const auto found = frequencies (timed (score, problem, 20, resolutionFor (problem, 20, ModeAccuracy::usual)));
        std::vector<double> exact;

        // w = sin (m pi x) f (y): f of cos, sin, cosh, sinh, the last two by exponentials of the sides.
        for (int m = 1; m < 12; ++m)
        {
            const auto mu = m * pi;
            const auto determinant = [&] (double omega)
            {
                const auto p = std::sqrt (omega + mu * mu), q2 = omega - mu * mu, q = std::sqrt (std::abs (q2));
                Eigen::Matrix4d rows;

                for (int column = 0; column < 4; ++column)
                {
                    const auto values = [&] (double y) -> Eigen::Vector4d // f, f', f'', f'''
                    {
                        if (column < 2)
                        {
                            const auto s = column == 0 ? -1.0 : 1.0, e = std::exp (column == 0 ? -p * y : p * (y - b));
                            return { e, s * p * e, p * p * e, s * p * p * p * e };
                        }

                        const auto wave = column == 2;

                        if (q2 >= 0)
                        {
                            const auto c = std::cos (q * y), s = std::sin (q * y);
                            return wave ? Eigen::Vector4d (c, -q * s, -q * q * c, q * q * q * s)
                                        : Eigen::Vector4d (s, q * c, -q * q * s, -q * q * q * c);
                        }

                        const auto c = std::cosh (q * y), s = std::sinh (q * y);
                        return wave ? Eigen::Vector4d (c, q * s, q * q * c, q * q * q * s)
                                    : Eigen::Vector4d (s, q * c, q * q * s, q * q * q * c);
                    };
                    const auto side = [&] (double y, double sign, const EdgeSupport& support, int row)
                    {
                        const auto f = values (y);
                        rows (row, column) = f[2] - ratio * mu * mu * f[0] + sign * support.rotation * f[1];
                        rows (row + 1, column) =
                            f[3] - (2 - ratio) * mu * mu * f[1] - sign * support.translation * f[0];
                    };
                    side (0, -1, low, 0);
                    side (b, 1, high, 2);
                }

                for (int row = 0; row < 4; ++row)
                    rows.row (row).normalize();

                return rows.determinant();
            };

            for (const auto root : rootsOf (determinant, 0.5, 1.1 * found[19], 4000))
                if (std::abs (root - mu * mu) > 1e-6 * root) // there both waves are lines
                    exact.push_back (root);
        }

        std::sort (exact.begin(), exact.end());
        exact.resize (20);
        note (score.frequencyError, deviationFrom (found, exact));
    }

    return score;
}

OutlineScore attachedPoints (int cases, unsigned seed)
{
    Random random (seed);
    OutlineScore score { "a mass or a spring at a point of a supported rectangle, 20 modes" };

    for (int i = 0; i < cases; ++i)
    {
        const auto b = random.between (0.5, 1);
        const PointAttachment point { { random.between (0.1, 0.9), random.between (0.1, b - 0.1) },
                                      i % 2 == 0 ? 0 : random.between (20, 500),
                                      i % 2 == 0 ? random.between (0.01, 0.1) : 0 };
        auto problem =
            unitPlate (0.3, { rectanglePath ({ 0.5, b / 2 }, { 1, b }, 0, { 0, 0, 0, 0 }, 0) }, { 4, supportedEdge });
        problem.points = { point };
        const auto found = frequencies (timed (score, problem, 20, resolutionFor (problem, 20, ModeAccuracy::usual)));
        constexpr int waves = 1000;
        Eigen::ArrayXXd squares (waves, waves), eigenvalues (waves, waves);

        for (int n = 0; n < waves; ++n)
            for (int m = 0; m < waves; ++m)
            {
                const auto kx = (m + 1) * pi, ky = (n + 1) * pi / b;
                squares (m, n) =
                    std::pow (2 / std::sqrt (b) * std::sin (kx * point.place.x()) * std::sin (ky * point.place.y()), 2);
                eigenvalues (m, n) = std::pow (kx * kx + ky * ky, 2);
            }

        // 1 + (k - M omega^2) sum phi^2 / (omega_mn^2 - omega^2) at a frequency that is right, in units of its slope.
        for (Eigen::Index k = 0; k < 20; ++k)
        {
            const auto lambda = found[k] * found[k];
            const auto distance = (eigenvalues - lambda).eval();

            if (distance.abs().minCoeff() < 1e-5 * lambda)
                continue; // It does not move there, or hardly.

            const auto strength = point.stiffness - point.mass * lambda;
            const auto receptance = (squares / distance).sum();
            const auto slope = strength * (squares / distance.square()).sum() - point.mass * receptance;
            note (score.frequencyError, std::abs ((1 + strength * receptance) / slope / lambda / 2));
        }
    }

    return score;
}

OutlineScore eightPatches (unsigned seed, bool areDiscs)
{
    Random random (seed);
    OutlineScore score { areDiscs ? "eight discs on a rounded rectangle, 50 modes, against smaller cells"
                                  : "eight turned squares on it, 50 modes, against smaller cells" };
    auto problem = unitPlate (0.22, { rectanglePath ({ 0.5, 0.35 }, { 1, 0.7 }, 0, { 0.05, 0.05, 0.05, 0.05 }, 0) },
                              { 4, freeEdge });
    const auto added = randomCeramic (random);

    for (int i = 0; i < 8; ++i)
    {
        const Eigen::Vector2d centre (0.14 + 0.24 * (i % 4) + random.between (-0.03, 0.03),
                                      (i < 4 ? 0.17 : 0.53) + random.between (-0.03, 0.03));
        auto patch =
            areDiscs ? discPatch (centre, 0.06) : rectanglePatch (centre, { 0.11, 0.11 }, random.between (0.1, 1.4));
        patch.added = added;
        patch.moment << 1, 1, 0;
        problem.patches.push_back (patch);
    }

    const auto resolution = resolutionFor (problem, 50, ModeAccuracy::usual);
    const auto modes = timed (score, problem, 50, resolution);
    const auto reference = bendingModes (problem, 50, smaller (resolution, 0.75));
    note (score.frequencyError, frequencyError (modes, reference));
    note (score.participationError, participationError (modes, reference));
    return score;
}
} // namespace antinode::scores
