#include "MapOverlays.h"

#include "CurveDrawing.h"
#include "Lettering.h"

#include <antinode_base/Watch.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace antinode
{
namespace
{
constexpr auto crossArm = 7.0f;
constexpr auto tagWidthBeside = 6.0f, tagHeightBeside = 1.0f; // the text

// Lines and labels over a map stand on a halo of the page's colour: legible on every colour.
void drawWithHalo (juce::Graphics& g, const CurvePiece& line, float width, const Theme& theme)
{
    drawCurve (g, line, { theme.background.withAlpha (0.7f), width + 2, LineStyle::solid });
    drawCurve (g, line, { theme.text, width, LineStyle::solid });
}

CurvePiece closedCurve (const std::vector<Eigen::Vector2d>& line, const PlotFrame& frame)
{
    CurvePiece piece;
    for (const auto& place : line)
        piece.push_back (frame.at (place.x(), place.y()));
    if (! piece.empty())
        piece.push_back (piece.front());
    return piece;
}

juce::Rectangle<float> tagAt (const std::string& label, juce::Point<float> centre, const Theme& theme)
{
    const auto width = textWidth (label, { theme.tickHeight, false, {} }) + tagWidthBeside;
    return juce::Rectangle<float> (width, theme.tickHeight + tagHeightBeside).withCentre (centre);
}

void drawTag (juce::Graphics& g, const std::string& label, juce::Point<float> centre, const Theme& theme)
{
    if (label.empty())
        return;
    const TextStyle style { theme.tickHeight, false, theme.text };
    const auto tag = tagAt (label, centre, theme);
    g.setColour (theme.background.withAlpha (0.75f));
    g.fillRoundedRectangle (tag, 3);
    drawText (g, label, tag, juce::Justification::centred, style);
}

// All names in one size, so that "C10" is there where "C9" is; of those that no legible size fits, none.
float sizeOfNames (const PlotFrame& frame, const std::vector<MapRectangle>& rectangles, const Theme& theme)
{
    constexpr auto smallest = 0.6f;
    auto size = 1.0f;
    for (const auto& rectangle : rectangles)
    {
        if (rectangle.label.empty())
            continue;
        const auto one = frame.at (rectangle.xMinimum, rectangle.yMinimum);
        const auto other = frame.at (rectangle.xMaximum, rectangle.yMaximum);
        const auto width = textWidth (rectangle.label, { theme.tickHeight, false, {} });
        const auto fitting = std::min ((std::abs (other.x - one.x) - tagWidthBeside) / width,
                                       (std::abs (other.y - one.y) - tagHeightBeside) / theme.tickHeight);
        if (fitting >= smallest)
            size = std::min (size, fitting);
    }
    return size;
}

// Its name stands where it fits and hides no point.
void drawRectangle (juce::Graphics& g, const PlotFrame& frame, const MapRectangle& rectangle,
                    const std::vector<MapPoint>& points, const Theme& theme)
{
    const auto one = frame.at (rectangle.xMinimum, rectangle.yMinimum);
    const auto other = frame.at (rectangle.xMaximum, rectangle.yMaximum);
    if (! one.isFinite() || ! other.isFinite())
        return;
    if (rectangle.shape.empty())
        drawWithHalo (g, { one, { other.x, one.y }, other, { one.x, other.y }, one }, 0.6f * theme.lineWidth, theme);
    for (const auto& line : rectangle.shape)
        drawWithHalo (g, closedCurve (line, frame), 0.6f * theme.lineWidth, theme);
    const auto tag = tagAt (rectangle.label, (one + other) / 2.0f, theme);
    constexpr auto rounding = 0.01f;
    const auto fits = tag.getWidth() <= std::abs (other.x - one.x) + rounding
                      && tag.getHeight() <= std::abs (other.y - one.y) + rounding;
    const auto hidesPoint = std::any_of (points.begin(), points.end(),
                                         [&] (const auto& point)
                                         { return tag.expanded (crossArm).contains (frame.at (point.x, point.y)); });
    if (fits && ! hidesPoint)
        drawTag (g, rectangle.label, (one + other) / 2.0f, theme);
}

void drawPoint (juce::Graphics& g, const PlotFrame& frame, const MapPoint& point, const Theme& theme)
{
    constexpr auto arm = crossArm;
    const auto centre = frame.at (point.x, point.y);
    if (! centre.isFinite())
        return;
    drawWithHalo (g, { centre.translated (-arm, 0), centre.translated (arm, 0) }, 1.3f, theme);
    drawWithHalo (g, { centre.translated (0, -arm), centre.translated (0, arm) }, 1.3f, theme);
    const auto width = textWidth (point.label, { theme.tickHeight, false, {} });
    const auto side = centre.x + arm + width + 10 < frame.plot.getRight() ? 1.0f : -1.0f;
    drawTag (g, point.label, centre.translated (side * (arm + 5 + width / 2), -arm), theme);
}

// With its outer values repeated, so that lines go on to the edge of the map: half a cell beyond the outer values.
Eigen::MatrixXd withBorder (const Eigen::MatrixXd& values)
{
    const auto repeated = [] (Eigen::Index count)
    {
        Eigen::VectorXi indices = Eigen::VectorXi::LinSpaced (count + 2, -1, static_cast<int> (count));
        return indices.cwiseMax (0).cwiseMin (static_cast<int> (count) - 1).eval();
    };
    return values (repeated (values.rows()), repeated (values.cols()));
}

// Where hardly anything moves the sign is chance: values that neither reach the bound nor have a neighbour that does
// are left out.
Eigen::MatrixXd withoutStill (const Eigen::MatrixXd& values, double bound)
{
    Eigen::MatrixXd kept = Eigen::MatrixXd::Constant (values.rows(), values.cols(), std::nan (""));
    for (Eigen::Index column = 0; column < values.cols(); ++column)
        for (Eigen::Index row = 0; row < values.rows(); ++row)
        {
            const auto firstRow = std::max<Eigen::Index> (row - 1, 0),
                       firstColumn = std::max<Eigen::Index> (column - 1, 0);
            const auto around = values.block (firstRow, firstColumn, std::min (row + 2, values.rows()) - firstRow,
                                              std::min (column + 2, values.cols()) - firstColumn);
            if (around.cwiseAbs().maxCoeff() >= bound)
                kept (row, column) = values (row, column);
        }
    return kept;
}

double placeInRange (double index, Eigen::Index count, AxisRange range)
{
    const auto share = std::clamp ((index - 0.5) / static_cast<double> (count), 0.0, 1.0);
    return range.minimum + share * (range.maximum - range.minimum);
}

void drawLevel (juce::Graphics& g, const PlotFrame& frame, const Eigen::MatrixXd& bordered, double level,
                const CurveStyle& style)
{
    for (const auto& line : contourLines (bordered, level))
    {
        CurvePiece piece;
        piece.reserve (line.size());
        for (const auto& place : line)
            piece.push_back (frame.at (placeInRange (place.x(), bordered.cols() - 2, frame.x.range),
                                       placeInRange (place.y(), bordered.rows() - 2, frame.y.range)));
        drawCurve (g, piece, style);
    }
}
} // namespace

void drawContours (juce::Graphics& g, const PlotFrame& frame, const HeatMap& chart, const Theme& theme)
{
    const auto& contours = chart.contours;
    if (chart.values.size() == 0 || (contours.levels.empty() && ! contours.nodalLinesFrom))
        return;
    const auto bordered = withBorder (chart.values);
    if (contours.nodalLinesFrom)
        drawLevel (g, frame, withoutStill (bordered, *contours.nodalLinesFrom), 0,
                   { theme.text.withAlpha (0.5f), 0.5f * theme.lineWidth, LineStyle::solid });
    for (const auto level : contours.levels)
        drawLevel (g, frame, bordered, level,
                   { theme.text.withAlpha (0.9f), 0.75f * theme.lineWidth, LineStyle::solid });
}

void drawPlaces (juce::Graphics& g, const PlotFrame& frame, const std::vector<MapRectangle>& rectangles,
                 const std::vector<MapPoint>& points, const Theme& theme)
{
    auto small = theme;
    small.tickHeight *= sizeOfNames (frame, rectangles, theme);

    for (const auto& rectangle : rectangles)
        drawRectangle (g, frame, rectangle, points, small);
    for (const auto& point : points)
        drawPoint (g, frame, point, theme);
}

juce::Path pathOf (const MapShape& shape, const PlotFrame& frame)
{
    juce::Path path;
    path.setUsingNonZeroWinding (false);
    for (const auto& line : shape)
    {
        for (std::size_t i = 0; i < line.size(); ++i)
        {
            const auto place = frame.at (line[i].x(), line[i].y());
            i == 0 ? path.startNewSubPath (place) : path.lineTo (place);
        }
        path.closeSubPath();
    }
    return path;
}

void drawSurface (juce::Graphics& g, const PlotFrame& frame, const MapShape& shape, const Theme& theme)
{
    for (const auto& line : shape)
        drawCurve (g, closedCurve (line, frame), { theme.axis, theme.lineWidth, LineStyle::solid });
}

namespace
{
/** Where lines cross the edges of squares: two edges belong to each value, to its right and above it. */
class Crossings
{
public:
    Crossings (const Eigen::MatrixXd& valuesToUse, double levelToUse)
        : values (valuesToUse), level (levelToUse), links (static_cast<std::size_t> (2 * values.size()), { -1, -1 })
    {
        for (Eigen::Index column = 0; column + 1 < values.cols(); ++column)
        {
            checkWatch();
            for (Eigen::Index row = 0; row + 1 < values.rows(); ++row)
                linkSquare (row, column);
        }
    }

    /** Lines with ends at the matrix's border first, then closed ones. */
    std::vector<ContourLine> lines()
    {
        std::vector<ContourLine> result;
        for (const auto isClosed : { false, true })
            for (std::size_t edge = 0; edge < links.size(); ++edge)
                if (links[edge][0] >= 0 && (isClosed || links[edge][1] < 0))
                    result.push_back (lineFrom (static_cast<Eigen::Index> (edge)));
        return result;
    }

private:
    Eigen::Index edgeIndex (Eigen::Index row, Eigen::Index column, bool isUpwards) const
    {
        return 2 * (row + column * values.rows()) + (isUpwards ? 1 : 0);
    }

    void link (Eigen::Index one, Eigen::Index other)
    {
        for (const auto& [from, to] : { std::pair { one, other }, std::pair { other, one } })
        {
            auto& ends = links[static_cast<std::size_t> (from)];
            (ends[0] < 0 ? ends[0] : ends[1]) = to;
        }
    }

    void linkSquare (Eigen::Index row, Eigen::Index column)
    {
        const auto square = values.block<2, 2> (row, column);
        if (! square.allFinite())
            return;
        const auto isAbove = [&] (int i, int j) { return square (i, j) > level; };
        const std::array<Eigen::Index, 4> edges { edgeIndex (row, column, false), edgeIndex (row, column + 1, true),
                                                  edgeIndex (row + 1, column, false), edgeIndex (row, column, true) };
        const std::array<bool, 4> crossed { isAbove (0, 0) != isAbove (0, 1), isAbove (0, 1) != isAbove (1, 1),
                                            isAbove (1, 0) != isAbove (1, 1), isAbove (0, 0) != isAbove (1, 0) };
        std::vector<Eigen::Index> found;
        for (std::size_t k = 0; k < edges.size(); ++k)
            if (crossed[k])
                found.push_back (edges[k]);
        if (found.size() == 2)
            link (found[0], found[1]);
        if (found.size() < 4)
            return;
        // A saddle: the mean says which of the two opposite corners belong together.
        const auto joinsFirst = (square.mean() > level) == isAbove (0, 0);
        link (edges[0], edges[joinsFirst ? 1 : 3]);
        link (edges[2], edges[joinsFirst ? 3 : 1]);
    }

    Eigen::Vector2d pointOnEdge (Eigen::Index edge) const
    {
        const auto row = edge / 2 % values.rows(), column = edge / 2 / values.rows();
        const auto isUpwards = edge % 2 == 1;
        const auto first = values (row, column);
        const auto second = isUpwards ? values (row + 1, column) : values (row, column + 1);
        const auto share = (level - first) / (second - first);
        return { static_cast<double> (column) + (isUpwards ? 0 : share),
                 static_cast<double> (row) + (isUpwards ? share : 0) };
    }

    // Takes the links that it follows away, so that no line is found twice.
    ContourLine lineFrom (Eigen::Index edge)
    {
        ContourLine line { pointOnEdge (edge) };
        for (auto next = takeLink (edge); next >= 0; next = takeLink (edge))
        {
            auto& back = links[static_cast<std::size_t> (next)];
            (back[0] == edge ? back[0] : back[1]) = -1;
            edge = next;
            line.push_back (pointOnEdge (edge));
        }
        return line;
    }

    Eigen::Index takeLink (Eigen::Index edge)
    {
        auto& ends = links[static_cast<std::size_t> (edge)];
        auto& end = ends[0] >= 0 ? ends[0] : ends[1];
        const auto next = end;
        end = -1;
        return next;
    }

    const Eigen::MatrixXd& values;
    double level;
    std::vector<std::array<Eigen::Index, 2>> links; ///< Of each edge to those that its line continues to; -1 for none.
};
} // namespace

std::vector<ContourLine> contourLines (const Eigen::MatrixXd& values, double level)
{
    return Crossings (values, level).lines();
}
} // namespace antinode
