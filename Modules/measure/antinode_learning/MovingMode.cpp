#include "MovingMode.h"

#include <array>
#include <cmath>

namespace antinode
{
namespace
{
using Complex = std::complex<double>;
constexpr auto places = ForceTaps::places;
constexpr std::size_t moments = places + 1; // one more for the derivative

/** The coefficients of each place's cubic, which is 1 there and 0 at the others: of x^0 to x^3. */
constexpr std::array<std::array<double, places>, places> cubicsOfPlaces()
{
    std::array<std::array<double, places>, places> cubics {};

    for (std::size_t g = 0; g < places; ++g)
    {
        auto& cubic = cubics[g];
        cubic[0] = 1;

        for (std::size_t other = 0, degree = 0; other < places; ++other)
        {
            if (other == g)
                continue;

            const auto root = ForceTaps::gaussPlaces[other], width = ForceTaps::gaussPlaces[g] - root;
            ++degree;

            for (auto n = degree; n > 0; --n)
                cubic[n] = (cubic[n - 1] - root * cubic[n]) / width;

            cubic[0] *= -root / width;
        }
    }

    return cubics;
}

/** The integrals over 0 to 1 of exp (z (1 - x)) x^n. By parts z M_n = n M_(n-1) - 1: upwards where z is large,
    downwards from far above where it is small, since each loses its digits in the other case. */
std::array<Complex, moments> exponentialMoments (Complex z)
{
    constexpr double large = 4;
    constexpr std::size_t farAbove = 48; // start from 0: what is left of it, large^48 / 48!, is below rounding
    std::array<Complex, moments> values;

    if (std::abs (z) > large)
    {
        values[0] = (std::exp (z) - 1.0) / z;

        for (std::size_t n = 1; n < moments; ++n)
            values[n] = (static_cast<double> (n) * values[n - 1] - 1.0) / z;

        return values;
    }

    Complex moment = 0;

    for (auto n = farAbove; n > 0; --n)
    {
        moment = (z * moment + 1.0) / static_cast<double> (n);

        if (n <= moments)
            values[n - 1] = moment;
    }

    return values;
}
} // namespace

ForceTaps forceTaps (Complex pole, double length)
{
    static constexpr auto cubics = cubicsOfPlaces();
    const auto integrals = exponentialMoments (pole * length);
    ForceTaps result {};

    for (std::size_t g = 0; g < places; ++g)
        for (std::size_t n = 0; n < places; ++n)
        {
            result.taps[g] += length * cubics[g][n] * integrals[n];
            result.byPole[g] += length * length * cubics[g][n] * (integrals[n] - integrals[n + 1]);
        }

    return result;
}

namespace
{
using Complex = std::complex<double>;

/** Sums of q^n, n q^n and n^2 q^n over n from 0 to J - 1. */
std::array<Complex, 3> powerSums (Complex logarithm, Eigen::Index samples)
{
    constexpr double nearlyOne = 1e-3; // off by as little altogether: the closed forms would lose all digits
    const auto count = static_cast<double> (samples);
    const auto q = std::exp (logarithm), end = std::exp (logarithm * count);

    if (const auto off = q - 1.0; std::abs (off) * count < nearlyOne)
    {
        // q^n = 1 + n (q - 1).
        const auto ones = count * (count - 1) / 2, squares = ones * (2 * count - 1) / 3;
        return { count + off * ones, ones + off * squares, squares + off * ones * ones };
    }

    const auto inverse = 1.0 / (1.0 - q);
    const auto last = count - 1;
    // Each is its own shifted sum by q away from one of a lower power.
    const auto zeroth = (1.0 - end) * inverse;
    const auto first = (zeroth - 1.0 - last * end) * inverse;
    const auto second = (2.0 * first - zeroth + 1.0 - last * last * end) * inverse;
    return { zeroth, first, second };
}

/** Re (a c p + a c* q) / 2 of two complex numbers, as a form of their real and imaginary parts. */
Eigen::Matrix2d realForm (Complex p, Complex q)
{
    Eigen::Matrix2d form;
    form << p.real() + q.real(), q.imag() - p.imag(), -p.imag() - q.imag(), q.real() - p.real();
    return form / 2;
}
} // namespace

Eigen::Matrix4d decayProducts (Complex one, Complex other, Eigen::Index samples)
{
    Eigen::Matrix4d products = Eigen::Matrix4d::Zero();

    if (samples <= 0)
        return products;

    const auto straight = powerSums (one + other, samples), turned = powerSums (one + std::conj (other), samples);
    products.topLeftCorner<2, 2>() = realForm (straight[0], turned[0]);
    products.topRightCorner<2, 2>() = realForm (straight[1], turned[1]);
    products.bottomLeftCorner<2, 2>() = products.topRightCorner<2, 2>();
    products.bottomRightCorner<2, 2>() = realForm (straight[2], turned[2]);
    return products;
}

DecayPart decayPart (const Eigen::VectorXcd& logarithms, Eigen::Index first, Eigen::Index samples)
{
    constexpr double silent = 1e-10; // of what the mode was
    std::vector<Eigen::Index> heard;

    for (Eigen::Index k = 0; k < logarithms.size(); ++k)
        if (logarithms[k].real() * static_cast<double> (first) > std::log (silent))
            heard.push_back (k);

    DecayPart part { first, Eigen::MatrixXd (samples, 4 * std::ssize (heard)), {} };

    for (const auto k : heard)
    {
        const auto column = std::ssize (part.columns);
        const auto turn = std::exp (logarithms[k]);
        auto now = std::exp (logarithms[k] * static_cast<double> (first));

        for (Eigen::Index n = 0; n < samples; ++n)
        {
            const auto time = static_cast<double> (first + n);
            part.basis (n, column) = now.real();
            part.basis (n, column + 1) = -now.imag();
            part.basis (n, column + 2) = time * now.real();
            part.basis (n, column + 3) = -time * now.imag();
            // Finite numbers: without the questions that the operator asks.
            now = { now.real() * turn.real() - now.imag() * turn.imag(),
                    now.real() * turn.imag() + now.imag() * turn.real() };
        }

        for (Eigen::Index i = 0; i < 4; ++i)
            part.columns.push_back (4 * k + i);
    }

    return part;
}
} // namespace antinode
