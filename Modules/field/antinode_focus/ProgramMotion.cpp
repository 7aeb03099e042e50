#include "ProgramMotion.h"

#include "Prediction.h"

#include <antinode_base/Watch.h>

#include <algorithm>
#include <set>

namespace antinode
{
namespace
{
using Complex = std::complex<double>;

/** An oscillation so near a pole that 1 / (p - s) would leave no digit is moved off it, by too little to be seen in the
   motion: after a second it has changed by 1e-5, and ten digits are left. */
Oscillation offPoles (Oscillation oscillation, const Eigen::VectorXcd& poles)
{
    constexpr double nearest = 1e-5; // 1/s

    if ((poles.array() - oscillation.exponent()).abs().minCoeff() < nearest)
        oscillation.growth += 2 * nearest;

    return oscillation;
}
} // namespace

ProgramMotion::ProgramMotion (const ModalModel& model, const VoltageProgram& program) : poles (modalPoles (model))
{
    for (const auto& oscillation : program.oscillations)
        oscillations.push_back (offPoles (oscillation, poles));

    with = against = complexForces (model, model.participation * program.allocation);
    std::set<double> times { program.focusTime };

    for (Eigen::Index c = 0; c < with.cols(); ++c)
    {
        checkWatch();
        const auto& oscillation = oscillations[static_cast<std::size_t> (c)];
        const auto p = oscillation.exponent();
        const auto half = 0.5 * oscillation.phasor();
        times.insert ({ oscillation.start, oscillation.end });

        for (Eigen::Index k = 0; k < poles.size(); ++k)
        {
            with (k, c) *= half / (p - poles[k]);
            against (k, c) *= std::conj (half) / (std::conj (p) - poles[k]);
        }
    }

    Knot knot { *times.begin(), Eigen::VectorXcd::Zero (poles.size()), {} };

    for (const auto time : times)
    {
        checkWatch();
        knots.push_back (knot = knotAfter (knot, time));
    }
}

/** The particular motion under one oscillation, which begins and ends with a step that free motion makes up for. */
Eigen::VectorXcd ProgramMotion::forced (Eigen::Index c, double time) const
{
    const auto& oscillation = oscillations[static_cast<std::size_t> (c)];
    const auto turned = std::exp (oscillation.exponent() * (time - oscillation.start));
    return turned * with.col (c) + std::conj (turned) * against.col (c);
}

ProgramMotion::Knot ProgramMotion::knotAfter (const Knot& before, double time) const
{
    Knot knot { time, ((poles * (time - before.time)).array().exp() * before.free.array()).matrix(), {} };

    for (const auto c : before.playing)
        if (time < oscillations[static_cast<std::size_t> (c)].end)
            knot.playing.push_back (c);
        else
            knot.free += forced (c, time);

    for (std::size_t c = 0; c < oscillations.size(); ++c)
        if (oscillations[c].start == time && oscillations[c].end > time)
        {
            knot.playing.push_back (static_cast<Eigen::Index> (c));
            knot.free -= forced (static_cast<Eigen::Index> (c), time);
        }

    return knot;
}

Eigen::VectorXcd ProgramMotion::statesAt (double time) const
{
    const auto after =
        std::upper_bound (knots.begin(), knots.end(), time, [] (double t, const Knot& knot) { return t < knot.time; });

    if (after == knots.begin())
        return Eigen::VectorXcd::Zero (poles.size());

    const auto& knot = *std::prev (after);
    Eigen::VectorXcd states = ((poles * (time - knot.time)).array().exp() * knot.free.array()).matrix();

    for (const auto c : knot.playing)
        states += forced (c, time);

    checkWatch();
    return states;
}
} // namespace antinode
