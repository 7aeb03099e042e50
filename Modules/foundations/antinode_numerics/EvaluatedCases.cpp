#include "EvaluatedCases.h"

namespace antinode
{
void CaseCounter::add (std::uint64_t cases)
{
    const std::lock_guard lock (mutex);
    done += cases;

    if (show)
        show (done);
}
} // namespace antinode
