#include "DrawingFuzz.h"

/** SVG drawings. */
void antinode::test::fuzz (std::string_view bytes)
{
    fuzzDrawing (bytes);
}
