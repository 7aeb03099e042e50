#pragma once

#include "FingerFilters.h"
#include "Waveforms.h"

#include <Eigen/Core>
#include <antinode_fingers/Sensation.h>

#include <array>
#include <span>
#include <vector>

namespace antinode
{
/** The newest values of some signals, always in one piece: each is written twice. */
class SlidingWindow
{
public:
    /** @param signals  one a row @param length  values that are kept [worker] */
    SlidingWindow (Eigen::Index signals, Eigen::Index length);

    /** Takes the place of the oldest values. [audio thread] */
    auto next()
    {
        position = (position + 1) % length;
        return values.col (position);
    }

    /** To be called when next() is filled. [audio thread] */
    void complete() { values.col (position + length) = values.col (position); }

    /** signals x length, the oldest value first. [audio thread] */
    auto newest() const { return values.middleCols (position + 1, length); }

    /** All values are 0. [audio thread] */
    void reset() { values.setZero(); }

private:
    Eigen::Index length, position = 0;
    Eigen::MatrixXf values;
};

/** Plays filters: inputs at the sample rate, decimated, filtered, voltages interpolated. Banks are exchanged with a
    cross-fade; they all see the same past, so that a new one sounds at once as if it had played all the time. The
    samples do not depend, to the bit, on how time is cut into blocks. */
class FilterPlayer
{
public:
    /** @param bank  the sizes of this one are those of all; it must live on until another one has taken its place
        @param fade  of banks, samples of the filters, at least 1
        [worker] */
    FilterPlayer (const FilterBank& bank, Eigen::Index fade);

    /** Fades to another bank of the same sizes, which must live on as the first; not while it fades.
        [audio thread] */
    void fadeTo (const FilterBank&);

    /** Whether two banks are in use. [audio thread] */
    bool isFading() const { return next != nullptr; }

    /** The bank that plays, or the older of two. [audio thread] */
    const FilterBank& playing() const { return *bank; }

    /** As if nothing had been played; of two banks the newer one is left. [audio thread] */
    void reset();

    /** One sample: inputs in m, voltages in V, which follow by the filters' latency. Allocates nothing.
        @param inputs   one per input: what is not finite counts as 0
        @param outputs  one per ceramic
        [audio thread] */
    void process (const Eigen::Ref<const Eigen::VectorXf>& inputs, Eigen::Ref<Eigen::VectorXf> outputs);

    /** Whether the last sample completed one of the filters' rate. [audio thread] */
    bool hasDecimated() const { return phase == 1 || factor == 1; }

    /** An input at the filters' rate, m: as many samples as there are taps, the oldest first. [audio thread] */
    auto decimated (std::size_t input) const { return slow[input].newest(); }

private:
    void decimate();
    void filter();
    void addFiltered (const FilterBank&, float share);

    const FilterBank* bank;
    const FilterBank* next = nullptr;
    Eigen::Index factor, phase = 0, fade, faded = 0;
    Eigen::VectorXf decimation;
    Eigen::MatrixXf interpolation; // 2 rateChangeReach + 1 x factor: the taps of each phase, those of the oldest first
    SlidingWindow fast;            // inputs at the sample rate
    std::vector<SlidingWindow> slow; // each input at the rate of the filters
    SlidingWindow filtered;          // voltages at that rate
    Eigen::VectorXf sum;
};

/** What the inputs of fingers ask for: their largest displacement within the band, and how many times the threshold
    skin feels it. It is what filters are designed to give, not what a surface does. */
class InputMotion
{
public:
    /** @param rate    Hz, of the filters
        @param past    samples at that rate that take() is given, at least 3
        @param inputs  1 or more
        [worker] */
    InputMotion (double rate, TrackBand, const SkinThreshold&, Eigen::Index past, Eigen::Index inputs);

    /** One more sample. @param samples  m, the newest one last; they begin at least `past` before it [audio thread] */
    void take (std::size_t input, const Eigen::Ref<const Eigen::RowVectorXf>& samples);

    /** The largest magnitude within the band since the last call, m. [audio thread] */
    float takeDisplacement (std::size_t input);

    /** The largest amount since the last call, times the threshold: as feltAmount, with the RMS of the last 100 ms.
        [audio thread] Docs/Theory.md, section 5.1. */
    float takeFelt (std::size_t input);

    /** How many displacements are kept for takeRecent(). */
    static constexpr std::size_t mostRecent = 64;

    /** The displacements within the band since the last call, m, the oldest first; the first of them where there were
        more. They are valid until the next take(). [audio thread] */
    std::span<const float> takeRecent (std::size_t input);

    /** As if nothing had been taken. [audio thread] */
    void reset();

private:
    struct Input
    {
        float displacement = 0, felt = 0;
        double energy = 0;           // of the last samples
        std::vector<double> squares; // of those
        std::size_t oldest = 0;
        std::array<float, mostRecent> recent {};
        std::size_t recentCount = 0;
    };

    Eigen::VectorXf inBand, weighted; // taps, that of the oldest sample first
    std::vector<Input> inputs;
};
} // namespace antinode
