#include "AnnotationDrawing.h"

#include "CurveDrawing.h"
#include "Lettering.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace antinode
{
namespace
{
constexpr auto limitGap = 5.0f;

float labelRowHeight (const Theme& theme)
{
    return theme.tickHeight * 1.2f;
}

template <typename Annotation>
bool anyLabel (const std::vector<Annotation>& annotations)
{
    return std::any_of (annotations.begin(), annotations.end(), [] (const auto& one) { return ! one.label.empty(); });
}

bool isInside (float position, float low, float high)
{
    return position >= low - 0.5f && position <= high + 0.5f;
}

// Rows of text that fill up from the left: says where a label fits, if anywhere.
struct LabelRows
{
    std::array<float, 2> filledTo { -1e9f, -1e9f };

    int rowFor (float left, float right)
    {
        for (std::size_t row = 0; row < filledTo.size(); ++row)
        {
            if (left < filledTo[row])
                continue;
            filledTo[row] = right + 8;
            return static_cast<int> (row);
        }
        return -1;
    }
};

int markerRows (const std::vector<Marker>& markers)
{
    return ! anyLabel (markers) ? 0 : markers.size() == 1 ? 1 : 2;
}
} // namespace

float heightAbove (const std::vector<Marker>& markers, const std::vector<Span>& spans, const Theme& theme)
{
    const auto rows = markerRows (markers) + (anyLabel (spans) ? 1 : 0);
    return static_cast<float> (rows) * labelRowHeight (theme) + (rows > 0 ? 3.0f : 0.0f);
}

float widthBeside (const std::vector<LimitLine>& limits, const Theme& theme)
{
    auto width = 0.0f;
    for (const auto& limit : limits)
        if (! limit.label.empty())
            width = std::max (width, textWidth (limit.label, { theme.tickHeight, false, {} }) + limitGap + 2);
    return width;
}

float markerRowBottom (const PlotFrame& frame, const std::vector<Span>& spans, const Theme& theme)
{
    return frame.plot.getY() - 3 - (anyLabel (spans) ? labelRowHeight (theme) : 0);
}

void drawSpans (juce::Graphics& g, const PlotFrame& frame, const std::vector<Span>& spans, const Theme& theme)
{
    const TextStyle style { theme.tickHeight, false, theme.mutedText };
    auto filledTo = frame.plot.getX() - 20;
    for (const auto& span : spans)
    {
        const auto left = std::clamp (frame.xAt (span.from), frame.plot.getX(), frame.plot.getRight());
        const auto right = std::clamp (frame.xAt (span.to), frame.plot.getX(), frame.plot.getRight());
        if (! (right > left))
            continue;
        g.setColour (theme.span);
        g.fillRect (juce::Rectangle<float> (left, frame.plot.getY(), right - left, frame.plot.getHeight()));
        const auto width = textWidth (span.label, style);
        const auto labelLeft = (left + right - width) / 2;
        if (labelLeft < filledTo)
            continue;
        drawText (g, span.label,
                  { labelLeft, frame.plot.getY() - 2 - labelRowHeight (theme), width, labelRowHeight (theme) },
                  juce::Justification::centred, style);
        filledTo = labelLeft + width + 5;
    }
}

void drawMarkers (juce::Graphics& g, const PlotFrame& frame, const std::vector<Marker>& markers, float firstRowBottom,
                  const Theme& theme)
{
    const TextStyle style { theme.tickHeight, false, theme.text };
    auto sorted = markers;
    std::erase_if (sorted, [] (const auto& marker) { return ! std::isfinite (marker.position); });
    std::sort (sorted.begin(), sorted.end(), [] (const auto& a, const auto& b) { return a.position < b.position; });
    LabelRows rows;
    for (const auto& marker : sorted)
    {
        const auto x = frame.xAt (marker.position);
        if (! isInside (x, frame.plot.getX(), frame.plot.getRight()))
            continue;
        const auto width = textWidth (marker.label, style);
        const auto left = std::clamp (x - width / 2, frame.plot.getX() - 20,
                                      std::max (frame.plot.getX(), frame.plot.getRight() + 10 - width));
        const auto row = rows.rowFor (left, left + width);
        const auto bottom = firstRowBottom - static_cast<float> (std::max (0, row)) * labelRowHeight (theme);
        // From the plot's edge only: a line up to the second row would cross names in the first.
        const CurvePiece line { { x, frame.plot.getY() }, { x, frame.plot.getBottom() } };
        drawCurve (g, line, { theme.background.withAlpha (0.5f), 3.0f, LineStyle::solid });
        drawCurve (g, line, { theme.text.withAlpha (0.75f), 1.2f, LineStyle::dashed });
        if (row >= 0)
            drawText (g, marker.label, { left, bottom - labelRowHeight (theme), width, labelRowHeight (theme) },
                      juce::Justification::centred, style);
    }
}

void drawLimits (juce::Graphics& g, const PlotFrame& frame, const std::vector<LimitLine>& limits, const Theme& theme)
{
    const TextStyle style { theme.tickHeight, false, theme.limit };
    auto sorted = limits;
    std::erase_if (sorted, [] (const auto& limit) { return ! std::isfinite (limit.value); });
    std::sort (sorted.begin(), sorted.end(), [] (const auto& a, const auto& b) { return a.value > b.value; });
    auto filledTo = frame.plot.getY() - style.height;
    for (const auto& limit : sorted)
    {
        const auto y = frame.yAt (limit.value);
        if (! isInside (y, frame.plot.getY(), frame.plot.getBottom()))
            continue;
        drawCurve (g, { { frame.plot.getX(), y }, { frame.plot.getRight(), y } },
                   { theme.limit, 1.2f, LineStyle::dashed });
        if (y - style.height / 2 < filledTo)
            continue;
        drawText (
            g, limit.label,
            { frame.plot.getRight() + limitGap, y - style.height / 2, textWidth (limit.label, style), style.height },
            juce::Justification::centredLeft, style);
        filledTo = y + style.height / 2;
    }
}
} // namespace antinode
