#include "InstrumentMeters.h"

#include <algorithm>

namespace antinode
{
void ProbeTrace::write (const double* velocities, int count)
{
    const auto samples = samplesPerEntry.load (std::memory_order_relaxed);

    for (int n = 0; n < count; ++n)
    {
        const auto value = static_cast<float> (velocities[n]);
        current = inEntry == 0 ? Entry { value, value }
                               : Entry { std::min (current.smallest, value), std::max (current.largest, value) };

        if (++inEntry < samples)
            continue;

        const auto at = position.load (std::memory_order_relaxed);
        smallest[at % capacity].store (current.smallest, std::memory_order_relaxed);
        largest[at % capacity].store (current.largest, std::memory_order_relaxed);
        position.store (at + 1, std::memory_order_release);
        inEntry = 0;
    }
}

std::vector<ProbeTrace::Entry> ProbeTrace::newest (std::size_t count) const
{
    const auto end = written();
    const auto available = std::min<std::uint64_t> ({ end, count, capacity });
    std::vector<Entry> entries;
    entries.reserve (available);

    for (auto at = end - available; at < end; ++at)
        entries.push_back ({ smallest[at % capacity].load (std::memory_order_relaxed),
                             largest[at % capacity].load (std::memory_order_relaxed) });

    return entries;
}
} // namespace antinode
