#pragma once

#include "PartFolder.h"
#include "SweepInputs.h"

#include <Eigen/Core>

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace antinode
{
/** All cases of a sweep with what became of them. */
struct SweepTable
{
    SweepInputs inputs;
    std::vector<std::string> columns;
    Eigen::MatrixXd values;          ///< Cases x columns; NaN where a case has none.
    std::vector<std::string> errors; ///< Of each case, empty where there is none.

    Eigen::Index cases() const { return values.rows(); }
    std::size_t failed() const;
};

/** All parts of a folder put together.
    @throws InputError  as PartFolder::read, and when parts are missing, saying how many [worker] */
SweepTable mergeParts (const PartFolder&, const SweepInputs&);

/** A row per case: its number, the keys that vary, what is recorded, its error.
    @param inWords  what an error says to the user
    [worker] Docs/FileFormats.md. */
std::string sweepToCsv (const SweepTable&, const std::function<std::string (std::string)>& inWords);

/** A column of numbers, one per case, for each key that varies and each that is recorded, and the cases' numbers:
   results.mat. What a case does not have is NaN. Texts are numbers of their rows in the plan, from 1. [worker] */
std::string sweepToMatlab (const SweepTable&);

/** The numbers of a key that varies: its values, or of texts the numbers of their rows in the plan, from 1.
    @param key  index among sweptKeys [worker] */
Eigen::VectorXd sweptNumbers (const SweepTable&, std::size_t key);

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
