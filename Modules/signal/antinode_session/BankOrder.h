#pragma once

#include <span>
#include <vector>

namespace antinode
{
/** The places of a bank in the order in which they are designed: those that are wanted first, then the others outward
   from the first of them, by number. */
class BankOrder
{
public:
    /** A place, and whether it is urgent. */
    struct Next
    {
        int place = 0;
        bool isAwaited = false;
    };

    /** @param wantedFirst  of the places 0 to count - 1; others are skipped; none: 0 [any] */
    BankOrder (const std::vector<int>& wantedFirst, std::size_t count);

    /** Whether all were taken. [any] */
    bool isEmpty() const { return left.empty(); }

    /** Takes the next one: an urgent one before all others. Not where it is empty. [any] */
    Next take (std::span<const int> urgent);

private:
    std::vector<int> first, left; ///< Of the latter the next one in front.
};
} // namespace antinode
