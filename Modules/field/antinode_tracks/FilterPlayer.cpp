#include "FilterPlayer.h"

#include "RateChange.h"

#include <cmath>
#include <utility>

namespace antinode
{
namespace
{
constexpr auto interpolated = 2 * rateChangeReach + 1; // samples from which a voltage comes

/** Phase p of an interpolation is p samples later than the middle one of those it comes from. */
Eigen::MatrixXf phaseTaps (Eigen::Index factor)
{
    const auto taps = rateChangeTaps (factor);
    Eigen::MatrixXf phases = Eigen::MatrixXf::Zero (interpolated, factor);

    for (Eigen::Index phase = 0; phase < factor; ++phase)
        for (Eigen::Index k = 0; k < interpolated; ++k)
            if (const auto tap = (interpolated - 1 - k) * factor + phase; tap < taps.size())
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
      filtered (bankToPlay.values.rows(), interpolated), sum (bankToPlay.values.rows())
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
} // namespace antinode
