#include "FilterPlayer.h"

#include "FingerFilters.h"

#include <antinode_numerics/Fourier.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

namespace antinode
{
namespace
{
constexpr auto interpolatedSamples = 2 * rateChangeReach + 1; // samples from which a voltage comes

/** Phase p of an interpolation is p samples later than the middle one of those it comes from. */
Eigen::MatrixXf phaseTaps (Eigen::Index factor)
{
    const auto taps = rateChangeTaps (factor);
    Eigen::MatrixXf phases = Eigen::MatrixXf::Zero (interpolatedSamples, factor);

    for (Eigen::Index phase = 0; phase < factor; ++phase)
        for (Eigen::Index k = 0; k < interpolatedSamples; ++k)
            if (const auto tap = (interpolatedSamples - 1 - k) * factor + phase; tap < taps.size())
                phases (k, phase) = taps[tap];

    return phases;
}
} // namespace

SlidingWindow::SlidingWindow (Eigen::Index signals, Eigen::Index lengthToKeep)
    : length (lengthToKeep), values (Eigen::MatrixXf::Zero (signals, 2 * lengthToKeep))
{
}

FilterPlayer::FilterPlayer (const FilterBank& bankToPlay, Eigen::Index fadeToUse)
    : bank (&bankToPlay), factor (bankToPlay.factor), fade (fadeToUse),
      decimation (rateChangeTaps (factor) / static_cast<float> (factor)), interpolation (phaseTaps (factor)),
      fast (bankToPlay.inputs, decimation.size()),
      slow (static_cast<std::size_t> (bankToPlay.inputs), SlidingWindow (1, bankToPlay.taps)),
      filtered (bankToPlay.values.rows(), interpolatedSamples), sum (bankToPlay.values.rows())
{
}

void FilterPlayer::fadeTo (const FilterBank& bankToUse)
{
    next = &bankToUse;
    faded = 0;
}

void FilterPlayer::reset()
{
    fast.reset();
    filtered.reset();

    for (auto& window : slow)
        window.reset();

    phase = 0;

    if (next != nullptr)
        bank = std::exchange (next, nullptr);
}

void FilterPlayer::process (const Eigen::Ref<const Eigen::VectorXf>& inputs, Eigen::Ref<Eigen::VectorXf> outputs)
{
    auto newest = fast.next();

    for (Eigen::Index j = 0; j < newest.size(); ++j)
        newest[j] = std::isfinite (inputs[j]) ? inputs[j] : 0;

    fast.complete();

    if (phase == 0)
    {
        decimate();
        filter();
    }

    outputs.noalias() = filtered.newest().lazyProduct (interpolation.col (phase));
    phase = (phase + 1) % factor;
}

void FilterPlayer::decimate()
{
    for (std::size_t j = 0; j < slow.size(); ++j)
    {
        slow[j].next()[0] = fast.newest().row (static_cast<Eigen::Index> (j)).dot (decimation);
        slow[j].complete();
    }
}

void FilterPlayer::filter()
{
    sum.setZero();

    if (next == nullptr)
        addFiltered (*bank, 1);
    else
    {
        const auto share = static_cast<float> (++faded) / static_cast<float> (fade);
        addFiltered (*bank, 1 - share);
        addFiltered (*next, share);

        if (faded == fade)
            bank = std::exchange (next, nullptr);
    }

    filtered.next() = sum;
    filtered.complete();
}

void FilterPlayer::addFiltered (const FilterBank& played, float share)
{
    for (std::size_t j = 0; j < slow.size(); ++j)
        if (played.moves[j])
            sum.noalias() += share
                             * (played.values.middleCols (static_cast<Eigen::Index> (j) * played.taps, played.taps)
                                * slow[j].newest().transpose());
}

namespace
{
constexpr double feltWindow = 0.1; // s, of the RMS that is felt

/** A filter of linear phase with a magnitude by frequency, as long as it may be, under a window of Hann's. */
Eigen::VectorXf symmetricTaps (double rate, Eigen::Index longest, const std::function<double (double)>& magnitude)
{
    const auto reach = (longest - 1) / 2;
    const auto length = quickLength (16 * static_cast<double> (longest));
    Eigen::VectorXcd lines (length / 2 + 1);

    for (Eigen::Index k = 0; k < lines.size(); ++k)
        lines[k] = magnitude (rate * static_cast<double> (k) / static_cast<double> (length));

    const auto response = inverseFourier (lines, length);
    Eigen::VectorXf taps (2 * reach + 1);

    for (Eigen::Index n = -reach; n <= reach; ++n)
    {
        const auto window =
            0.5 + 0.5 * std::cos (std::numbers::pi * static_cast<double> (n) / static_cast<double> (reach + 1));
        taps[n + reach] = static_cast<float> (window * response[(n + length) % length]);
    }

    return taps;
}

bool isWithin (TrackBand band, double frequency)
{
    return frequency >= band.lower && frequency <= band.upper;
}
} // namespace

InputMotion::InputMotion (double rate, TrackBand band, const SkinThreshold& threshold, Eigen::Index past,
                          Eigen::Index inputsToTake)
    : inBand (symmetricTaps (rate, past, [&] (double frequency) { return isWithin (band, frequency) ? 1.0 : 0.0; })),
      weighted (symmetricTaps (rate, past,
                               [&] (double frequency)
                               { return isWithin (band, frequency) ? 1 / thresholdAt (threshold, frequency) : 0.0; })),
      inputs (static_cast<std::size_t> (inputsToTake))
{
    for (auto& input : inputs)
        input.squares.resize (static_cast<std::size_t> (std::max (1.0, std::round (feltWindow * rate))));
}

void InputMotion::take (std::size_t index, const Eigen::Ref<const Eigen::RowVectorXf>& samples)
{
    auto& input = inputs[index];
    const auto past = samples.tail (inBand.size());
    const auto displacement = past.dot (inBand), amount = past.dot (weighted);
    const auto square = static_cast<double> (amount) * static_cast<double> (amount);
    input.energy = std::max (0.0, input.energy + square - std::exchange (input.squares[input.oldest], square));
    input.oldest = (input.oldest + 1) % input.squares.size();
    const auto mean = input.energy / static_cast<double> (input.squares.size());
    input.displacement = std::max (input.displacement, std::abs (displacement));

    if (input.recentCount < mostRecent)
        input.recent[input.recentCount++] = displacement;

    input.felt = std::max ({ input.felt, std::abs (amount), static_cast<float> (std::sqrt (2 * mean)) });
}

float InputMotion::takeDisplacement (std::size_t input)
{
    return std::exchange (inputs[input].displacement, 0.0F);
}

float InputMotion::takeFelt (std::size_t input)
{
    return std::exchange (inputs[input].felt, 0.0F);
}

std::span<const float> InputMotion::takeRecent (std::size_t index)
{
    auto& input = inputs[index];
    return { input.recent.data(), std::exchange (input.recentCount, 0) };
}

void InputMotion::reset()
{
    for (auto& input : inputs)
    {
        input.displacement = input.felt = 0;
        input.energy = 0;
        input.recentCount = 0;
        std::fill (input.squares.begin(), input.squares.end(), 0.0);
    }
}
} // namespace antinode
