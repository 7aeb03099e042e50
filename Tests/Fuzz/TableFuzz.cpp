#include "Fuzz.h"

#include <antinode_responses/CsvResponses.h>

/** Tables of text. */
void antinode::test::fuzz (std::string_view bytes)
{
    constexpr auto forms = 6;
    const auto form = bytes.empty() ? 0 : static_cast<unsigned char> (bytes.back()) % forms;
    const auto measurement = mergedResponses ({ measurementFromCsv (bytes, "file", static_cast<CsvForm> (form)) }, {});
    validate (measurement.responses);
}
