#include "CubedVoltages.h"

#include <antinode_numerics/Fourier.h>

namespace antinode
{
namespace
{
constexpr double ringing = 256; // samples until what comes round is inaudible
} // namespace

// At twice the rate: what a cube has above that folds back only to where it is removed.
Eigen::MatrixXd cubedVoltages (const Eigen::MatrixXd& voltages)
{
    const auto length = quickLength (static_cast<double> (voltages.cols()) + ringing);
    Eigen::MatrixXd cubes (voltages.rows(), voltages.cols());
    FourierTables tables;

    for (Eigen::Index i = 0; i < voltages.rows(); ++i)
    {
        Eigen::VectorXcd wide = Eigen::VectorXcd::Zero (length + 1);
        const auto lines = length / 2 + 1;
        wide.head (lines) = 2 * tables.forward (voltages.row (i).transpose(), length);
        wide[lines - 1] /= 2; // Half the rate, which is two lines now.
        const Eigen::VectorXd cubed = tables.inverse (wide, 2 * length).array().cube();
        cubes.row (i) = tables.inverse (tables.forward (cubed).head (lines) / 2, length).head (voltages.cols());
    }

    return cubes;
}
} // namespace antinode
