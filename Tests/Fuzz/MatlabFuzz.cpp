#include "Fuzz.h"

#include <antinode_responses/MatlabResponses.h>

/** MATLAB files. */
void antinode::test::fuzz (std::string_view bytes)
{
    const auto measurement = mergedResponses (
        { measurementFromMatlab (readMatlabFile (bytes, "file"), "file", CsvForm::byHeadings, {}) }, {});
    validate (measurement.responses);
}
