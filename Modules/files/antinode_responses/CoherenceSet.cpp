#include "CoherenceSet.h"

namespace antinode
{
UniversalFunction coherenceSet (UniversalFunction function, const Eigen::VectorXd& values)
{
    constexpr int coherenceType = 6, singleRealType = 2;
    function.functionType = coherenceType;
    function.ordinateType = singleRealType;
    function.lines[0] = "Coherence of velocity and drive";
    function.ordinate = {};
    function.denominator = {};
    function.values = values.cast<std::complex<double>>();
    return function;
}
} // namespace antinode
