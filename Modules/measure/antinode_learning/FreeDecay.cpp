#include "FreeDecay.h"

#include <array>
#include <cmath>

namespace antinode
{
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
