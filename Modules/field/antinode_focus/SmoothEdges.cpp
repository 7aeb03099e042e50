#include "SmoothEdges.h"

#include <antinode_numerics/KaiserSinc.h>
#include <antinode_numerics/SampleInterpolation.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antinode
{
Eigen::MatrixXd withSmoothEdges (const Eigen::MatrixXd& samples, double timeConstant)
{
    if (! (timeConstant > 0))
        return samples;

    const auto part = -std::expm1 (-1 / timeConstant);
    Eigen::MatrixXd smooth = part * samples;

    for (Eigen::Index n = 1; n < smooth.cols(); ++n)
        smooth.col (n) += (1 - part) * smooth.col (n - 1);

    return smooth;
}

Eigen::MatrixXd smoothEdgesAdjoint (Eigen::MatrixXd weights, double timeConstant)
{
    if (! (timeConstant > 0))
        return weights;

    const auto part = -std::expm1 (-1 / timeConstant);
    weights *= part;

    for (auto n = weights.cols() - 2; n >= 0; --n)
        weights.col (n) += (1 - part) * weights.col (n + 1);

    return weights;
}

SampledSlopes slopesOf (const SampledVoltages& voltages)
{
    constexpr Eigen::Index places = 8;
    const auto rate = voltages.playback.sampleRate;
    const Eigen::MatrixXd fine = interpolated (voltages.values.transpose(), places).transpose();
    const auto count = fine.cols() - 1;
    const auto interval = 1 / (rate * places);
    const auto first = voltages.firstTime - kaiserSincHalfWidth / rate + interval / 2;
    return { (fine.rightCols (count) - fine.leftCols (count)) / interval, first,
             first + static_cast<double> (count - 1) * interval };
}

SampledVoltages withSlowEnd (const SampledVoltages& voltages, const Eigen::VectorXd& slewLimits, double focusTime)
{
    constexpr double room = 0.9; // of the limit: where the fade begins it bends
    const auto rate = voltages.playback.sampleRate;
    const auto acting = static_cast<Eigen::Index> (std::ceil ((focusTime - voltages.firstTime) * rate - 1e-6))
                        + kaiserSincHalfWidth + 1;
    const auto kept = std::min (acting, voltages.values.cols());
    const Eigen::VectorXd end = voltages.values.col (kept - 1);
    double duration = 0; // samples

    for (Eigen::Index i = 0; i < end.size(); ++i)
        if (slewLimits[i] > 0)
            duration = std::max (duration, std::abs (end[i]) * 0.5 * std::numbers::pi * rate / (room * slewLimits[i]));

    const auto fade = static_cast<Eigen::Index> (std::ceil (duration)) + kaiserSincHalfWidth;
    auto result = voltages;
    result.values.resize (end.size(), kept + fade);
    result.values.leftCols (kept) = voltages.values.leftCols (kept);

    for (Eigen::Index n = 0; n < fade; ++n)
    {
        const auto level = std::cos (0.5 * std::numbers::pi * static_cast<double> (n + 1) / static_cast<double> (fade));
        result.values.col (kept + n) = level * level * end;
    }

    return result;
}
} // namespace antinode
