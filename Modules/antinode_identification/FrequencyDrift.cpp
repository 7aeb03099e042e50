#include "FrequencyDrift.h"

#include <algorithm>
#include <numeric>

namespace antinode
{
namespace
{
/** The relative change at a mode, from its known neighbours on either side. */
double changeAt (const ModalModel& model, const ModeUpdate& update, Eigen::Index mode)
{
    const auto isKnown = [&update] (Eigen::Index k) { return update.isKnown[static_cast<std::size_t> (k)]; };
    const auto change = [&] (Eigen::Index k) { return update.angularFrequencies[k] / model.angularFrequencies[k]; };
    auto below = mode, above = mode;

    while (below >= 0 && ! isKnown (below))
        --below;

    while (above < model.modes() && ! isKnown (above))
        ++above;

    if (below < 0)
        return above < model.modes() ? change (above) : 1;

    if (above >= model.modes() || above == below)
        return change (below);

    const auto& omega = model.angularFrequencies;
    const auto width = omega[above] - omega[below];
    const auto share = width > 0 ? (omega[mode] - omega[below]) / width : 0.5;
    return change (below) + share * (change (above) - change (below));
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

ModalModel ascending (ModalModel model)
{
    std::vector<Eigen::Index> order (static_cast<std::size_t> (model.modes()));
    std::iota (order.begin(), order.end(), 0);
    std::stable_sort (order.begin(), order.end(),
                      [&model] (auto a, auto b) { return model.angularFrequencies[a] < model.angularFrequencies[b]; });
    auto result = model;
    result.angularFrequencies = model.angularFrequencies (order);
    result.dampingRatios = model.dampingRatios (order);
    result.shapes = model.shapes (Eigen::all, order);
    result.participation = model.participation (order, Eigen::all);

    if (model.slopes.size() > 0)
        result.slopes = model.slopes (Eigen::all, order);

    if (model.frequencyErrors.size() > 0)
        result.frequencyErrors = model.frequencyErrors (order);

    return result;
}
} // namespace antinode
