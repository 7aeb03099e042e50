#pragma once

#include "PartFolder.h"
#include "SweepInputs.h"

#include <Eigen/Core>

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
} // namespace antinode
