#include "TrackAlignment.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/Fourier.h>

#include <limits>

namespace antinode
{
TrackAlignment alignTracks (const Eigen::MatrixXd& reached, const Eigen::MatrixXd& wanted)
{
    // As long as both: no end of a signal meets the beginning of the other.
    const auto length = quickLength (static_cast<double> (reached.cols() + wanted.rows()));
    Eigen::VectorXcd products = Eigen::VectorXcd::Zero (length / 2 + 1);

    for (Eigen::Index p = 0; p < wanted.cols(); ++p)
    {
        checkWatch();
        const Eigen::VectorXd motion = reached.row (p).transpose(), asked = wanted.col (p);
        products += forwardFourier (motion, length).cwiseProduct (forwardFourier (asked, length).conjugate());
    }

    const Eigen::VectorXd correlation = inverseFourier (products, length).head (reached.cols());
    TrackAlignment found;
    const auto largest = correlation.maxCoeff (&found.begin);
    found.likeness = largest / (reached.norm() * wanted.norm() + std::numeric_limits<double>::min());
    return found;
}
} // namespace antinode
