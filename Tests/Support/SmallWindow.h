#pragma once

#include <antinode_numerics/Statistics.h>
#include <antinode_tracks/WindowedResponses.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace antinode::test
{
/** A window so small that its responses fit a dense matrix. */
namespace small_window
{
inline constexpr Eigen::Index length = 96, window = 40, actuators = 4, points = 2;
inline constexpr double compliance = 1e-3;

/** Three resonances between random shapes and participations. */
inline PointResponses someResponses()
{
    RandomNumbers random (7);
    PointResponses responses { points, actuators, length, 1, Eigen::MatrixXcd (length / 2 + 1, points * actuators) };
    const Eigen::MatrixXd shapes = random.normal (points * 3).reshaped (points, 3);
    const Eigen::MatrixXd participation = random.normal (3 * actuators).reshaped (3, actuators);

    for (Eigen::Index line = 0; line <= length / 2; ++line)
    {
        const auto w = 2 * std::numbers::pi * static_cast<double> (line) / length;
        Eigen::VectorXcd compliances (3);

        for (Eigen::Index k = 0; k < 3; ++k)
        {
            const auto own = 0.4 + 0.5 * static_cast<double> (k);
            compliances[k] = 1.0 / std::complex (own * own - w * w, 0.1 * own * w);
        }

        const Eigen::MatrixXcd response =
            shapes.cast<std::complex<double>>() * compliances.asDiagonal() * participation.cast<std::complex<double>>();
        responses.values.row (line) = response.reshaped().transpose();
    }

    responses.values.row (0).imag().setZero();
    responses.values.row (length / 2).imag().setZero();
    return responses;
}

inline WindowedResponses someWindow()
{
    return { someResponses(), window, compliance };
}

/** One point that goes from the first to the second in the middle of the window. */
inline WindowedResponses movingWindow()
{
    MovingPoints moving { { 0, 0 }, Eigen::MatrixXd (length, points), { 8, 16, 24, 32 } };

    for (Eigen::Index n = 0; n < length; ++n)
    {
        const auto share = std::min (1.0, std::max (0.0, static_cast<double> (n - 8) / 24));
        moving.weights.row (n) << 1 - share, share;
    }

    return { someResponses(), window, compliance, moving };
}

/** G as a matrix: the motion for each single sample. */
inline Eigen::MatrixXd denseResponses (WindowedResponses& responses)
{
    Eigen::MatrixXd dense (length * responses.points(), window * actuators);

    for (Eigen::Index j = 0; j < dense.cols(); ++j)
    {
        Eigen::MatrixXd unit = Eigen::MatrixXd::Zero (window, actuators);
        unit.reshaped()[j] = 1;
        dense.col (j) = responses.motion (unit).reshaped();
    }

    return dense;
}

inline Eigen::MatrixXd someWanted()
{
    Eigen::MatrixXd wanted = Eigen::MatrixXd::Zero (length, points);

    for (Eigen::Index n = 8; n < 32; ++n)
    {
        const auto time = static_cast<double> (n - 8);
        wanted (n, 0) = std::sin (0.7 * time) * std::sin (std::numbers::pi * time / 24);
    }

    return wanted;
}
} // namespace small_window
} // namespace antinode::test
