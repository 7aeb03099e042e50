#pragma once

#include "SweepInputs.h"

#include <antinode_numerics/ParallelFor.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace antinode
{
/** What became of a case. */
struct CaseResult
{
    std::vector<double> values; ///< Of all columns; NaN where there is none.
    std::string error;          ///< Why there are none; empty where there are.
};

/** Cases that follow each other, which are computed and kept together. */
struct SweepPart
{
    std::uint64_t first = 0, count = 0;
};

/** Of bytes and the version of the program: 32 hexadecimal digits. [worker] */
std::string hashOf (std::string bytes);

/** A few cases to many, so that there are some 500 parts and a part is at most 10 000 cases. They depend on the number
   of cases alone, whoever computes them. [any] */
std::vector<SweepPart> sweepParts (std::uint64_t cases);

/** The results of a part, as bytes. @param hash  of all that the cases depend on [worker] */
std::string encodePart (const std::string& hash, std::uint64_t first, const std::vector<CaseResult>&);

/** What a part's bytes hold. */
struct DecodedPart
{
    std::string hash;
    std::uint64_t first = 0;
    std::vector<CaseResult> results;
};

/** Reads what encodePart gave, from bytes of anybody.
    @throws InputError  when they are damaged
    [worker] */
DecodedPart decodePart (std::string_view bytes);

/** Some of the parts of a sweep: every so many-th. */
struct SweepShard
{
    std::uint64_t index = 1, count = 1; ///< 1 to count
};

/** "3/7". @throws InputError  for anything that is none [any] */
SweepShard readShard (const std::string& text);

/** A folder that keeps the parts of many cases that have been computed. Any number of processes, also on other
   computers, may fill it at once, and may be killed at any moment: a part is there whole or not at all.
    Docs/Design/sweeps.md. */
class PartFolder
{
public:
    /** Makes the folder where it is missing; parts lie in its folder "parts".
        @param hash   of all that the cases depend on: parts of another one are refused
        @param cases  how many
        @throws InputError  when it cannot be made [worker] */
    PartFolder (const std::filesystem::path&, const std::string& hash, std::uint64_t cases);

    /** The parts of a shard that are not there yet, or are damaged, by their indices.
        @throws InputError  when a part has another hash [worker] */
    std::vector<std::size_t> missing (SweepShard) const;

    /** How many parts are there by their names, without a look at what they hold: of a running sweep. [worker] */
    std::size_t written() const;

    /** All parts. */
    const std::vector<SweepPart>& parts() const { return all; }

    /** How many cases some parts have. [any] */
    std::uint64_t casesOf (const std::vector<std::size_t>& some) const;

    /** Keeps a part. @throws InputError  when it cannot be written [worker, several at once] */
    void write (std::size_t part, const std::vector<CaseResult>&) const;

    /** Keeps a part that another process has encoded.
        @throws InputError  when the bytes are damaged, have another hash, or cannot be written
        [worker, several at once] */
    void keep (std::size_t part, std::string_view bytes) const;

    /** The results of a part that is there. @throws InputError  when it is missing or damaged, or has another hash
        [worker] */
    std::vector<CaseResult> read (std::size_t part) const;

    /** Removes what killed processes have left. [worker] */
    void tidy() const;

private:
    std::filesystem::path pathOf (std::size_t part) const;

    std::filesystem::path folder;
    std::string hash;
    std::vector<SweepPart> all;
};

/** Keeps a file that is there whole or not at all, under a name that no other process uses until then.
    @throws InputError  when it cannot be written [worker, several at once] */
void writeAtomically (const std::filesystem::path&, std::string_view content);

/** Gives the result of a case, on any thread. */
using EvaluateCase = std::function<CaseResult (std::uint64_t number)>;

/** The results of the cases of a part, one after the other. @param done  called after each case
    @throws Cancelled  when a watch of this thread says no
    [worker] */
std::vector<CaseResult> computePart (const EvaluateCase&, SweepPart, const std::function<void()>& done);

/** Computes parts and keeps them, on all cores.
    @param show  how many cases are done
    @throws Cancelled  when a watch of this thread says no; parts that are finished stay
    [worker] */
void computeParts (const EvaluateCase&, const PartFolder&, const std::vector<std::size_t>& parts, std::size_t threads,
                   const ShowCases& show);

/** A folder that keeps a plan, as plan.json, with its parts. It is made where it is missing.
    @throws InputError  when it cannot be written or belongs to another plan
    [worker] */
PartFolder sweepFolder (const std::filesystem::path&, const SweepInputs&);
} // namespace antinode
