#pragma once

#include "SweepPlan.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace antinode
{
/** All keys that vary, in the order of the plan. [any] */
std::vector<std::string> sweptKeys (const SweepPlan&);

/** What is recorded of each case: the plan's keys, then its points. [any] */
std::vector<std::string> sweepColumns (const SweepPlan&);

/** Those that are drawn: one share between 0 and 1 for each dimension of the plan, where its scheme puts the case.
    @param number  below plan.cases
    [any] Docs/Design/sweeps.md. */
std::vector<double> caseShares (const SweepPlan&, std::uint64_t number);

/** The values of all keys that vary, in the order of sweptKeys. They depend on the plan and the number only.
    @param number  below plan.cases [any] */
std::vector<nlohmann::json> caseValues (const SweepPlan&, std::uint64_t number);

/** All keys of a case with their values: those that are set, then those that vary. [any] */
std::vector<std::pair<std::string, nlohmann::json>> caseAssignments (const SweepPlan&, std::uint64_t number);

/** The seed of what is drawn for the modes of a case: that of the same draw of a tolerance study. [any] */
std::uint64_t deviationSeed (const SweepPlan&, std::uint64_t number);
} // namespace antinode
