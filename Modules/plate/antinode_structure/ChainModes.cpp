#include "ChainModes.h"

#include "DescribedModel.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>
#include <antinode_numerics/Decompositions.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <numeric>

namespace antinode
{
namespace
{
/** Factors that make Legendre polynomials on an element a basis of strain energy 1/2 each. */
Eigen::VectorXd energyScales (Eigen::Index count, double length, double stiffness)
{
    const Eigen::ArrayXd degrees = Eigen::ArrayXd::LinSpaced (count, 0, static_cast<double> (count - 1));
    return ((2 * degrees + 1) / (length * stiffness)).sqrt().matrix();
}

/** The free motions of the first end, each of a size like what an element's unit of bending does over the chain's
    length. */
Eigen::MatrixXd freeMotions (const ElementChain& chain)
{
    double length = 0;

    for (const auto& element : chain.elements)
        length += element.length;

    const auto rotation = std::sqrt (length / chain.elements.front().section.bendingStiffness);
    Eigen::MatrixXd motions = Eigen::MatrixXd::Zero (3, 3);
    Eigen::Index count = 0;

    if (chain.stretches && ! chain.start.alongX)
        motions (0, count++) = rotation * length;

    if (! chain.start.alongY)
        motions (1, count++) = rotation * length;

    if (! chain.start.rotation)
        motions (2, count++) = rotation;

    return motions.leftCols (count);
}
} // namespace

ChainBasis::ChainBasis (const ElementChain& chainToUse, int degree)
    : chain (chainToUse), curvatures (degree - 1), strains (chainToUse.stretches ? degree / 2 : 0),
      startMotion (freeMotions (chainToUse))
{
}

Eigen::Index ChainBasis::unknowns() const
{
    return rigidUnknowns() + static_cast<Eigen::Index> (chain.elements.size()) * (curvatures + strains);
}

ChainMotion ChainBasis::motion (const Eigen::MatrixXd& coefficients, const std::vector<Eigen::VectorXd>& places) const
{
    ChainMotion result;
    Eigen::MatrixXd state = startMotion * coefficients.topRows (rigidUnknowns());
    const auto perElement = curvatures + strains;

    for (std::size_t e = 0; e < chain.elements.size(); ++e)
    {
        const auto first = rigidUnknowns() + static_cast<Eigen::Index> (e) * perElement;
        result.elements.push_back (elementMotion (e, places[e], state, coefficients.middleRows (first, perElement)));

        const auto& element = chain.elements[e];
        const auto& moved = result.elements.back();
        const auto last = places[e].size() - 1;
        state.row (0) = element.cosine * moved.axial.row (last) - element.sine * moved.transverse.row (last);
        state.row (1) = element.sine * moved.axial.row (last) + element.cosine * moved.transverse.row (last);
        state.row (2) = moved.rotation.row (last);
    }

    result.end = state;
    return result;
}

ElementMotion ChainBasis::elementMotion (std::size_t index, const Eigen::VectorXd& places,
                                         const Eigen::MatrixXd& startState, const Eigen::MatrixXd& coefficients) const
{
    const auto& element = chain.elements[index];
    const auto half = element.length / 2;
    const auto integrals = legendreIntegrals (places, curvatures);
    const Eigen::MatrixXd bent =
        energyScales (curvatures, element.length, element.section.bendingStiffness).asDiagonal()
        * coefficients.topRows (curvatures);
    const Eigen::VectorXd along = half * (places.array() + 1).matrix();
    const Eigen::RowVectorXd axial = element.cosine * startState.row (0) + element.sine * startState.row (1);
    const Eigen::RowVectorXd transverse = element.cosine * startState.row (1) - element.sine * startState.row (0);

    ElementMotion result;
    result.axial = axial.replicate (places.size(), 1);
    result.transverse = half * half * integrals.twice * bent + along * startState.row (2);
    result.transverse.rowwise() += transverse;
    result.rotation = half * integrals.once * bent;
    result.rotation.rowwise() += startState.row (2);
    result.slope = result.rotation;

    if (strains > 0)
        result.axial += half * integrals.once.leftCols (strains)
                        * energyScales (strains, element.length, element.section.axialStiffness).asDiagonal()
                        * coefficients.bottomRows (strains);

    if (chain.shears)
    {
        // S gamma = -M': the moment's growth. Its integral is the moment, from the element's start.
        const auto perCurvature = -element.section.bendingStiffness / element.section.shearStiffness;
        const Eigen::MatrixXd polynomials = legendrePolynomials (places, curvatures);
        const Eigen::RowVectorXd atStart = legendrePolynomials (Eigen::VectorXd::Constant (1, -1), curvatures).row (0);
        result.shear = perCurvature / half * legendreSlopes (places, curvatures) * bent;
        result.slope += result.shear;
        result.transverse += perCurvature * (polynomials.rowwise() - atStart) * bent;
    }

    return result;
}

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

namespace
{
/** The places on an element where its motion is handed on. */
Eigen::Index pointCount (const ChainElement& element, int degree, double angularFrequency)
{
    // The rule's widest gap is about pi/2 times its mean one. A gap g interpolates a wave of wave number k with an
    // error of (k g)^4 / 384 of its amplitude, so k g < 0.0787 keeps it below 1e-7.
    constexpr double gapsPerPhase = 1.571 / 0.0787;
    const auto phase = bendingWaveNumber (element.section, angularFrequency) * element.length;
    return std::max<Eigen::Index> (degree + 2, 1 + static_cast<Eigen::Index> (std::ceil (gapsPerPhase * phase)));
}

/** A rule for every element: that of its points on the surface, and elsewhere just its last end. */
std::vector<QuadratureRule> surfaceRules (const ElementChain& chain, int degree, double angularFrequency)
{
    const QuadratureRule lastEnd { Eigen::VectorXd::Ones (1), Eigen::VectorXd::Zero (1) };
    std::vector<QuadratureRule> rules;
    std::transform (chain.elements.begin(), chain.elements.end(), std::back_inserter (rules),
                    [&] (const ChainElement& element) {
                        return element.onSurface ? gaussLobattoRule (pointCount (element, degree, angularFrequency))
                                                 : lastEnd;
                    });
    return rules;
}

/** Room for all points; neighbouring elements share one. */
void resize (ModalModel& model, const ElementChain& chain, const std::vector<QuadratureRule>& rules, Eigen::Index modes)
{
    Eigen::Index points = 1;

    for (std::size_t e = 0; e < rules.size(); ++e)
        if (chain.elements[e].onSurface)
            points += rules[e].places.size() - 1;

    model.surface.points = Eigen::MatrixX2d::Zero (points, 2);
    model.surface.masses = Eigen::VectorXd::Zero (points);
    model.surface.areas = Eigen::VectorXd::Zero (points);
    model.shapes.resize (points, modes);
    model.slopes.resize (points, modes);
}

/** Writes an element's points from the given row on; the first row is shared with the element before. */
void writeElement (ModalModel& model, Eigen::Index row, const ChainElement& element, const QuadratureRule& rule,
                   const ElementMotion& motion, double width)
{
    const auto count = rule.places.size();
    const Eigen::VectorXd lengths = rule.weights * (element.length / 2);
    model.surface.points.col (0).segment (row, count) =
        (element.start + element.length / 2 * (rule.places.array() + 1)).matrix();
    model.surface.masses.segment (row, count) += element.section.massPerLength * lengths;
    model.surface.areas.segment (row, count) += width * lengths;
    model.shapes.middleRows (row, count) = motion.transverse;
    model.slopes.middleRows (row, count) = motion.slope;
}
} // namespace

ModalModel makeModel (const ElementChain& chain, const ChainModes& modes, int degree, double angularFrequency,
                      double width, const Eigen::VectorXd& momentsPerVolt)
{
    const auto rules = surfaceRules (chain, degree, angularFrequency);
    std::vector<Eigen::VectorXd> places;
    std::transform (rules.begin(), rules.end(), std::back_inserter (places),
                    [] (const auto& rule) { return rule.places; });
    const auto motion = ChainBasis (chain, degree).motion (modes.coefficients, places);

    ModalModel model;
    model.angularFrequencies = modes.angularFrequencies;
    model.rigidBodyModes = modes.rigidBodyModes;
    model.unknowns = static_cast<int> (modes.coefficients.rows());
    model.participation = Eigen::MatrixXd::Zero (modes.angularFrequencies.size(), momentsPerVolt.size());
    resize (model, chain, rules, modes.angularFrequencies.size());
    Eigen::Index row = 0;

    for (std::size_t e = 0; e < rules.size(); ++e)
    {
        const auto& element = chain.elements[e];
        const auto& slope = motion.elements[e].slope;

        if (! element.onSurface)
            continue;

        writeElement (model, row, element, rules[e], motion.elements[e], width);
        row += rules[e].places.size() - 1;

        if (element.ceramic)
            model.participation.col (*element.ceramic) +=
                momentsPerVolt[*element.ceramic] * (slope.row (slope.rows() - 1) - slope.row (0)).transpose();
    }

    model.surface.xMinimum = model.surface.points (0, 0);
    model.surface.xMaximum = model.surface.points (row, 0);
    settleSigns (model);
    return model;
}
} // namespace antinode
