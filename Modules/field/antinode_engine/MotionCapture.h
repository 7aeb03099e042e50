#pragma once

#include <Eigen/Core>

#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

namespace antinode
{
/** The last movements of a surface, for those who look at them slowly: modal velocities at even steps of time, of
    which the window round the largest motion is given. A window that is much smaller than those of the last seconds
    is not: what rings down after an event would push the event away. One audio thread writes, one thread looks. */
class MotionCapture
{
public:
    /** @param modes   N_m, 1 or more
        @param frames  of a window, 2 or more
        @param memory  frames after which a smaller motion counts as the largest again
        [worker] allocates */
    MotionCapture (int modes, int frames, double memory);

    /** The modes at the next step of time. @param velocities  N_m, m/s kg^1/2 [audio thread] allocates nothing,
        locks nothing */
    void write (std::span<const double> velocities);

    /** The newest window, if there is one since the last call: then the next is looked for.
        @param window  becomes N_m x frames, the largest motion in the middle
        @return        false where there is none; then `window` stays as it is [any, one at a time] allocates */
    bool take (Eigen::MatrixXd& window);

private:
    void findPeak (double energy);

    static constexpr std::uint64_t windows = 4; ///< That are kept: a reader has so long to come.

    std::uint64_t modes, frames;
    std::vector<std::atomic<float>> ring; ///< Frame after frame.
    std::atomic<std::uint64_t> written { 0 };
    std::atomic<std::uint64_t> ready { 0 }; ///< The frame behind the window that was found; 0: none.
    double keep;                            ///< What a step leaves of `recent`.
    double recent = 0, peak = 0;            ///< Sums of squares. Of the audio thread, as the next line.
    std::uint64_t peakAt = 0;
};
} // namespace antinode
