#pragma once

#include "Chart.h"

#include <juce_graphics/juce_graphics.h>

#include <vector>

namespace antinode
{
/** Consecutive points of a curve, in pixels. */
using CurvePiece = std::vector<juce::Point<float>>;

/** The part of a curve in one column of pixels, in pixels (y downwards): top and bottom also cover the step from
    the column before. */
struct CurveColumn
{
    float x = 0; ///< Of the column's middle.
    float top = 0, bottom = 0;
};

/** The style of a curve. */
struct CurveStyle
{
    juce::Colour colour;
    float width = 1.5f;
    LineStyle line = LineStyle::solid;
};

/** Splits points where one is not finite. [any] */
std::vector<CurvePiece> splitAtGaps (const CurvePiece& points);

/** Sums up points whose x ascends, column by column: no extreme is lost, however many points there are.
    @param columnWidth  pixels, more than 0 [any] */
std::vector<CurveColumn> summariseColumns (const CurvePiece&, float columnWidth);

/** Draws a curve; solid ones of many points per pixel as the band that they fill. Points that are not finite leave a
    gap. [any] */
void drawCurve (juce::Graphics&, const CurvePiece& points, const CurveStyle&);

/** Tints the area between a curve and a baseline. [any] */
void fillBelowCurve (juce::Graphics&, const CurvePiece& points, float baseline, juce::Colour);

/** Draws a dot on each finite point. [any] */
void drawDots (juce::Graphics&, const CurvePiece& points, float diameter, juce::Colour);
} // namespace antinode
