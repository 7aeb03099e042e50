#include "RecordEffects.h"

#include <antinode_base/InputError.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace antinode
{
namespace
{
void restoreResidues (IdentifiedModes& modes, Eigen::Index mode, double length)
{
    constexpr double doubtful = 0.01;
    const auto omega = modes.angularFrequencies[mode], ratio = modes.dampingRatios[mode];
    const std::complex<double> pole (-ratio * omega, omega * std::sqrt (1 - ratio * ratio));
    const auto cut = std::exp (pole * length);
    modes.participation.row (mode) /= (1.0 - cut).real();

    if (modes.complexParticipation.size() > 0)
        modes.complexParticipation.row (mode) /= 1.0 - cut;

    if (std::abs (cut) > doubtful && static_cast<std::size_t> (mode) < modes.quality.size())
        modes.quality[static_cast<std::size_t> (mode)].warnings.emplace_back (
            "its impulse response is truncated before it has decayed to 1 %; record for longer");
}

void removeWindow (IdentifiedModes& modes, Eigen::Index mode, double windowDecay)
{
    auto& omega = modes.angularFrequencies[mode];
    auto& ratio = modes.dampingRatios[mode];
    const auto damped = omega * std::sqrt (1 - ratio * ratio), decay = ratio * omega - windowDecay;

    if (! (decay > 0))
        throw InputError ("exponential window", "has a larger decay rate than mode " + std::to_string (mode + 1)
                                                    + "; allowed: below " + std::to_string (ratio * omega) + " 1/s");

    omega = std::hypot (damped, decay);
    ratio = decay / omega;
}
} // namespace

FrequencyResponses withModalNumerators (FrequencyResponses responses, const RecordEffects& effects)
{
    const Eigen::ArrayXcd derivative = std::complex<double> (0, 2 * std::numbers::pi) * responses.frequencies.array();
    const Eigen::ArrayXcd factors = effects.windowDecay > 0
                                        ? Eigen::ArrayXcd (derivative / (derivative + effects.windowDecay))
                                        : Eigen::ArrayXcd::Ones (derivative.size());

    for (auto& values : responses.values)
        values.array().colwise() *= factors;

    for (auto& variances : responses.variances)
        variances.array().colwise() *= factors.abs2();

    return responses;
}

IdentifiedModes withoutRecordEffects (IdentifiedModes modes, const RecordEffects& effects)
{
    for (Eigen::Index mode = 0; mode < modes.modes(); ++mode)
    {
        if (effects.length > 0)
            restoreResidues (modes, mode, effects.length);

        if (effects.windowDecay > 0)
            removeWindow (modes, mode, effects.windowDecay);
    }

    return modes;
}
} // namespace antinode
