#pragma once

#include "PreparedResponses.h"

#include <functional>

namespace antinode
{
/** Responses of one band, as few outputs and few references that hold nearly all of their energy. N lines. */
struct CompressedBand
{
    Eigen::VectorXd omega;                ///< N: rad/s
    std::vector<Eigen::MatrixXcd> values; ///< One a reference, N x outputs.

    Eigen::Index lines() const { return omega.size(); }
    Eigen::Index outputs() const { return values.front().cols(); }
    Eigen::Index references() const { return static_cast<Eigen::Index> (values.size()); }
};

/** Projects the lines of a band on the strongest real directions of points and of references: noise outside of them is
   gone, and real modes stay real. Weights of points and references are in the values.
    @param first, count   lines
    @param outputs, references  the largest numbers
    [worker] Docs/Theory.md, section 8.2. */
CompressedBand compress (const PreparedResponses&, Eigen::Index first, Eigen::Index count, Eigen::Index outputs,
                         Eigen::Index references);

/** The stable poles of one model order, with what distinguishes modes of nearly equal poles. N poles. */
struct OrderPoles
{
    int order = 0;
    Eigen::VectorXcd poles;         ///< N: s, 1/s; negative real parts, positive imaginary ones.
    Eigen::MatrixXcd participation; ///< N x references, each row of length 1.
};

/** Poles by the poly-reference least-squares complex-frequency method (pLSCF) in a right matrix fraction with complex
    coefficients, for each order of a range from one set of sums. The lowest coefficient is the unit matrix: then poles
   that stand for noise are unstable, and those that are left are nearly all physical.
    @param ridge     relative, on the diagonal of the normal equations
    @param isEnough  looks at the orders so far, from the lowest one on; where it is true the others are left out
    [worker] Docs/Theory.md, section 8.2; Peeters, Van der Auweraer, Guillaume, Leuridan, Shock and Vibration 11 (2004)
   395. */
std::vector<OrderPoles> polynomialPoles (const CompressedBand&, int minimumOrder, int maximumOrder, double ridge,
                                         const std::function<bool (const std::vector<OrderPoles>&)>& isEnough);
} // namespace antinode
