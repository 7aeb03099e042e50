#pragma once

#include "CairoContext.h"
#include "ChartFile.h"

#include <juce_graphics/juce_graphics.h>

#include <string>

namespace antinode
{
/** A file for print while it is drawn, in pixels of the screen: 5 are a millimetre. Text stays text: the fonts are
   embedded. The same bytes for the same drawing on every run. [worker] */
class VectorFile
{
public:
    /** @param width, height  of a page, pixels at scale 1 */
    VectorFile (VectorFormat, int width, int height);

    juce::Graphics& graphics() { return drawn; }

    /** What is drawn from now on is on a new page of a PDF. */
    void nextPage() { cairo_show_page (drawing.get()); }

    /** Ends the file. @throws std::runtime_error  where Cairo could not draw it */
    std::string finish();

private:
    VectorFormat format;
    std::string bytes;
    CairoSurface surface;
    CairoDrawing drawing;
    CairoContext context;
    juce::Graphics drawn;
};
} // namespace antinode
