#include "ChainBasis.h"

#include <cmath>

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
} // namespace antinode
