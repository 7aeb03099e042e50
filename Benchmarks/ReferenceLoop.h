#pragma once

#include <benchmark/benchmark.h>

#include <cstdint>

namespace antinode::bench
{
/** Seconds that a fixed loop of dependent multiplications and additions takes now: what other times are divided by,
   because machines are shared and differ. The least of several runs. */
double referenceSeconds();

/** Adds to a benchmark what it costs in runs of the reference loop, measured just before it. */
class ReferenceRatio
{
public:
    explicit ReferenceRatio (benchmark::State&);

    /** Sets the counter "references". */
    ~ReferenceRatio();
    ReferenceRatio (const ReferenceRatio&) = delete;
    ReferenceRatio& operator= (const ReferenceRatio&) = delete;

private:
    benchmark::State& state;
    double reference;
    std::int64_t begin;
};
} // namespace antinode::bench
