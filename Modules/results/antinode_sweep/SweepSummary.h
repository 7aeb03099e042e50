#pragma once

#include "SweepTable.h"

#include <array>
#include <string>
#include <vector>

namespace antinode
{
/** How one recorded number is distributed over the cases that have it. */
struct ColumnSummary
{
    std::string column;
    Eigen::Index count = 0; ///< Cases that have it.
    double mean = 0, deviation = 0, minimum = 0, maximum = 0;
    std::array<double, 5> percentiles {}; ///< At tolerancePercents.
    std::vector<double> correlations;     ///< Of ranks, with each key that varies.
};

/** What a sweep says at a glance. */
struct SweepSummary
{
    std::vector<ColumnSummary> columns;
};

/** Spearman's correlation of ranks, of the pairs that have both; 0 where one of them does not vary. [worker] */
double rankCorrelation (const Eigen::VectorXd& a, const Eigen::VectorXd& b);

/** [worker] */
SweepSummary summarise (const SweepTable&);

/** summary.json of a sweep. [worker] Docs/FileFormats.md. */
nlohmann::ordered_json sweepToJson (const SweepTable&, const SweepSummary&);

/** The percentiles as lines of text, then what failed. [any] */
std::string sweepInWords (const SweepTable&, const SweepSummary&);
} // namespace antinode
