#pragma once

#include "Deviation.h"
#include "PartFolder.h"
#include "SweepInputs.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace antinode
{
/** The keys of a case with their values. */
using CaseKeys = std::vector<std::pair<std::string, nlohmann::json>>;

/** What the cases of a plan are about: how keys come to results. Used by any number of threads; the same keys give the
    same results, whatever was asked before. */
class CaseStudy
{
public:
    virtual ~CaseStudy() = default;

    /** Reads the documents with these keys. @throws InputError  where they are wrong [worker] */
    virtual void check (const CaseKeys&) const = 0;

    /** What summary.json says of a case.
        @param seed  of what is drawn of its deviation
        @throws InputError  where it cannot be computed
        [worker] */
    virtual nlohmann::ordered_json summary (const CaseKeys&, const Deviation&, std::uint64_t seed) const = 0;
};

/** How many of what cases share a study keeps, the latest: memory does not grow. */
inline constexpr std::size_t devicesToKeep = 2, designsToKeep = 8;

/** The key of a summary under which what is recorded at the points of a plan lies. */
inline constexpr auto pointKey = "field_at_points_mm_s";

/** The keys that begin so, without their beginning: those of one document. [any] */
CaseKeys keysOf (const CaseKeys&, std::string_view prefix);

/** Keys and values as one text, for what depends on them. [any] */
std::string textOf (const CaseKeys&);

/** A document with its keys. @throws InputError  where there is no place for one [worker] */
nlohmann::json assigned (nlohmann::json, const CaseKeys&);

/** The device of a case, with its keys. @throws InputError  where there is no place for one [worker] */
nlohmann::json deviceDocument (const SweepInputs&, const CaseKeys&);

/** What it depends on. [any] */
std::string deviceText (const CaseKeys&);

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
