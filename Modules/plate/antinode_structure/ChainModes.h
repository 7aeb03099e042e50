#pragma once

#include "ElementChain.h"

#include <antinode_numerics/Quadrature.h>

namespace antinode
{
/** The motion of one element: places on it x columns of the coefficients. */
struct ElementMotion
{
    Eigen::MatrixXd axial, transverse, slope; ///< Along and across the element, and d transverse / dx.
    Eigen::MatrixXd rotation, shear;          ///< Of cross-sections, and the rest of the slope; without shear 0.
};

/** The motion of a whole chain, element by element. */
struct ChainMotion
{
    std::vector<ElementMotion> elements;
    Eigen::MatrixXd end; ///< 3 x columns: along X, along Y and the rotation of the last end.
};

/** The displacements that a chain can have: on every element a polynomial, across it of the given degree, along it of
   half of it, continuous (across it with the rotation of its sections) from element to element: p-version finite
   elements.

    The coefficients are, first, the free motions of the first end (at most along X, along Y, rotation), then for each
   element those of Legendre polynomials for its curvature and for its strain, so scaled that the strain energy without
   shear is half the sum of the squares of those. Sections shear as balances the growth of their moment. This basis
   spans the same space as Hermite functions with bubbles on every element, but no stiffness of a very short element (a
   narrow gap between two ceramics) ever has to cancel. Docs/Theory.md, section 1.3.
*/
class ChainBasis
{
public:
    /** @param degree  of the transverse displacement, at least 3 */
    ChainBasis (const ElementChain&, int degree);

    /** How many coefficients there are. [any] */
    Eigen::Index unknowns() const;

    /** How many of them, the first ones, move the first end and so have no strain energy. [any] */
    Eigen::Index rigidUnknowns() const { return startMotion.cols(); }

    /** The motion that coefficients describe.
        @param coefficients  unknowns x columns
        @param places        for each element, in -1..1; must end with 1
        [any] */
    ChainMotion motion (const Eigen::MatrixXd& coefficients, const std::vector<Eigen::VectorXd>& places) const;

private:
    ElementMotion elementMotion (std::size_t element, const Eigen::VectorXd& places, const Eigen::MatrixXd& startState,
                                 const Eigen::MatrixXd& coefficients) const;

    ElementChain chain;
    Eigen::Index curvatures, strains; ///< Coefficients of each kind on an element.
    Eigen::MatrixXd startMotion;      ///< 3 x rigid unknowns: the first end's motion.
};

/** The flexible modes of a chain, ascending, to twice the frequency that it was divided for. */
struct ChainModes
{
    Eigen::VectorXd angularFrequencies; ///< rad/s
    Eigen::MatrixXd coefficients;       ///< Of the chain's basis, unknowns x modes: integral m phi_k phi_l = delta_kl.
    int rigidBodyModes = 0;
};

/** The modes of a chain that is divided finely enough for the given frequency.
    @param degree            of the transverse displacement on each element
    @param angularFrequency  the highest that is wanted, rad/s
    @throws InputError       where numbers overflow or too many unknowns would be needed
    [worker] Docs/Theory.md, section 1.3. */
ChainModes solveChain (const ElementChain&, int degree, double angularFrequency);

/** The modal model of a chain's surface: frequencies, shapes, slopes, masses and participations. Points are those of
   Gauss and Lobatto on every element: as many as make the Gram matrix exact, and at least as many as make cubic Hermite
   interpolation between them right to 1e-7 of the largest amplitude, up to the given frequency. Each shape is positive
   where it first exceeds a tenth of its largest amplitude.
    @param chain             divided for the given frequency
    @param modes             of the chain; all of them are handed on
    @param degree            that they were computed with
    @param angularFrequency  the highest that is wanted, rad/s
    @param width             of the surface, m
    @param momentsPerVolt    kappa_b of each ceramic, N m / V
    @return  without names, damping, limits and error estimates
    [worker] Docs/Theory.md, sections 1.2 to 1.5; paper (23). */
ModalModel makeModel (const ElementChain& chain, const ChainModes& modes, int degree, double angularFrequency,
                      double width, const Eigen::VectorXd& momentsPerVolt);
} // namespace antinode
