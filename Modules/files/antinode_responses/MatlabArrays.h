#pragma once

#include "CsvResponses.h"
#include "MatlabFile.h"

#include <algorithm>

namespace antinode
{
/** A complex array of a MATLAB file with the frequencies of its lines. */
struct ResponseArray
{
    MatlabVariable values;       ///< One of its sizes is the number of frequencies.
    Eigen::VectorXd frequencies; ///< Hz
};

/** The names of a variable and of the structures it is in, from outside. [any] */
std::vector<std::string> pathOf (const MatlabVariable&);

/** Whether the short name of a variable is one of these. [any] */
template <typename Names>
bool isOneOf (const MatlabVariable& variable, const Names& names)
{
    return std::find (names.begin(), names.end(), shortName (variable)) != names.end();
}

/** How many of these names two variables share from outside. [any] */
std::size_t sharedPath (const MatlabVariable&, const MatlabVariable&);

/** All arrays that could be frequency responses: complex ones; pairs of real ones whose names differ in real and imag,
   re and im, or magnitude and phase; columns of frequencies and complex numbers; where there is none, columns of
   frequencies and two real numbers a response as the form says. Frequencies are a vector named f, freq, w ... (in kHz
   or rad/s where the name or a text beside it says so), first value and increment, or the only ascending vector that
   fits; of several those in the same structure.
    @throws InputError  where no array has frequencies: which variables there are, what is allowed
    [worker] Docs/FileFormats.md. */
std::vector<ResponseArray> responseArrays (const std::vector<MatlabVariable>&, CsvForm, const std::string& source);

/** The variables of a file for messages: "'f' (1001 x 1), 'H' (1001 x 12)". [any] */
std::string inventory (const std::vector<MatlabVariable>&);
} // namespace antinode
