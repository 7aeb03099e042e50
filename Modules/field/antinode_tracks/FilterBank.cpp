#include "FilterBank.h"

#include <numeric>

namespace antinode
{
FilterBank silentBank (Eigen::Index ceramics, Eigen::Index inputs, FilterTiming timing)
{
    return { inputs, timing.taps, timing.factor, Eigen::MatrixXf::Zero (ceramics, inputs * timing.taps),
             std::vector<bool> (static_cast<std::size_t> (inputs), false) };
}

FilterBank filterBank (const FingerFilters& filters, const std::vector<Eigen::Index>& inputOfTrack, Eigen::Index inputs)
{
    const auto& first = filters.taps.front();
    auto bank = silentBank (first.cols(), inputs, { filters.factor, filters.delay, first.rows() });

    for (std::size_t j = 0; j < inputOfTrack.size(); ++j)
    {
        bank.values.middleCols (inputOfTrack[j] * bank.taps, bank.taps) =
            filters.taps[j].colwise().reverse().transpose().cast<float>();
        bank.moves[static_cast<std::size_t> (inputOfTrack[j])] = true;
    }

    return bank;
}

FilterBank filterBank (const FingerFilters& filters)
{
    std::vector<Eigen::Index> inputs (filters.taps.size());
    std::iota (inputs.begin(), inputs.end(), Eigen::Index { 0 });
    return filterBank (filters, inputs, static_cast<Eigen::Index> (inputs.size()));
}
} // namespace antinode
