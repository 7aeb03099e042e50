#pragma once

#include "CaseStudy.h"
#include "SweepInputs.h"
#include "SweepPart.h"

#include <cstdint>
#include <memory>

namespace antinode
{
/** Computes cases of a plan, on any number of threads. What several cases share, devices and designs, is made once. The
   same case gives the same numbers, whatever was computed before. */
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

    const SweepInputs& inputs() const { return *given; }

private:
    nlohmann::ordered_json summaryOf (std::uint64_t number) const;

    std::unique_ptr<const SweepInputs> given; ///< Where the study finds it.
    std::unique_ptr<const CaseStudy> study;
};
} // namespace antinode
