#include "RitzPairs.h"

#include "Decompositions.h"

namespace antinode
{
std::optional<Eigenpairs> ritzPairsBehind (const MassProduct& stiffness, const MassProduct& mass,
                                           const Eigen::MatrixXd& modes, Eigen::MatrixXd columns)
{
    const Eigen::MatrixXd weighted = mass (modes);

    for (int pass = 0; pass < 2; ++pass) // the second removes what rounding left
    {
        columns -= modes * (weighted.transpose() * columns);
        columns.colwise().normalize();
    }

    const auto ritz =
        generalizedEigen (columns.transpose() * stiffness (columns), columns.transpose() * mass (columns));

    if (! ritz || ! (ritz->values[0] > 0))
        return std::nullopt;

    return Eigenpairs { ritz->values, columns * ritz->vectors };
}
} // namespace antinode
