#include "VoltageLimiter.h"

#include <antinode_base/InputError.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace antinode
{
namespace
{
constexpr int limiterPiece =
    256; // samples: few enough that all ceramics' stay in the cache between the check and the clamp
} // namespace

VoltageLimiter::VoltageLimiter (Eigen::VectorXd voltageLimits)
    : limits (std::move (voltageLimits)),
      further (Eigen::VectorXd::Constant (limits.size(), std::numeric_limits<double>::infinity())),
      clamped (static_cast<std::size_t> (limits.size()), 0)
{
    if (! limits.allFinite() || (limits.array() < 0).any())
        throw InputError ("voltage limit", "must be finite and at least 0 V for every ceramic");
}

void VoltageLimiter::reset()
{
    std::fill (clamped.begin(), clamped.end(), 0);
    muted = false;
}

/** Clamps and counts the valid samples of a ceramic and silences the others. */
void VoltageLimiter::limit (std::size_t ceramic, double* samples, int valid, int count)
{
    const auto index = static_cast<Eigen::Index> (ceramic);
    clamped[ceramic] += kernel.clamp (samples, valid, std::min (further[index], limits[index]));
    std::fill (samples + valid, samples + count, 0.0);
}

void VoltageLimiter::process (double* const* channels, int count)
{
    for (int done = 0; done < count; done += limiterPiece)
    {
        const auto samples = std::min (limiterPiece, count - done);
        auto valid = muted ? 0 : samples;

        for (std::size_t i = 0; i < clamped.size(); ++i)
            valid = kernel.finiteSamples (channels[i] + done, valid);

        for (std::size_t i = 0; i < clamped.size(); ++i)
            limit (i, channels[i] + done, valid, samples);

        muted = muted || valid < samples;
    }
}

void VoltageLimiter::process (Eigen::Ref<Eigen::MatrixXd> voltages)
{
    Eigen::Matrix<double, 1, limiterPiece> row;

    for (Eigen::Index done = 0; done < voltages.cols(); done += limiterPiece)
    {
        auto part = voltages.middleCols (done, std::min<Eigen::Index> (limiterPiece, voltages.cols() - done));
        const auto samples = static_cast<int> (part.cols());
        auto valid = muted ? 0 : samples;

        for (Eigen::Index i = 0; i < part.rows(); ++i)
        {
            row.leftCols (samples) = part.row (i);
            valid = kernel.finiteSamples (row.data(), valid);
        }

        for (Eigen::Index i = 0; i < part.rows(); ++i)
        {
            row.leftCols (samples) = part.row (i);
            limit (static_cast<std::size_t> (i), row.data(), valid, samples);
            part.row (i) = row.leftCols (samples);
        }

        muted = muted || valid < samples;
    }
}
} // namespace antinode
