#include "FrequencyDrift.h"

#include "KnownModes.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace antinode
{
namespace
{
constexpr int neighbours = 5; // on either side: one alone may differ from the others as much as the mode itself

/** What known modes on one side say, mean values. */
struct Side
{
    double change = 0, angularFrequency = 0; ///< Relative, rad/s.
    int count = 0;
};

/** Of the known modes nearest to a mode. @param step  1: above it, -1: below it */
Side sideOf (const ModalModel& model, const ModeUpdate& update, Eigen::Index mode, Eigen::Index step)
{
    Side side;

    for (auto k = mode + step; k >= 0 && k < model.modes() && side.count < neighbours; k += step)
        if (update.isKnown[static_cast<std::size_t> (k)])
        {
            side.change += update.angularFrequencies[k] / model.angularFrequencies[k];
            side.angularFrequency += model.angularFrequencies[k];
            ++side.count;
        }

    side.change /= std::max (1, side.count);
    side.angularFrequency /= std::max (1, side.count);
    return side;
}

/** The relative change at a mode: its own or, where that is not known, between those of its known neighbours. */
double changeAt (const ModalModel& model, const ModeUpdate& update, Eigen::Index mode)
{
    if (update.isKnown[static_cast<std::size_t> (mode)])
        return update.angularFrequencies[mode] / model.angularFrequencies[mode];

    const auto below = sideOf (model, update, mode, -1), above = sideOf (model, update, mode, 1);

    if (below.count == 0 || above.count == 0)
        return below.count > 0 ? below.change : above.count > 0 ? above.change : 1;

    const auto width = above.angularFrequency - below.angularFrequency;
    const auto share = width > 0 ? (model.angularFrequencies[mode] - below.angularFrequency) / width : 0.5;
    return below.change + share * (above.change - below.change);
}
} // namespace

ModalModel updated (ModalModel model, const ModeUpdate& update)
{
    Eigen::VectorXd frequencies (model.modes());

    for (Eigen::Index k = 0; k < model.modes(); ++k)
        frequencies[k] = model.angularFrequencies[k] * changeAt (model, update, k);

    for (Eigen::Index k = 0; k < model.modes(); ++k)
        if (update.isKnown[static_cast<std::size_t> (k)])
            model.dampingRatios[k] = update.dampingRatios[k];

    model.angularFrequencies = frequencies;
    return model;
}

std::optional<double> usualModelError (const ModalModel& model)
{
    const KnownSpread spread;
    return model.origin.source == ModeSource::drawn ? std::optional (std::hypot (spread.frequency, spread.drift))
                                                    : std::nullopt;
}

ModalModel withModes (ModalModel model, const std::vector<Eigen::Index>& modes)
{
    model.angularFrequencies = model.angularFrequencies (modes).eval();
    model.dampingRatios = model.dampingRatios (modes).eval();
    model.shapes = model.shapes (Eigen::all, modes).eval();
    model.participation = model.participation (modes, Eigen::all).eval();

    if (model.slopes.size() > 0)
        model.slopes = model.slopes (Eigen::all, modes).eval();

    if (model.frequencyErrors.size() > 0)
        model.frequencyErrors = model.frequencyErrors (modes).eval();

    return model;
}

ModalModel ascending (ModalModel model)
{
    std::vector<Eigen::Index> order (static_cast<std::size_t> (model.modes()));
    std::iota (order.begin(), order.end(), 0);
    std::stable_sort (order.begin(), order.end(),
                      [&model] (auto a, auto b) { return model.angularFrequencies[a] < model.angularFrequencies[b]; });
    return withModes (std::move (model), order);
}
} // namespace antinode
