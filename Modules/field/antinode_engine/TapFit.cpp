#include "TapFit.h"

#include <cmath>
#include <complex>
#include <numbers>

namespace antinode
{
TapFit::TapFit (const FitBand& band, Eigen::Index half)
    : highest (band.highest), bandLines (6 * half), omegas (bandLines + 4 * half)
{
    constexpr double weightAnywhere = 1e-4; // so that taps stay small where nothing is said of the response
    const auto anywhere = omegas.size() - bandLines;
    omegas << Eigen::ArrayXd::LinSpaced (bandLines, band.lowest, band.highest),
        Eigen::ArrayXd::LinSpaced (anywhere, 0, std::numbers::pi);
    weights.setConstant (omegas.size(), 1.0 / static_cast<double> (bandLines));
    weights.tail (anywhere) = weightAnywhere / static_cast<double> (anywhere);
    const Eigen::RowVectorXd times = Eigen::RowVectorXd::LinSpaced (half, 1, static_cast<double> (half));
    const Eigen::ArrayXXd angles = (omegas.matrix() * times).array();
    even.resize (angles.rows(), half + 1);
    even << Eigen::VectorXd::Ones (angles.rows()), 2 * angles.cos().matrix();
    odd = -2 * angles.sin().matrix();
    evenFactor = factorOf (even);
    oddFactor = factorOf (odd);
}

Eigen::LLT<Eigen::MatrixXd> TapFit::factorOf (const Eigen::MatrixXd& waves) const
{
    constexpr double ridge = 1e-12;
    Eigen::MatrixXd matrix = waves.transpose() * weights.matrix().asDiagonal() * waves;
    matrix.diagonal() *= 1 + ridge;
    return Eigen::LLT<Eigen::MatrixXd> (matrix);
}

Eigen::ArrayXcd TapFit::wanted (const FitTarget& target) const
{
    const std::complex<double> unit (0, 1);
    const Eigen::ArrayXcd lead = 1.0 + unit * target.timeConstant * omegas.min (highest);
    const Eigen::ArrayXcd turned = (unit * (target.angle - omegas * target.delay)).exp();
    return target.isLowPass ? Eigen::ArrayXcd (turned / lead) : Eigen::ArrayXcd (lead * turned);
}

Eigen::VectorXd TapFit::taps (const FitTarget& target) const
{
    const auto response = wanted (target);
    const Eigen::VectorXd evens = evenFactor.solve (even.transpose() * (weights * response.real()).matrix());
    const Eigen::VectorXd odds = oddFactor.solve (odd.transpose() * (weights * response.imag()).matrix());
    Eigen::VectorXd all (2 * half() + 1);
    all << (evens.tail (half()) - odds).reverse(), evens[0], evens.tail (half()) + odds;
    return all;
}

double TapFit::misfit (const Eigen::VectorXd& taps, const FitTarget& target) const
{
    const Eigen::VectorXd after = taps.tail (half()), before = taps.head (half()).reverse();
    Eigen::VectorXd evens (half() + 1);
    evens << taps[half()], (after + before) / 2;
    Eigen::ArrayXcd response (omegas.size());
    response.real() = (even * evens).array();
    response.imag() = (odd * (after - before) / 2).array();
    const auto right = wanted (target);
    return ((response - right) / right).head (bandLines).abs().maxCoeff();
}
} // namespace antinode
