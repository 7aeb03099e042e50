#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <vector>

namespace antinode::test
{
/** The right side of y' = f (t, y). It is never called for the end of a stretch between two break points, so a force
   that jumps there may be given as it holds for start <= t < end. */
using OdeDerivative = std::function<Eigen::VectorXd (double, const Eigen::VectorXd&)>;

/** The last estimate of an extrapolated step, and how much it differs from the one before, both against `scale`. */
struct ExtrapolatedStep
{
    Eigen::VectorXd state;
    double error = 0;
};

/** One step of Gragg, Bulirsch and Stoer: modified midpoint with 2, 4, .. 16 substeps, extrapolated to none (order 16).
    Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, section II.9. */
inline ExtrapolatedStep extrapolatedStep (const OdeDerivative& derivative, const Eigen::VectorXd& state, double time,
                                          double step, const Eigen::VectorXd& largest)
{
    constexpr int columns = 8;
    std::vector<Eigen::VectorXd> row, previousRow;
    const Eigen::VectorXd slope = derivative (time, state);
    for (int k = 0; k < columns; ++k)
    {
        const auto substeps = 2 * (k + 1);
        const auto h = step / substeps;
        Eigen::VectorXd before = state, now = state + h * slope;
        for (int m = 1; m < substeps; ++m)
        {
            Eigen::VectorXd next = before + 2 * h * derivative (time + m * h, now);
            before.swap (now);
            now.swap (next);
        }
        row.assign (1, now);
        for (int l = 1; l <= k; ++l)
        {
            const auto ratio = static_cast<double> (k + 1) / (k + 1 - l);
            row.emplace_back (row.back()
                              + (row.back() - previousRow[static_cast<std::size_t> (l - 1)]) / (ratio * ratio - 1));
        }
        previousRow = row;
    }
    const Eigen::VectorXd scale = largest.cwiseMax (row.back().cwiseAbs()).array() + 1e-300;
    return { row.back(), ((row.back() - row[row.size() - 2]).array() / scale.array()).abs().maxCoeff() };
}

/** The solution of y' = f (t, y) at `to`, from `state` at `from`.
    @param tolerance    of each step, relative to the largest magnitude that each component has had so far
    @param breakPoints  times at which f may jump, in any order, also outside of the stretch
    @throws std::runtime_error  when the steps become too small */
inline Eigen::VectorXd integrateOde (const OdeDerivative& derivative, Eigen::VectorXd state, double from, double to,
                                     double tolerance = 1e-12, std::vector<double> breakPoints = {})
{
    breakPoints.push_back (to);
    std::sort (breakPoints.begin(), breakPoints.end());
    Eigen::VectorXd largest = state.cwiseAbs();
    auto time = from;
    auto step = (to - from) / 1000;
    for (const auto stop : breakPoints)
    {
        while (time < std::min (stop, to))
        {
            const auto reachesStop = time + step >= stop;
            const auto taken = reachesStop ? stop - time : step;
            const auto result = extrapolatedStep (derivative, state, time, taken, largest);
            const auto factor = 0.9 * std::pow (tolerance / std::max (result.error, 1e-18), 1.0 / 15);
            if (result.error <= tolerance)
            {
                state = result.state;
                largest = largest.cwiseMax (state.cwiseAbs());
                time = reachesStop ? stop : time + taken;
            }
            step = reachesStop && factor >= 1 ? step : taken * std::clamp (factor, 0.1, 3.0);
            if (step < 1e-15 * (to - from))
                throw std::runtime_error ("the steps of the adaptive solution become too small");
        }
    }
    return state;
}
} // namespace antinode::test
