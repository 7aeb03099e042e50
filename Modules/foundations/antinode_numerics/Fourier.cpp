#include "Fourier.h"

#include <algorithm>
#include <cmath>

// Its own kissfft: in the Debian package that Eigen comes in, no further library; double precision to 1e-15 of the
// largest line.
#include <unsupported/Eigen/FFT>

namespace antinode
{
struct FourierTables::Tables
{
    Eigen::FFT<double> transform;
};

FourierTables::FourierTables() : tables (std::make_unique<Tables>())
{
    tables->transform.SetFlag (Eigen::FFT<double>::HalfSpectrum);
}

FourierTables::~FourierTables() = default;

Eigen::VectorXcd FourierTables::forward (const Eigen::VectorXd& signal)
{
    Eigen::VectorXcd spectrum;
    tables->transform.fwd (spectrum, signal);
    return spectrum;
}

Eigen::VectorXcd FourierTables::forward (const Eigen::VectorXd& signal, Eigen::Index length)
{
    Eigen::VectorXd padded = Eigen::VectorXd::Zero (length);
    padded.head (signal.size()) = signal;
    return forward (padded);
}

Eigen::VectorXd FourierTables::inverse (const Eigen::VectorXcd& spectrum, Eigen::Index length)
{
    Eigen::VectorXd signal;
    tables->transform.inv (signal, spectrum, length);
    return signal;
}

Eigen::VectorXcd forwardFourier (const Eigen::VectorXd& signal)
{
    return FourierTables().forward (signal);
}

Eigen::VectorXcd forwardFourier (const Eigen::VectorXd& signal, Eigen::Index length)
{
    return FourierTables().forward (signal, length);
}

Eigen::VectorXd inverseFourier (const Eigen::VectorXcd& spectrum, Eigen::Index length)
{
    return FourierTables().inverse (spectrum, length);
}

Eigen::Index quickLength (double atLeast)
{
    constexpr Eigen::Index unit = 4; // Real transforms go by half-length complex ones.
    const auto minimum = std::max (1.0, std::ceil (atLeast / unit));
    auto best = static_cast<Eigen::Index> (std::exp2 (std::ceil (std::log2 (minimum))));

    for (Eigen::Index fives = 1; fives < 2 * best; fives *= 5)
        for (auto threes = fives; threes < 2 * best; threes *= 3)
        {
            const auto rest = std::max (1.0, minimum / static_cast<double> (threes));
            const auto candidate = threes * static_cast<Eigen::Index> (std::exp2 (std::ceil (std::log2 (rest))));
            best = static_cast<double> (candidate) >= minimum ? std::min (best, candidate) : best;
        }

    return unit * best;
}

double peakBetweenSamples (const Eigen::VectorXd& signal)
{
    constexpr Eigen::Index factor = 4;
    const auto length = quickLength (static_cast<double> (signal.size()));
    Eigen::VectorXcd spectrum = Eigen::VectorXcd::Zero (factor * length / 2 + 1);
    spectrum.head (length / 2 + 1) = forwardFourier (signal, length) * static_cast<double> (factor);
    return inverseFourier (spectrum, factor * length).cwiseAbs().maxCoeff();
}
} // namespace antinode
