#pragma once

#include "TrackSignal.h"
#include <antinode_fingers/SkinThreshold.h>

#include <Eigen/Core>

#include <array>
#include <span>
#include <vector>

namespace antinode
{
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
