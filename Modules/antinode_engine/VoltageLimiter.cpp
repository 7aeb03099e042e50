#include "VoltageLimiter.h"

#include <antinode_model/InputError.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace antinode
{
VoltageLimiter::VoltageLimiter (Eigen::VectorXd voltageLimits)
    : limits (std::move (voltageLimits)), clamped (static_cast<std::size_t> (limits.size()), 0)
{
    if (! limits.allFinite() || (limits.array() < 0).any())
        throw InputError ("voltage limit", "must be a finite number of volts, at least 0, for every ceramic");
}

void VoltageLimiter::reset()
{
    std::fill (clamped.begin(), clamped.end(), 0);
    muted = false;
}

void VoltageLimiter::process (Eigen::Ref<Eigen::MatrixXd> voltages)
{
    for (Eigen::Index n = 0; n < voltages.cols(); ++n)
    {
        auto sample = voltages.col (n);
        muted = muted || ! sample.allFinite();

        if (muted)
        {
            sample.setZero();
            continue;
        }

        for (Eigen::Index i = 0; i < sample.size(); ++i)
        {
            if (std::abs (sample[i]) > limits[i])
            {
                sample[i] = std::copysign (limits[i], sample[i]);
                ++clamped[static_cast<std::size_t> (i)];
            }
        }
    }
}
} // namespace antinode
