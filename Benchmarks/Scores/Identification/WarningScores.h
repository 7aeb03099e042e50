#pragma once

#include "Support/MeasuredStructure.h"

#include <map>
#include <string>

namespace antinode::test
{
/** Modes, and how many of them are wrong: not there, or frequency in half widths, damping, or the product of shape and
    participation off by a tenth. */
struct Worth
{
    int all = 0, wrong = 0;
};

/** What warnings of single modes are worth. */
struct WarningScores
{
    Worth modes, withAny;
    std::map<std::string, Worth> ofEach; ///< By the warning without its numbers.
};

void add (WarningScores&, const IdentifiedModes&, const KnownStructure&);

/** Precision and recall, a line each. */
void print (const WarningScores&);
} // namespace antinode::test
