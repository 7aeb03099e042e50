#include "BankOrder.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

namespace antinode
{
namespace
{
bool contains (std::span<const int> places, int place)
{
    return std::find (places.begin(), places.end(), place) != places.end();
}
} // namespace

BankOrder::BankOrder (const std::vector<int>& wantedFirst, std::size_t count) : first (wantedFirst), left (count)
{
    const auto centre = first.empty() ? 0 : first.front();
    const auto priority = [this] (int place) { return std::find (first.begin(), first.end(), place) - first.begin(); };
    std::iota (left.begin(), left.end(), 0);
    std::stable_sort (left.begin(), left.end(),
                      [centre] (int one, int other) { return std::abs (one - centre) < std::abs (other - centre); });
    std::stable_sort (left.begin(), left.end(), [&] (int one, int other) { return priority (one) < priority (other); });
}

BankOrder::Next BankOrder::take (std::span<const int> urgent)
{
    auto found = std::find_if (left.begin(), left.end(), [urgent] (int place) { return contains (urgent, place); });

    if (found == left.end())
        found = left.begin();

    const auto place = *found;
    left.erase (found);
    return { place, contains (urgent, place) || contains (first, place) };
}
} // namespace antinode
