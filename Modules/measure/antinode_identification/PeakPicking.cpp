#include "PeakPicking.h"

#include "FitErrors.h"
#include "NormalModeFit.h"
#include "ShapeScales.h"

#include <antinode_base/InputError.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antinode
{
namespace
{
constexpr double minimumProminence = 4; // of powers: 6 dB above both valleys

struct Peak
{
    Eigen::Index line = 0;
    double angularFrequency = 0, dampingRatio = 0;
};

/** Sum over all columns of |H|^2, line by line. */
Eigen::VectorXd powers (const PreparedResponses& data)
{
    Eigen::VectorXd result (data.lines());

    for (Eigen::Index first = 0; first < data.lines(); first += 512)
    {
        const auto count = std::min<Eigen::Index> (512, data.lines() - first);
        const auto values = dataBlock (data, first, Eigen::VectorXcd::Ones (count));
        result.segment (first, count) = values.real.rowwise().squaredNorm() + values.imaginary.rowwise().squaredNorm();
    }

    return result;
}

/** Where the power has fallen to half of the peak's, on one side; negative when it rises above the peak before. */
double halfPowerFrequency (const Eigen::VectorXd& power, const Eigen::VectorXd& omega, Eigen::Index peak,
                           Eigen::Index step)
{
    const auto half = power[peak] / 2;

    for (auto f = peak + step; f >= 0 && f < power.size(); f += step)
    {
        if (power[f] > power[peak])
            break;

        if (power[f] <= half)
            return omega[f] + (half - power[f]) / (power[f - step] - power[f]) * (omega[f - step] - omega[f]);
    }

    return -1;
}

/** Whether the power falls by the prominence on both sides before it rises above the peak. */
bool isProminent (const Eigen::VectorXd& power, Eigen::Index peak)
{
    for (const Eigen::Index step : { -1, 1 })
    {
        auto f = peak;

        while (f >= 0 && f < power.size() && power[f] <= power[peak] && power[f] * minimumProminence > power[peak])
            f += step;

        if (f < 0 || f >= power.size() || power[f] > power[peak])
            return false;
    }

    return true;
}

Peak measured (const Eigen::VectorXd& power, const Eigen::VectorXd& omega, Eigen::Index line)
{
    const auto lower = halfPowerFrequency (power, omega, line, -1), upper = halfPowerFrequency (power, omega, line, 1);
    const auto width = lower > 0 && upper > 0 ? upper - lower
                       : lower > 0            ? 2 * (omega[line] - lower)
                       : upper > 0            ? 2 * (upper - omega[line])
                                              : omega[line];
    return { line, omega[line], std::clamp (width / (2 * omega[line]), 1e-6, 0.7) };
}

std::vector<Peak> findPeaks (const PreparedResponses& data, const std::vector<double>& selected)
{
    const auto power = powers (data);
    std::vector<Peak> peaks;

    if (selected.empty())
    {
        for (Eigen::Index f = 1; f + 1 < power.size(); ++f)
            if (power[f] > power[f - 1] && power[f] >= power[f + 1] && isProminent (power, f))
                peaks.push_back (measured (power, data.omega, f));

        return peaks;
    }

    // The largest value within 1 % of what the user names.
    for (const auto frequency : selected)
    {
        Eigen::Index best = 0;
        (data.omega.array() - 2 * std::numbers::pi * frequency).abs().minCoeff (&best);

        for (Eigen::Index f = 0; f < power.size(); ++f)
            if (std::abs (data.omega[f] / (2 * std::numbers::pi * frequency) - 1) < 0.01 && power[f] > power[best])
                best = f;

        peaks.push_back (measured (power, data.omega, best));
    }

    std::sort (peaks.begin(), peaks.end(), [] (const auto& a, const auto& b) { return a.line < b.line; });
    return peaks;
}
} // namespace

IdentifiedModes pickPeaks (const FrequencyResponses& responses, const IdentificationOptions& options)
{
    const auto data = prepare (responses, options.minimumFrequency, options.maximumFrequency);
    const auto peaks = findPeaks (data, options.selected);

    if (peaks.empty())
        throw InputError ("frequency responses", "have no peak with a prominence of at least 6 dB on both sides");

    const auto modes = static_cast<Eigen::Index> (peaks.size());
    IdentifiedModes result;
    result.drive = responses.drive;
    result.integrations = responses.integrations;
    result.references = responses.references;
    result.points = responses.points;
    result.delay = options.delay.value_or (0);
    result.angularFrequencies.resize (modes);
    result.dampingRatios.resize (modes);
    Eigen::MatrixXd residues (modes, data.columns());

    for (Eigen::Index k = 0; k < modes; ++k)
    {
        const auto& peak = peaks[static_cast<std::size_t> (k)];
        result.angularFrequencies[k] = peak.angularFrequency;
        result.dampingRatios[k] = peak.dampingRatio;
        // At resonance a velocity is phi alpha / (2 xi omega).
        residues.row (k) = dataBlock (data, peak.line, advances (data, peak.line, 1, result.delay)).real
                           * (2 * peak.dampingRatio * peak.angularFrequency);
    }

    result.participation = strongestParticipation (residues, data);
    result.shapes.resize (data.points(), modes);

    for (Eigen::Index k = 0; k < modes; ++k)
        result.shapes.col (k) =
            residues.row (k).reshaped (data.points(), data.references()) * result.participation.row (k).transpose();

    const auto unknown = std::numeric_limits<double>::quiet_NaN();
    result.deviations = { Eigen::VectorXd::Constant (modes, unknown), Eigen::VectorXd::Constant (modes, unknown),
                          Eigen::MatrixXd::Constant (data.points(), modes, unknown),
                          Eigen::MatrixXd::Constant (modes, data.references(), unknown), 0 };
    result.quality.resize (peaks.size());
    result.minimumFrequency = data.omega[0] / (2 * std::numbers::pi);
    result.maximumFrequency = data.omega[data.lines() - 1] / (2 * std::numbers::pi);
    scaleShapes (result, options.pointMasses);
    result.reconstructionError = modalRest (result, data).error;
    result.modalReconstructionError = result.reconstructionError;
    result.measuredReconstructionError = result.reconstructionError;
    return result;
}
} // namespace antinode
