#include "FilterBank.h"

namespace antinode
{
FilterBank filterBank (const FingerFilters& filters)
{
    const auto& first = filters.taps.front();
    FilterBank bank { static_cast<Eigen::Index> (filters.taps.size()), first.rows(), filters.factor, {} };
    bank.values.resize (first.cols(), bank.inputs * bank.taps);

    for (Eigen::Index j = 0; j < bank.inputs; ++j)
        bank.values.middleCols (j * bank.taps, bank.taps) =
            filters.taps[static_cast<std::size_t> (j)].colwise().reverse().transpose().cast<float>();

    return bank;
}
} // namespace antinode
