#pragma once

#include "Chart.h"

#include <string>

namespace antinode
{
/** A file of lines and text that is sharp at any size. */
enum class VectorFormat
{
    svg,
    pdf
};

/** A chart for print: white page, black text, 5 pixels of the screen a millimetre, so that a figure of 900 pixels fills
   a page of 180 mm. Text stays text: the fonts are embedded. The same bytes for the same values on every run.
    @param width, height  pixels at scale 1, 16 to 8192
    @throws InputError    where a size is not allowed, or what draw() throws
    [worker] Docs/Design/scores.md */
std::string renderVector (const Chart&, int width, int height, VectorFormat);
} // namespace antinode
