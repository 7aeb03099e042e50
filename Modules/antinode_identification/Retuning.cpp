#include "Retuning.h"

#include "FrequencyDrift.h"
#include "KnownModeFit.h"
#include "KnownPoles.h"

#include <antinode_base/InputError.h>
#include <antinode_model/ShapesAtPlaces.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antinode
{
namespace
{
using Indices = std::vector<Eigen::Index>;

constexpr double reachOutside = 0.1; ///< Relative: modes so far outside the band may have drifted into it.

void check (const ModalModel& model, const FrequencyResponses& responses)
{
    if (responses.drive != DriveQuantity::voltage)
        throw InputError ("frequency responses",
                          "are per force; allowed: responses to voltages of the device's ceramics");

    if (static_cast<Eigen::Index> (responses.references.size()) != model.actuators())
        throw InputError ("frequency responses", "have " + std::to_string (responses.references.size())
                                                     + " references; allowed: the " + std::to_string (model.actuators())
                                                     + " ceramics of device '" + model.name + "'");
}

/** The modes that the measured band can say anything of; those that no ceramic drives are not heard. */
Indices modesNear (const ModalModel& model, const PreparedResponses& data)
{
    const auto lowest = data.omega[0] * (1 - reachOutside), highest = data.omega[data.lines() - 1] * (1 + reachOutside);
    Indices result;

    for (Eigen::Index k = 0; k < model.modes(); ++k)
        if (const auto omega = model.angularFrequencies[k];
            omega > lowest && omega < highest && model.participation.row (k).squaredNorm() > 0)
            result.push_back (k);

    if (result.empty())
        throw InputError ("frequency responses", "contain no mode of device '" + model.name + "'");

    return result;
}

/** Hz: above it the device may have modes that the model does not, which known ones would be taken for: half of the
    spacing above the last mode, or where the next one may have come down to. */
double highestLine (const ModalModel& model, const KnownSpread& spread)
{
    constexpr double farthest = 2;     // deviations
    constexpr double leastLeft = 0.75; // of the model's range, however little is known
    const auto last = model.modes() - 1, several = std::min<Eigen::Index> (5, last);

    if (several < 1)
        return 1e12;

    const auto highest = model.angularFrequencies[last];
    const auto spacing = (highest - model.angularFrequencies[last - several]) / static_cast<double> (several);
    const auto next = (highest + spacing) * std::max (leastLeft, 1 - farthest * spread.frequency);
    return std::min (highest + spacing / 2, next) / (2 * std::numbers::pi);
}

KnownModePrior priorOf (const KnownModes& known, const KnownSpread& spread, double drift)
{
    // Where the model has a node, a device has about this much of what the mode's other ceramics have.
    constexpr double leastOfOthers = 0.2;
    const Eigen::VectorXd others = leastOfOthers * known.participation.rowwise().norm()
                                   / std::sqrt (static_cast<double> (known.participation.cols()));
    Eigen::MatrixXd spreads (known.participation.rows(), known.participation.cols());

    for (Eigen::Index i = 0; i < spreads.cols(); ++i)
        spreads.col (i) =
            spread.participation * (known.participation.col (i).cwiseAbs2() + others.cwiseAbs2()).cwiseSqrt();

    return { drift * known.angularFrequencies,
             Eigen::VectorXd::Constant (known.modes(), spread.frequency),
             known.dampingRatios,
             spread.damping,
             known.participation,
             spreads };
}

/** What was fitted of some modes, put into the whole device. */
RetunedModel retuned (const ModalModel& model, const Indices& modes, const KnownModeFit& fit, const KnownPoles& poles,
                      const KnownSpread& spread, double highest)
{
    constexpr double seen = 0.5; // of what was not known before
    constexpr double beside = 2; // half widths of a mode that have to be below the highest line
    const auto all = model.modes();
    ModeUpdate update { Eigen::VectorXd::Zero (all), Eigen::VectorXd::Zero (all),
                        std::vector<bool> (static_cast<std::size_t> (all)) };
    RetunedModel result;
    result.frequencyDeviations.setConstant (all, spread.frequency);
    result.dampingDeviations.setConstant (all, spread.damping);
    result.participationDeviations.setConstant (all, spread.participation);
    auto participation = model.participation;
    participation *= fit.participationScales.asDiagonal();

    for (std::size_t n = 0; n < modes.size(); ++n)
    {
        const auto k = modes[n], of = static_cast<Eigen::Index> (n);
        const auto upperEnd = fit.modes.angularFrequencies[of] * (1 + beside * fit.modes.dampingRatios[of]);

        if (poles.gains[of] <= 0 || fit.frequencyDeviations[of] > seen * spread.frequency
            || upperEnd > 2 * std::numbers::pi * highest)
            continue;

        update.isKnown[static_cast<std::size_t> (k)] = true;
        update.angularFrequencies[k] = fit.modes.angularFrequencies[of];
        update.dampingRatios[k] = fit.modes.dampingRatios[of];
        participation.row (k) = fit.modes.participation.row (of);
        result.frequencyDeviations[k] = fit.frequencyDeviations[of];
        result.dampingDeviations[k] = fit.dampingDeviations[of];
        result.participationDeviations[k] = fit.participationDeviations[of];
    }

    if (std::none_of (update.isKnown.begin(), update.isKnown.end(), [] (bool isKnown) { return isKnown; }))
        throw InputError ("frequency responses", "contain no mode of device '" + model.name + "'");

    auto changed = updated (model, update);
    changed.participation = participation;

    if (changed.staticShare.size() > 0)
        changed.staticShare *= fit.participationScales.asDiagonal();

    result.found = update.isKnown;
    result.frequencyChanges = (changed.angularFrequencies.array() / model.angularFrequencies.array() - 1).matrix();
    result.dampingChanges = (changed.dampingRatios.array() / model.dampingRatios.array() - 1).matrix();
    result.participationScales = fit.participationScales;
    changed.origin = { ModeSource::retuned, static_cast<int> (fit.pointErrors.size()),
                       std::pow (10.0, std::min (0.0, fit.reconstructionError) / 20), model.origin.scaleIsKnown };

    if (model.origin.source == ModeSource::measured)
        changed.origin.source = ModeSource::measured;

    result.model = ascending (std::move (changed));
    result.pointErrors = fit.pointErrors;
    result.delay = fit.delay;
    result.reconstructionError = fit.reconstructionError;
    return result;
}
} // namespace

RetunedModel retune (const ModalModel& model, const FrequencyResponses& responses, const KnownSpread& spread)
{
    requireRealModes (model, "updates of modes by new measurements");
    validate (responses);
    check (model, responses);
    const auto shapes = shapesAtPlaces (model, responses.points);
    auto highest = highestLine (model, spread);
    auto data = prepare (responses, 0, highest);
    const auto modes = modesNear (model, data);
    const KnownModes known { model.angularFrequencies (modes), model.dampingRatios (modes), shapes (Eigen::all, modes),
                             model.participation (modes, Eigen::all) };
    const auto poles = findKnownPoles (data, known, spread);
    // Modes beyond the model have drifted with the others.
    highest *= poles.drift;
    data = prepare (responses, 0, highest);
    auto start = known;
    start.angularFrequencies = poles.angularFrequencies;
    start.dampingRatios = poles.dampingRatios;
    const auto fit = fitKnownModes (data, start, priorOf (known, spread, poles.drift), poles.delay);
    return retuned (model, modes, fit, poles, spread, highest);
}

std::optional<double> usualModelError (const ModalModel& model)
{
    const KnownSpread spread;
    return model.origin.source == ModeSource::drawn ? std::optional (std::hypot (spread.frequency, spread.drift))
                                                    : std::nullopt;
}
} // namespace antinode
