#include "Fuzz.h"

#include <antinode_responses/UniversalFile.h>
#include <antinode_responses/UniversalResponses.h>

/** Universal files: read, written, read again; what was written once stays the same. */
void antinode::test::fuzz (std::string_view bytes)
{
    const auto sets = readUniversalFile (bytes, "file");
    std::string once;

    // Numbers that are not finite in sets that are not functions are refused by the writer.
    if (errorText ([&] { once = encodeUniversalFile (sets); }).empty())
        require (encodeUniversalFile (readUniversalFile (once, "written")) == once);

    const auto measurement = mergedResponses ({ measurementFromUniversal (sets, "file") }, {});
    validate (measurement.responses);
}
