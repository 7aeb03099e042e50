#include "VoltageLimiter.h"

#include <antinode_base/InputError.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
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

namespace
{
constexpr double aboveLimit = 1.001; // so that the limiter clamps, and counts, what is beyond
}

SlewLimiter::SlewLimiter (const Eigen::VectorXd& limitsToKeep, const Eigen::VectorXd& slews, double sampleRate)
    : limits (aboveLimit * limitsToKeep),
      steps ((slews.array() > 0).select (slews / sampleRate, std::numeric_limits<double>::infinity())),
      last (Eigen::VectorXd::Zero (limits.size()))
{
}

void SlewLimiter::process (const double* const* inputs, double* const* outputs, int count)
{
    for (Eigen::Index i = 0; i < limits.size(); ++i)
        for (int n = 0; n < count; ++n)
        {
            const auto wanted = inputs[i][n];

            if (std::isfinite (wanted))
                last[i] += std::clamp (std::clamp (wanted, -limits[i], limits[i]) - last[i], -steps[i], steps[i]);

            outputs[i][n] = std::isfinite (wanted) ? last[i] : wanted;
        }
}

namespace
{
constexpr int piece = 64; // samples

double safeGain (double gain)
{
    return gain > 0 && gain <= 1 ? gain : 0.0;
}
} // namespace

SafetyRamp::SafetyRamp (double gain) : start (safeGain (gain)), end (start) {}

void SafetyRamp::setTarget (double target, std::int64_t samples)
{
    start = gain();
    end = safeGain (target);
    length = left = std::max<std::int64_t> (0, samples);
}

double SafetyRamp::gain() const
{
    return left > 0 ? end + (start - end) * (static_cast<double> (left) / static_cast<double> (length)) : end;
}

template <typename Sample>
void SafetyRamp::process (Sample* const* channels, int channelCount, int count)
{
    if (left == 0 && end == 1) // As nearly always: armed, and no sample changes.
        return;

    std::array<Sample, piece> gains;

    for (int done = 0; done < count;)
    {
        const auto samples = std::min (piece, count - done);

        for (int n = 0; n < samples; ++n)
        {
            left -= left > 0;
            gains[static_cast<std::size_t> (n)] = static_cast<Sample> (gain());
        }

        for (int i = 0; i < channelCount; ++i)
            std::transform (gains.data(), gains.data() + samples, channels[i] + done, channels[i] + done,
                            std::multiplies<>());

        done += samples;
    }
}

template void SafetyRamp::process (double* const*, int, int);
template void SafetyRamp::process (float* const*, int, int);
} // namespace antinode
