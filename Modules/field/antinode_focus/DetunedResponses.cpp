#include "DetunedResponses.h"

#include "StateRows.h"

#include <antinode_base/Watch.h>

#include <array>
#include <cmath>

namespace antinode
{
namespace
{
/** A normally distributed error as three places, in standard deviations, with their shares. */
struct Node
{
    double place, share;
};

constexpr std::array<Node, 3> gaussHermite {
    { { 0, 2.0 / 3 }, { 1.7320508075688772, 1.0 / 6 }, { -1.7320508075688772, 1.0 / 6 } }
};

ModalModel modesWith (const ModalModel& model, double frequencyFactor, double dampingFactor)
{
    ModalModel modes;
    modes.angularFrequencies = model.angularFrequencies * frequencyFactor;
    modes.dampingRatios = (model.dampingRatios * dampingFactor).cwiseMin (0.999);
    return modes;
}
} // namespace

DetunedResponses detunedResponses (const ModalModel& model, const RowOrigin& origin, const DetuningSpread& spread)
{
    constexpr auto count = static_cast<Eigen::Index> (gaussHermite.size() * gaussHermite.size());
    const auto drives = static_cast<Eigen::Index> (origin.drives.size());
    const auto frequency = std::hypot (spread.frequency, spread.drift);
    DetunedResponses responses;
    responses.modes = origin.controlled;
    responses.modes.insert (responses.modes.end(), origin.guards.begin(), origin.guards.end());
    responses.values.assign (responses.modes.size(), Eigen::MatrixXd (count, drives));
    responses.errors = responses.values;
    const auto stateRows = rowsAt (origin.time, responses.modes, ModalQuantity::velocity);
    const auto known = rowResponses (modesWith (model, 1, 1), stateRows, origin.drives, origin.playback);
    Eigen::Index row = 0;

    for (const auto& f : gaussHermite)
        for (const auto& d : gaussHermite)
        {
            const auto off = rowResponses (modesWith (model, 1 + f.place * frequency, 1 + d.place * spread.damping),
                                           stateRows, origin.drives, origin.playback);
            const auto root = std::sqrt (f.share * d.share);

            for (std::size_t k = 0; k < responses.modes.size(); ++k)
            {
                checkWatch();
                const auto at = static_cast<Eigen::Index> (k);
                responses.values[k].row (row) = root * off.row (at);
                responses.errors[k].row (row) = responses.values[k].row (row);

                if (k < origin.controlled.size())
                    responses.errors[k].row (row) -= root * known.row (at);
            }

            ++row;
        }

    return responses;
}
} // namespace antinode
