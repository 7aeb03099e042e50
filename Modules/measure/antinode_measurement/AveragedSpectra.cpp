#include "AveragedSpectra.h"

#include <utility>

namespace antinode
{
namespace
{
Eigen::VectorXcd response (ResponseEstimator estimator, const Eigen::ArrayXd& xx, const Eigen::ArrayXd& yy,
                           const Eigen::ArrayXcd& yx)
{
    const Eigen::ArrayXcd h1 = yx / xx.cast<std::complex<double>>();

    if (estimator == ResponseEstimator::h1)
        return h1;

    // |H2| / |H1| = S_xx S_yy / |S_yx|^2, 1 over the coherence.
    const Eigen::ArrayXd overH1 = xx * yy / yx.abs2().max (1e-300);
    return h1 * (estimator == ResponseEstimator::h2 ? overH1 : overH1.sqrt()).cast<std::complex<double>>();
}
} // namespace

AveragedSpectra::AveragedSpectra (Eigen::MatrixXcd input)
    : spectra (std::move (input)), powers (spectra.cwiseAbs2().rowwise().sum().array())
{
}

void AveragedSpectra::estimate (const Eigen::MatrixXcd& output, ResponseEstimator estimator, double averages,
                                Eigen::Index column, EstimatedResponses& result) const
{
    const Eigen::ArrayXd yy = output.cwiseAbs2().rowwise().sum().array();
    const Eigen::ArrayXcd yx = output.cwiseProduct (spectra.conjugate()).rowwise().sum().array();
    const Eigen::ArrayXd coherence = (yx.abs2() / (powers * yy).max (1e-300)).min (1.0);
    result.values.col (column) = response (estimator, powers, yy, yx);
    result.coherence.col (column) = coherence;
    result.variances.col (column) =
        (yx / powers.cast<std::complex<double>>()).abs2() * (1 - coherence) / (coherence.max (1e-12) * averages);
}
} // namespace antinode
