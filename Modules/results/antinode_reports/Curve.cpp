#include "Curve.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace antinode
{
namespace
{
bool ascends (const CurvePiece& piece)
{
    return std::is_sorted (piece.begin(), piece.end(), [] (auto a, auto b) { return a.x < b.x; });
}

// On a logarithmic axis the same curve is dense at one end and sparse at the other.
bool haveNoGaps (const std::vector<CurveColumn>& columns, float columnWidth)
{
    const auto isWideStep = [=] (const auto& one, const auto& next) { return next.x - one.x > 1.5f * columnWidth; };
    return std::adjacent_find (columns.begin(), columns.end(), isWideStep) == columns.end();
}

// Without points that lie on the one before, as far as one can see: what remains has the same shape and is quick to
// stroke.
CurvePiece withoutRepeats (const CurvePiece& piece, float pixel)
{
    CurvePiece points;
    points.reserve (piece.size());
    for (const auto point : piece)
        if (points.empty() || point.getDistanceFrom (points.back()) > 0.25f * pixel)
            points.push_back (point);
    if (points.size() == 1)
        points.push_back (piece.back());
    return points;
}

juce::Path pathThrough (const CurvePiece& points)
{
    juce::Path path;
    path.preallocateSpace (static_cast<int> (3 * points.size()));
    path.startNewSubPath (points.front());
    for (std::size_t k = 1; k < points.size(); ++k)
        path.lineTo (points[k]);
    return path;
}

// Each column takes the extremes of its neighbours, up to half a line's width away: steep parts get the width of a
// line.
std::vector<CurveColumn> broadened (const std::vector<CurveColumn>& columns, std::size_t reach)
{
    auto broad = columns;
    for (std::size_t k = 0; k < columns.size(); ++k)
        for (auto other = k - std::min (k, reach); other < std::min (k + reach + 1, columns.size()); ++other)
        {
            broad[k].top = std::min (broad[k].top, columns[other].top);
            broad[k].bottom = std::max (broad[k].bottom, columns[other].bottom);
        }
    return broad;
}

// A band from the top to the bottom of each column: looks like the stroke of a dense curve and costs a tenth of it.
juce::Path band (const std::vector<CurveColumn>& columns, float width)
{
    juce::Path path;
    path.preallocateSpace (static_cast<int> (6 * columns.size()));
    path.startNewSubPath (columns.front().x, columns.front().top - width / 2);
    for (const auto& column : columns)
        path.lineTo (column.x, column.top - width / 2);
    for (auto column = columns.rbegin(); column != columns.rend(); ++column)
        path.lineTo (column->x, column->bottom + width / 2);
    path.closeSubPath();
    return path;
}

void strokePiece (juce::Graphics& g, const CurvePiece& piece, const CurveStyle& style)
{
    const juce::PathStrokeType stroke (style.width, juce::PathStrokeType::curved, juce::PathStrokeType::rounded);
    const auto path = pathThrough (piece);
    if (style.line == LineStyle::solid)
    {
        g.strokePath (path, stroke);
        return;
    }
    const juce::PathStrokeType butt (style.width, juce::PathStrokeType::curved, juce::PathStrokeType::butt);
    const auto unit = std::max (1.0f, style.width);
    const std::array<float, 2> lengths = style.line == LineStyle::dashed ? std::array { 4.5f * unit, 2.5f * unit }
                                                                         : std::array { 0.1f * unit, 2.0f * unit };
    juce::Path dashes;
    (style.line == LineStyle::dashed ? butt : stroke).createDashedStroke (dashes, path, lengths.data(), 2);
    g.fillPath (dashes);
}

void drawPiece (juce::Graphics& g, const CurvePiece& piece, const CurveStyle& style)
{
    if (piece.size() == 1)
        return drawDots (g, piece, 2 * style.width, style.colour);
    g.setColour (style.colour);
    const auto pixel = 1 / std::max (0.01f, g.getInternalContext().getPhysicalPixelScaleFactor());
    const auto pixelColumns = (piece.back().x - piece.front().x) / pixel;
    const auto isDense = static_cast<float> (piece.size()) > 2 * pixelColumns + 2;
    if (style.line != LineStyle::solid || ! isDense || ! ascends (piece))
        return strokePiece (g, withoutRepeats (piece, pixel), style);
    const auto columns = summariseColumns (piece, pixel);
    if (haveNoGaps (columns, pixel))
        g.fillPath (band (broadened (columns, static_cast<std::size_t> (0.5f * style.width / pixel)), style.width));
    else
        strokePiece (g, withoutRepeats (piece, pixel), style);
}
} // namespace

std::vector<CurvePiece> splitAtGaps (const CurvePiece& points)
{
    std::vector<CurvePiece> pieces;
    auto isOpen = false;
    for (const auto point : points)
    {
        const auto isFinite = point.isFinite();
        if (isFinite && ! isOpen)
            pieces.emplace_back();
        if (isFinite)
            pieces.back().push_back (point);
        isOpen = isFinite;
    }
    return pieces;
}

std::vector<CurveColumn> summariseColumns (const CurvePiece& piece, float columnWidth)
{
    std::vector<CurveColumn> columns;
    auto current = -1.0f;
    auto before = piece.empty() ? 0.0f : piece.front().y;
    for (const auto point : piece)
    {
        const auto index = std::floor ((point.x - piece.front().x) / columnWidth);
        if (index != current)
            columns.push_back ({ piece.front().x + (index + 0.5f) * columnWidth, before, before });
        current = index;
        before = point.y;
        columns.back().top = std::min (columns.back().top, point.y);
        columns.back().bottom = std::max (columns.back().bottom, point.y);
    }
    return columns;
}

void drawCurve (juce::Graphics& g, const CurvePiece& points, const CurveStyle& style)
{
    for (const auto& piece : splitAtGaps (points))
        drawPiece (g, piece, style);
}

void fillBelowCurve (juce::Graphics& g, const CurvePiece& points, float baseline, juce::Colour colour)
{
    g.setColour (colour);
    for (const auto& piece : splitAtGaps (points))
    {
        auto path = pathThrough (piece);
        path.lineTo (piece.back().x, baseline);
        path.lineTo (piece.front().x, baseline);
        path.closeSubPath();
        g.fillPath (path);
    }
}

void drawDots (juce::Graphics& g, const CurvePiece& points, float diameter, juce::Colour colour)
{
    g.setColour (colour);
    for (const auto point : points)
        if (point.isFinite())
            g.fillEllipse (juce::Rectangle<float> (diameter, diameter).withCentre (point));
}
} // namespace antinode
