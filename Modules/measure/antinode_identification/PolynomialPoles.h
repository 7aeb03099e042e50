#pragma once

#include "Compression.h"

#include <functional>

namespace antinode
{
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
