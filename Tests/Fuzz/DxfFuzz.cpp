#include "DrawingFuzz.h"

/** DXF drawings. */
void antinode::test::fuzz (std::string_view bytes)
{
    fuzzDrawing (bytes);
}
