#include "Fourier.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

// Its own kissfft: in the Debian package that Eigen comes in, no further library; double precision to 1e-15 of the
// largest line.
#include <unsupported/Eigen/FFT>

namespace antinode
{
namespace
{
/** The largest prime factor of a length, 1 of 1. */
Eigen::Index largestPrime (Eigen::Index length)
{
    Eigen::Index largest = 1;

    for (Eigen::Index factor = 2; length > 1; factor = factor * factor < length ? factor + 1 : length)
        for (; length % factor == 0; length /= factor)
            largest = factor;

    return largest;
}

/** From this prime factor on a chirp is quicker: kissfft takes as many steps per sample as its factor. */
constexpr Eigen::Index largePrime = 100;
} // namespace

struct FourierTables::Tables
{
    /** Bluestein's algorithm, L. I. Bluestein, IEEE Trans. Audio Electroacoust. 18 (1970) 451: as k n is
       (k^2 + n^2 - (k - n)^2) / 2, a transform is a convolution with a chirp, by transforms of a quick length. */
    class Chirp
    {
    public:
        Chirp (Eigen::FFT<double>& transform, Eigen::Index length)
            : chirp (length), padded (quickLength (static_cast<double> (2 * length)))
        {
            for (Eigen::Index n = 0; n < length; ++n) // Exact: the phase of n^2 repeats after 2 lengths.
                chirp[n] = std::polar (1.0, -std::numbers::pi * static_cast<double> (n * n % (2 * length))
                                                / static_cast<double> (length));

            Eigen::VectorXcd response = Eigen::VectorXcd::Zero (padded);
            response.head (length) = chirp.conjugate();
            response.tail (length - 1) = chirp.tail (length - 1).conjugate().reverse();
            transform.fwd (filter, response);
        }

        /** The lines 0 to N/2 of a real signal. */
        Eigen::VectorXcd forward (Eigen::FFT<double>& transform, const Eigen::VectorXd& signal) const
        {
            Eigen::VectorXcd turned = Eigen::VectorXcd::Zero (padded), spectrum, convolved;
            turned.head (signal.size()) = chirp.cwiseProduct (signal);
            transform.fwd (spectrum, turned);
            spectrum = spectrum.cwiseProduct (filter).eval();
            transform.inv (convolved, spectrum);
            const auto lines = signal.size() / 2 + 1;
            return convolved.head (lines).cwiseProduct (chirp.head (lines));
        }

    private:
        Eigen::VectorXcd chirp, filter;
        Eigen::Index padded;
    };

    Eigen::FFT<double> transform;
    std::map<Eigen::Index, Chirp> chirps;
};

FourierTables::FourierTables() : tables (std::make_unique<Tables>())
{
    tables->transform.SetFlag (Eigen::FFT<double>::HalfSpectrum);
}

FourierTables::~FourierTables() = default;

Eigen::VectorXcd FourierTables::forward (const Eigen::VectorXd& signal)
{
    if (signal.size() == 1) // kissfft has no stage for it.
        return signal.cast<std::complex<double>>();

    if (largestPrime (signal.size()) >= largePrime)
        return tables->chirps.try_emplace (signal.size(), tables->transform, signal.size())
            .first->second.forward (tables->transform, signal);

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
