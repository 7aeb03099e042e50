#pragma once

#include "Chart.h"

#include <string>

namespace antinode
{
struct Theme;

/** A chart as a PNG file: the same bytes for the same values on every run, with no display and no installed font.
    @param width, height  pixels at scale 1, 16 to 8192
    @param scale          pixels of the file for each of these, for crisp pictures on dense screens, 0.25 to 8
    @throws InputError    where a size is not allowed, or what draw() throws
    Any number of threads may call it at the same time: each draws on an image of its own, glyphs are shared behind a
   lock. A juce::ScopedJuceInitialiser_GUI that lives as long as the program frees what is shared; nothing else needs
   it. [worker] */
std::string renderPng (const Chart&, int width, int height, float scale, const Theme&);

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
