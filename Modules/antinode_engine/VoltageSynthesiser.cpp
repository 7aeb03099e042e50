#include "VoltageSynthesiser.h"

#include <antinode_model/InputError.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace antinode
{
namespace
{
constexpr std::int64_t tileSize = 64;
constexpr double furthestSample = 1e15; // below 2^53: every sample's index is exact

std::int64_t tileOf (std::int64_t sample)
{
    return sample >= 0 ? sample / tileSize : -((-sample + tileSize - 1) / tileSize);
}

/** e^{p t} to the precision of double, however large the phase. */
std::complex<double> exponential (const Oscillation& oscillation, long double time)
{
    const auto size = std::exp (oscillation.growth * time);
    const auto phase = oscillation.angularFrequency * time;
    return { static_cast<double> (size * std::cos (phase)), static_cast<double> (size * std::sin (phase)) };
}

void requireUsable (const Oscillation& oscillation, const std::string& where, double rate)
{
    const auto finite = std::isfinite (oscillation.start) && std::isfinite (oscillation.end)
                        && std::isfinite (oscillation.growth) && std::isfinite (oscillation.angularFrequency)
                        && std::isfinite (oscillation.inPhase) && std::isfinite (oscillation.quadrature);

    if (! finite)
        throw InputError (where, "has a number that is not finite");

    if (oscillation.end < oscillation.start)
        throw InputError (where, "ends before it starts");

    if (std::max (std::abs (oscillation.start), std::abs (oscillation.end)) * rate > furthestSample)
        throw InputError (where, "starts or ends more than 1e15 samples from the trigger");

    // The tile of the first sample begins up to one tile before the start, where a decaying envelope is larger still.
    const auto spread = std::max (0.0, oscillation.growth) * (oscillation.end - oscillation.start)
                        + std::abs (oscillation.growth) * static_cast<double> (tileSize) / rate;

    if (! std::isfinite (std::abs (oscillation.phasor()) * std::exp (spread)))
        throw InputError (where, "grows or decays beyond the range of numbers");
}

void requireUsable (const VoltageProgram& program, double rate)
{
    if (! std::isfinite (rate) || rate <= 0)
        throw InputError ("sample rate", "must be finite and positive to play samples");

    const auto count = static_cast<Eigen::Index> (program.oscillations.size());

    if (program.allocation.cols() != count || ! program.allocation.allFinite())
        throw InputError ("voltage program",
                          "the allocation needs one column of finite voltages for every oscillation");

    if (! std::isfinite (program.focusTime) || std::abs (program.focusTime) * rate > furthestSample)
        throw InputError ("voltage program", "the focus time must be finite and within 1e15 samples of the trigger");

    for (Eigen::Index c = 0; c < count; ++c)
        requireUsable (program.oscillations[static_cast<std::size_t> (c)],
                       "voltage program: oscillation " + std::to_string (c + 1), rate);
}
} // namespace

VoltageSynthesiser::VoltageSynthesiser (VoltageProgram voltageProgram, Playback playback)
    : program (std::move (voltageProgram)), rate (playback.sampleRate)
{
    requireUsable (program, rate);
    focus = std::llround (program.focusTime * rate);
    rotations.resize (tileSize, program.allocation.cols());

    for (Eigen::Index c = 0; c < rotations.cols(); ++c)
    {
        const auto& oscillation = program.oscillations[static_cast<std::size_t> (c)];
        const auto offset = static_cast<long double> (program.focusTime) - oscillation.start;
        voices.push_back ({ edgeAt (oscillation.start, playback.reconstruction),
                            edgeAt (oscillation.end, playback.reconstruction), offset });

        for (Eigen::Index j = 0; j < tileSize; ++j)
            rotations (j, c) = exponential (oscillation, static_cast<long double> (j) / rate);
    }
}

VoltageSynthesiser::Edge VoltageSynthesiser::edgeAt (double time, Reconstruction reconstruction) const
{
    const auto position =
        static_cast<long double> (focus) + (static_cast<long double> (time) - program.focusTime) * rate;
    const auto nearest = std::round (position);

    if (std::abs (position - nearest) < 1e-6L)
        return { std::llround (nearest), reconstruction == Reconstruction::bandLimited ? 0.5 : 1.0 };

    return { static_cast<std::int64_t> (std::ceil (position)), 1.0 };
}

std::complex<double> VoltageSynthesiser::phasorAt (std::size_t oscillation, std::int64_t sample) const
{
    // Extended precision: 1e-16 of a phase of 1e5 rad would already be more than the 1e-12 that are promised.
    const auto tau = static_cast<long double> (sample - focus) / rate + voices[oscillation].focusOffset;
    return program.oscillations[oscillation].phasor() * exponential (program.oscillations[oscillation], tau);
}

void VoltageSynthesiser::addOscillation (std::size_t oscillation, std::int64_t tile, std::int64_t first,
                                         Eigen::Ref<Eigen::MatrixXd> voltages) const
{
    const auto& voice = voices[oscillation];
    const auto tileStart = tile * tileSize;
    const auto begin = std::max ({ tileStart, first, voice.start.sample });
    const auto end = std::min ({ tileStart + tileSize, first + voltages.cols(), voice.end.sample + 1 });

    if (begin >= end)
        return;

    const auto column = static_cast<Eigen::Index> (oscillation);
    const auto coarse = phasorAt (oscillation, tileStart);

    for (auto n = begin; n < end; ++n)
    {
        const auto fine = rotations (n - tileStart, column);
        const auto value = coarse.real() * fine.real() - coarse.imag() * fine.imag();
        const auto weight = voice.start.weightAt (n) - voice.end.weightAt (n);
        voltages.col (n - first) += program.allocation.col (column) * (weight * value);
    }
}

void VoltageSynthesiser::process (std::int64_t first, Eigen::Ref<Eigen::MatrixXd> voltages) const
{
    voltages.setZero();

    for (auto tile = tileOf (first); tile * tileSize < first + voltages.cols(); ++tile)
        for (std::size_t c = 0; c < voices.size(); ++c)
            addOscillation (c, tile, first, voltages);
}
} // namespace antinode
