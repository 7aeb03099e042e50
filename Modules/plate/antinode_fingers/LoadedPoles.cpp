#include "LoadedPoles.h"

#include <antinode_base/Watch.h>

#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

namespace antinode
{
namespace
{
using Complex = std::complex<double>;

constexpr int maximumSweeps = 200;
constexpr double converged = 4e-16;  // change of a pole, relative
constexpr double negligible = 1e-10; // imaginary part of a pole that is real, relative

/** What a finger answers to a unit of displacement, m s^2 + c s + k, and its derivative by s. */
struct FingerForces
{
    Eigen::VectorXcd value, slope;
};

FingerForces fingerForces (const LoadedModes& modes, Complex s)
{
    return { modes.mass * (s * s) + modes.damping * s + modes.stiffness.cast<Complex>(),
             modes.mass * (2.0 * s) + modes.damping.cast<Complex>() };
}

/** What the modes under the fingers answer to forces there, P' D (s) P, and its derivative by s. */
struct ContactResponse
{
    Eigen::MatrixXcd value, slope;
    Complex poles; ///< The sum of 1 / (s - pole) over all poles without fingers.
};

ContactResponse contactResponse (const LoadedModes& modes, Complex s)
{
    const auto fingers = modes.contacts.cols();
    ContactResponse response { Eigen::MatrixXcd::Zero (fingers, fingers), Eigen::MatrixXcd::Zero (fingers, fingers),
                               0 };

    for (Eigen::Index k = 0; k < modes.decay.size(); ++k)
    {
        const Complex pole (-modes.decay[k], modes.frequency[k]);
        const auto denominator = (s - pole) * (s - std::conj (pole));
        const auto slope = 2.0 * s + 2 * modes.decay[k];
        response.poles += slope / denominator;

        for (Eigen::Index f = 0; f < fingers; ++f)
            for (Eigen::Index g = 0; g < fingers; ++g)
            {
                const auto part = modes.contacts (k, f) * modes.contacts (k, g) / denominator;
                response.value (f, g) += part;
                response.slope (f, g) -= part * (slope / denominator);
            }
    }

    return response;
}

/** 1 + G P' D P. */
Eigen::MatrixXcd contactMatrix (const FingerForces& forces, const ContactResponse& response)
{
    return Eigen::MatrixXcd::Identity (forces.value.size(), forces.value.size())
           + forces.value.asDiagonal() * response.value;
}

/** The trace of a^-1 b, by elimination with pivots: a is as small as there are fingers. */
Complex traceOfQuotient (Eigen::MatrixXcd a, Eigen::MatrixXcd b)
{
    const auto size = a.rows();

    for (Eigen::Index c = 0; c < size; ++c)
    {
        Eigen::Index pivot = 0;
        a.col (c).tail (size - c).cwiseAbs().maxCoeff (&pivot);
        a.row (c).swap (a.row (c + pivot));
        b.row (c).swap (b.row (c + pivot));
        b.row (c) /= a (c, c);
        a.row (c) /= Complex (a (c, c));

        for (Eigen::Index r = 0; r < size; ++r)
            if (const Complex factor = a (r, c); r != c)
            {
                a.row (r) -= factor * a.row (c);
                b.row (r) -= factor * b.row (c);
            }
    }

    return b.trace();
}

/** p' / p of the polynomial whose zeros are the poles with fingers. */
Complex logarithmicSlope (const LoadedModes& modes, Complex s)
{
    const auto forces = fingerForces (modes, s);
    const auto response = contactResponse (modes, s);
    const Eigen::MatrixXcd slope =
        forces.slope.asDiagonal() * response.value + forces.value.asDiagonal() * response.slope;
    return response.poles + traceOfQuotient (contactMatrix (forces, response), slope);
}

/** The poles without fingers, a little beside themselves, so that no two are the same and none is an exact pole. */
Eigen::VectorXcd firstGuess (const LoadedModes& modes)
{
    constexpr auto beside = 1e-3, goldenTurn = 2.399963229728653;
    const auto count = modes.decay.size();
    Eigen::VectorXcd guess (2 * count);

    for (Eigen::Index i = 0; i < 2 * count; ++i)
    {
        const Complex pole (-modes.decay[i / 2], i % 2 == 0 ? modes.frequency[i / 2] : -modes.frequency[i / 2]);
        guess[i] = pole * (1.0 + std::polar (beside, goldenTurn * static_cast<double> (i)));
    }

    return guess;
}

/** One step of all poles, each away from the others. @return  the largest change, relative */
double sweep (const LoadedModes& modes, Eigen::VectorXcd& poles, Eigen::Array<bool, Eigen::Dynamic, 1>& isSettled)
{
    double largest = 0;

    for (Eigen::Index i = 0; i < poles.size(); ++i)
    {
        if (isSettled[i])
            continue;

        auto others = Complex (0);

        for (Eigen::Index j = 0; j < poles.size(); ++j)
            if (j != i)
                others += 1.0 / (poles[i] - poles[j]);

        const auto step = 1.0 / (logarithmicSlope (modes, poles[i]) - others);

        if (! std::isfinite (std::abs (step)))
        {
            isSettled[i] = true; // It is a pole to the last digit.
            continue;
        }

        poles[i] -= step;
        const auto change = std::abs (step) / std::abs (poles[i]);
        isSettled[i] = change <= converged;
        largest = std::max (largest, change);
    }

    return largest;
}

/** The vector that a singular matrix takes to 0, by elimination with complete pivoting: squares of it would lose half
   the digits. */
Eigen::VectorXcd nullVector (Eigen::MatrixXcd a)
{
    const auto size = a.rows();
    std::vector<Eigen::Index> order (static_cast<std::size_t> (size));
    std::iota (order.begin(), order.end(), Eigen::Index { 0 });

    for (Eigen::Index c = 0; c + 1 < size; ++c)
    {
        Eigen::Index row = 0, column = 0;
        a.bottomRightCorner (size - c, size - c).cwiseAbs().maxCoeff (&row, &column);
        a.row (c).swap (a.row (c + row));
        a.col (c).swap (a.col (c + column));
        std::swap (order[static_cast<std::size_t> (c)], order[static_cast<std::size_t> (c + column)]);

        for (auto r = c + 1; r < size; ++r)
            a.row (r).tail (size - c) -= Complex (a (r, c) / a (c, c)) * a.row (c).tail (size - c);
    }

    Eigen::VectorXcd vector = Eigen::VectorXcd::Zero (size), sorted = Eigen::VectorXcd::Zero (size);
    sorted[size - 1] = 1;

    for (auto c = size - 2; c >= 0; --c)
        sorted[c] = -(a.row (c).tail (size - 1 - c) * sorted.tail (size - 1 - c)).value() / a (c, c);

    for (Eigen::Index c = 0; c < size; ++c)
        vector[order[static_cast<std::size_t> (c)]] = sorted[c];

    return vector;
}
} // namespace

Eigen::VectorXcd loadedPoles (const LoadedModes& modes)
{
    constexpr auto asGoodAsRounding = 1e-13;
    auto poles = firstGuess (modes);
    Eigen::Array<bool, Eigen::Dynamic, 1> isSettled =
        Eigen::Array<bool, Eigen::Dynamic, 1>::Constant (poles.size(), false);
    double change = 1;

    for (int i = 0; i < maximumSweeps && ! isSettled.all() && (i < maximumSweeps / 4 || change > asGoodAsRounding); ++i)
    {
        checkWatch();
        change = sweep (modes, poles, isSettled);
    }

    if (! poles.allFinite() || change > asGoodAsRounding)
        throw std::runtime_error ("the modes of a surface with fingers were not found");

    for (auto& pole : poles)
        if (std::abs (pole.imag()) <= negligible * std::abs (pole))
            pole = pole.real();

    return poles;
}

Eigen::VectorXcd loadedVector (const LoadedModes& modes, Complex s)
{
    const auto forces = fingerForces (modes, s);
    const Eigen::MatrixXcd matrix = contactMatrix (forces, contactResponse (modes, s));

    // The forces of the fingers: those that the matrix takes to 0.
    const auto pull = nullVector (matrix);
    Eigen::VectorXcd vector (modes.decay.size());

    for (Eigen::Index k = 0; k < vector.size(); ++k)
    {
        const Complex pole (-modes.decay[k], modes.frequency[k]);
        vector[k] = (modes.contacts.row (k).cast<Complex>() * pull).value() / ((s - pole) * (s - std::conj (pole)));
    }

    Eigen::Index strongest = 0;
    vector.cwiseAbs().maxCoeff (&strongest);
    return vector / vector[strongest];
}

Complex poleNorm (const LoadedModes& modes, Complex s, const Eigen::VectorXcd& vector)
{
    const Eigen::VectorXcd under = modes.contacts.transpose() * vector;
    const Eigen::VectorXcd bare = 2.0 * s + 2.0 * modes.decay.cast<Complex>().array();
    return (vector.array().square() * bare.array()).sum()
           + (under.array().square() * (modes.mass * (2.0 * s) + modes.damping.cast<Complex>()).array()).sum();
}
} // namespace antinode
