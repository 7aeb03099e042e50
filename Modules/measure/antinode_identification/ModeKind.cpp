#include "ModeKind.h"

#include "ChannelPhases.h"

#include <antinode_base/NumberText.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
constexpr double negligible = 1e-4;      // of the energy: a hundredth of the velocities
constexpr double evident = 1e-7;         // the same, weighted: lines with much misfit count little then
constexpr double mostOfMisfit = 2.0 / 3; // resonances that differ from point to point look complex by half

struct ActiveChannels
{
    double points = 0, references = 0, columns = 0;
};

ActiveChannels activeChannels (const PreparedResponses& data)
{
    const Eigen::MatrixXd table =
        (data.columnWeights.array() > 0).cast<double>().reshaped (data.points(), data.references());
    return { table.rowwise().maxCoeff().sum(), table.colwise().maxCoeff().sum(), table.sum() };
}

ModeKind real (const std::string& reason)
{
    return { false, "Modes are real: " + reason + "." };
}

std::string ratioInWords (double ratio, double limit)
{
    return "F " + fixedText (ratio, 2) + ", of real modes once in a thousand above " + fixedText (limit, 2);
}

ModeKind noGain (double ratio, double limit)
{
    return real ("complex shapes describe the responses no better than noise allows ("
                 + ratioInWords (std::max (ratio, 0.0), limit) + ")");
}
} // namespace

double limitOfRatio (double numbers)
{
    constexpr double normalQuantile = 3.0902;
    const auto spread = 2 / (9 * numbers);
    return std::pow (1 - spread + normalQuantile * std::sqrt (spread), 3);
}

std::optional<ModeKind> evidentlyReal (const NormalModeFit& fit, const FreeResidues& residues,
                                       const PreparedResponses& data, double ridge)
{
    const auto energy = residues.products.energies.dot (data.columnWeights);

    if (fit.cost < evident * energy)
        return real ("real shapes leave only " + fixedText (10 * std::log10 (std::max (fit.cost / energy, 1e-30)), 0)
                     + " dB of the responses");

    const auto active = activeChannels (data);
    const auto modes = static_cast<double> (fit.modes.modes());
    const auto freeNumbers = 2 * modes * active.columns;
    const auto numbers = std::max (1.0, freeNumbers - modes * (active.points + active.references - 1));
    const auto values = 2 * static_cast<double> (data.lines()) * active.columns;
    const auto left = std::max (freeCost (residues, data.columnWeights, ridge), 1e-30 * energy);
    const auto variance = left / std::max (values - freeNumbers, 1.0);
    const auto ratio = (fit.cost - left) / numbers / variance, limit = limitOfRatio (numbers);
    return ratio > limit ? std::optional<ModeKind>() : noGain (ratio, limit);
}

ModeKind decideModeKind (const FitErrors& realErrors, const FitErrors& complexErrors, const FreeResidues& complexFit,
                         double delay, const PreparedResponses& data)
{
    const Eigen::VectorXd isActive = (data.columnWeights.array() > 0).cast<double>();
    const auto total = [&] (const Eigen::MatrixXd& values) { return values.colwise().sum().dot (isActive); };
    // The noise of each span and column is seen from line to line, free of what a fit leaves smoothly.
    const Eigen::MatrixXd variances =
        (complexErrors.roughness.array().colwise() / complexErrors.lines.array()).max (1e-300);
    const auto leftByReal = total (realErrors.energies.cwiseQuotient (variances));
    const auto left = total (complexErrors.energies.cwiseQuotient (variances));
    const auto active = activeChannels (data);
    const auto values = complexErrors.lines.sum() * active.columns;
    const auto numbers = static_cast<double> (complexFit.basis.modes()) * (active.points + active.references - 1);
    const auto ratio = 2 * (leftByReal - left) / numbers / std::max (1.0, left / values);
    const auto limit = limitOfRatio (numbers);

    if (ratio <= limit)
        return noGain (ratio, limit);

    if (const auto gain =
            (total (realErrors.energies) - total (complexErrors.energies)) / realErrors.dataEnergies.dot (isActive);
        gain < negligible)
        return real ("complex shapes would explain no more than "
                     + fixedText (10 * std::log10 (std::max (gain, 1e-30)), 0) + " dB of the responses");

    const auto energy = total (realErrors.energies), noise = total (complexErrors.roughness);
    const auto share = (energy - total (complexErrors.energies)) / std::max (energy - noise, 1e-300);
    const auto percent = fixedText (100 * std::min (share, 1.0), 0) + " %";

    if (share < mostOfMisfit)
        return real ("complex shapes explain only " + percent
                     + " of the residual of real ones above the noise; complex modes explain 67 % or more");

    const auto& omega = complexFit.basis.angularFrequencies;
    const Eigen::MatrixXcd residues =
        (omega.array() * std::complex<double> (0, delay)).exp().matrix().asDiagonal() * complexFit.residues;

    if (phasesAreOfChannels (residues, omega, data.columnWeights)
        || channelAgreements (residues, data.points()).minCoeff() < oppositeAgreement)
        return real ("phases differ from channel to channel, not from mode to mode");

    return { true, "Modes are complex: complex shapes explain " + percent + " of what real ones leave above the noise ("
                       + ratioInWords (ratio, limit) + ")." };
}
} // namespace antinode
