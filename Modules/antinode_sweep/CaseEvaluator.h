#pragma once

#include "Deviation.h"
#include "SharedValues.h"
#include "SweepInputs.h"

#include <antinode_focus/WideDesign.h>
#include <antinode_structure/DeviceDescription.h>

#include <cstdint>
#include <string>
#include <vector>

namespace antinode
{
/** What became of a case. */
struct CaseResult
{
    std::vector<double> values; ///< Of all columns; NaN where there is none.
    std::string error;          ///< Why there are none; empty where there are.
};

/** What is recorded of each case: the plan's keys, then its points. [any] */
std::vector<std::string> sweepColumns (const SweepPlan&);

/** Computes cases of a plan, on any number of threads. A device that several cases share is solved once, and a focus
   that they share is designed once. The same case gives the same numbers, whatever was computed before. */
class CaseEvaluator
{
public:
    /** @param usesCache  of solved devices */
    CaseEvaluator (SweepInputs, bool usesCache);

    /** Looks for a case that can be computed and whether it has what is to be recorded.
        @throws InputError  where documents or recorded keys are wrong, or none of 16 cases can be computed
        [worker] */
    void check() const;

    /** A case. What it cannot do is its error. @param number  below plan.cases
        @throws Cancelled  when a watch of this thread says no
        [worker] */
    CaseResult evaluate (std::uint64_t number) const;

    const SweepInputs& inputs() const { return given; }

private:
    struct SolvedDevice;
    struct MadeDesign;
    using Assignments = std::vector<std::pair<std::string, nlohmann::json>>;

    std::shared_ptr<const SolvedDevice> deviceOf (const Assignments&) const;
    std::shared_ptr<const MadeDesign> designOf (const Assignments&) const;
    nlohmann::ordered_json summaryOf (std::uint64_t number) const;
    nlohmann::ordered_json closedForm (const MadeDesign&, const Deviation&, std::uint64_t seed) const;
    nlohmann::ordered_json rendered (const MadeDesign&, const Deviation&, std::uint64_t seed) const;

    SweepInputs given;
    Playback playback;
    DesignExtent extent;
    bool usesCache;
    mutable SharedValues<SolvedDevice> devices;
    mutable SharedValues<MadeDesign> designs;
};
} // namespace antinode
