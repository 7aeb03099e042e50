#include "ChainModes.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>
#include <antinode_numerics/Decompositions.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace antinode
{
namespace
{
constexpr Eigen::Index maximumUnknowns = 3000; ///< Dense matrices: about 300 MB and a minute.

/** The stiffness and mass of a chain on a basis of what its ends allow. */
struct ChainProblem
{
    Eigen::MatrixXd allowed;      ///< Unknowns x allowed: the basis, orthonormal columns.
    Eigen::MatrixXd displacement; ///< B, places x allowed, with M = B' B.
    Eigen::MatrixXd shear;        ///< The same of the energy of shear; empty without.
    Eigen::MatrixXd stiffness, mass;
};

/** a b, which looks at the watch. */
Eigen::MatrixXd watchedProduct (const MatrixIn& a, const MatrixIn& b)
{
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero (a.rows(), b.cols());
    addProduct (result, 1, a, b);
    return result;
}

/** a' a, in the same way. */
Eigen::MatrixXd watchedGram (const MatrixIn& a)
{
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero (a.cols(), a.cols());
    addTransposedLeft (result, 1, a, a);
    return result;
}

/** sqrt (m) times the displacements, and sqrt (I) times the rotations of sections that shear, at the quadrature's
   places, one row per position and direction: B with M = B' B. */
Eigen::MatrixXd weightedMotion (const ElementChain& chain, const ChainMotion& motion, const QuadratureRule& rule)
{
    const auto count = rule.places.size();
    const auto directions = 1 + (chain.stretches ? 1 : 0) + (chain.shears ? 1 : 0);
    Eigen::MatrixXd result (static_cast<Eigen::Index> (chain.elements.size()) * count * directions, motion.end.cols());
    Eigen::Index row = 0;

    for (std::size_t e = 0; e < chain.elements.size(); ++e)
    {
        checkWatch();
        const auto& element = chain.elements[e];
        const Eigen::VectorXd factors =
            (rule.weights * (element.section.massPerLength * element.length / 2)).cwiseSqrt();
        result.middleRows (row, count) = factors.asDiagonal() * motion.elements[e].transverse;
        row += count;

        if (chain.stretches)
        {
            result.middleRows (row, count) = factors.asDiagonal() * motion.elements[e].axial;
            row += count;
        }

        if (chain.shears)
        {
            const auto radius = std::sqrt (element.section.rotaryInertia / element.section.massPerLength);
            result.middleRows (row, count) = radius * factors.asDiagonal() * motion.elements[e].rotation;
            row += count;
        }
    }

    return result;
}

/** What the restraints of the last end forbid: rows that must vanish, scaled to one size. */
Eigen::MatrixXd forbiddenMotions (const ElementChain& chain, const Eigen::MatrixXd& endMotion)
{
    const bool forbidden[] { chain.stretches && chain.end.alongX, chain.end.alongY, chain.end.rotation };
    Eigen::MatrixXd rows (3, endMotion.cols());
    Eigen::Index count = 0;

    for (Eigen::Index direction = 0; direction < 3; ++direction)
        if (forbidden[direction])
            rows.row (count++) = endMotion.row (direction).normalized();

    return rows.topRows (count);
}

/** sqrt (S) times the shear at the quadrature's places: its energy, doubled, is the sum of the squares. */
Eigen::MatrixXd weightedShear (const ElementChain& chain, const ChainMotion& motion, const QuadratureRule& rule)
{
    const auto count = rule.places.size();
    Eigen::MatrixXd result (static_cast<Eigen::Index> (chain.elements.size()) * count, motion.end.cols());

    for (std::size_t e = 0; e < chain.elements.size(); ++e)
    {
        checkWatch();
        const auto& element = chain.elements[e];
        const Eigen::VectorXd factors =
            (rule.weights * (element.section.shearStiffness * element.length / 2)).cwiseSqrt();
        result.middleRows (static_cast<Eigen::Index> (e) * count, count) =
            factors.asDiagonal() * motion.elements[e].shear;
    }

    return result;
}

ChainProblem makeProblem (const ElementChain& chain, const ChainBasis& basis, int degree)
{
    if (basis.unknowns() > maximumUnknowns)
        throw InputError ("device", "needs " + std::to_string (basis.unknowns())
                                        + " unknowns; allowed: " + std::to_string (maximumUnknowns)
                                        + "; choose fewer modes, a lower frequency or fewer ceramics");

    // Exact to degree 2 (degree + 2) - 3, which is more than the degree of the square of a displacement.
    const auto rule = gaussLobattoRule (degree + 2);
    const Eigen::MatrixXd unit = Eigen::MatrixXd::Identity (basis.unknowns(), basis.unknowns());
    const auto motion = basis.motion (unit, std::vector (chain.elements.size(), rule.places));

    ChainProblem problem;
    problem.allowed = nullSpace (forbiddenMotions (chain, motion.end));
    problem.displacement = watchedProduct (weightedMotion (chain, motion, rule), problem.allowed);
    const auto strained = problem.allowed.bottomRows (basis.unknowns() - basis.rigidUnknowns());
    problem.mass = watchedGram (problem.displacement);
    problem.stiffness = watchedGram (strained);

    if (chain.shears)
    {
        problem.shear = watchedProduct (weightedShear (chain, motion, rule), problem.allowed);
        problem.stiffness += watchedGram (problem.shear);
    }

    if (! problem.mass.allFinite() || ! problem.stiffness.allFinite())
        throwNumbersTooFarApart();

    return problem;
}

/** The vectors made orthonormal in M, each against those before it. The mass is formed again from their displacements:
   M itself is rounded relative to the lowest modes, which is much for the highest ones. */
Eigen::MatrixXd massNormalised (const ChainProblem& problem, Eigen::MatrixXd vectors)
{
    auto gram = watchedGram (watchedProduct (problem.displacement, vectors));
    factorLower (gram);
    solveLowerTransposedFromRight (gram, vectors);
    return vectors;
}

/** An angular frequency below that of any flexible mode of a straight beam: what the loosest supports (pinned and
   guided, beta L = pi/2) give if the softest section carries the heaviest mass everywhere. What shear and rotary
   inertia remove is bounded as Dunkerley does: flexibilities and inertias by themselves, their squared periods added.
 */
double lowestPossibleAngularFrequency (const ElementChain& chain)
{
    BeamSection worst = chain.elements.front().section;
    double length = 0;

    for (const auto& element : chain.elements)
    {
        worst.bendingStiffness = std::min (worst.bendingStiffness, element.section.bendingStiffness);
        worst.shearStiffness = std::min (worst.shearStiffness, element.section.shearStiffness);
        worst.massPerLength = std::max (worst.massPerLength, element.section.massPerLength);
        worst.rotaryInertia = std::max (worst.rotaryInertia, element.section.rotaryInertia);
        length += element.length;
    }

    const auto waveNumber = std::numbers::pi / 2 / length, square = waveNumber * waveNumber;
    const auto bending = square * std::sqrt (worst.bendingStiffness / worst.massPerLength);
    const auto more =
        square * (worst.bendingStiffness / worst.shearStiffness + worst.rotaryInertia / worst.massPerLength);
    return bending / std::sqrt (1 + more);
}

/** The strain energy of each mode, doubled, as a frequency: since the mode is good to rounding, this is good to its
   square. Equal ones may come out exchanged by rounding, so none is left below the one before. */
Eigen::VectorXd rayleighFrequencies (const ChainBasis& basis, const ChainProblem& problem,
                                     const Eigen::MatrixXd& vectors, const Eigen::MatrixXd& coefficients)
{
    Eigen::VectorXd squares =
        coefficients.bottomRows (basis.unknowns() - basis.rigidUnknowns()).colwise().squaredNorm();

    if (problem.shear.size() > 0)
        squares += watchedProduct (problem.shear, vectors).colwise().squaredNorm().transpose();

    Eigen::VectorXd frequencies = squares.cwiseSqrt();
    std::partial_sum (frequencies.begin(), frequencies.end(), frequencies.begin(),
                      [] (double a, double b) { return std::max (a, b); });
    return frequencies;
}
} // namespace

ChainModes solveChain (const ElementChain& chain, int degree, double angularFrequency)
{
    // M x = mu (K + sigma M) x, mu = 1 / (omega^2 + sigma): with sigma between the lowest and the highest wanted
    // omega^2 rounding costs every wanted mode only their ratio, once; unshifted it would cost the square.
    const ChainBasis basis (chain, degree);
    const auto problem = makeProblem (chain, basis, degree);
    const auto lowest = lowestPossibleAngularFrequency (chain);
    const auto shift = lowest * angularFrequency;
    const auto solution = generalizedEigen (problem.mass, problem.stiffness + shift * problem.mass);

    if (! solution || ! solution->values.allFinite())
        throwNumbersTooFarApart();

    const Eigen::ArrayXd mu = solution->values.reverse();
    const auto rigid = (mu > 1 / (lowest * lowest / 2 + shift)).count();
    const auto flexible = (mu > 1 / (4 * angularFrequency * angularFrequency + shift)).count() - rigid;
    const Eigen::MatrixXd vectors = solution->vectors.rowwise().reverse().middleCols (rigid, flexible);

    ChainModes modes;
    modes.rigidBodyModes = static_cast<int> (rigid);
    const auto normalised = massNormalised (problem, vectors);
    modes.coefficients = watchedProduct (problem.allowed, normalised);
    modes.angularFrequencies = rayleighFrequencies (basis, problem, normalised, modes.coefficients);
    return modes;
}
} // namespace antinode
