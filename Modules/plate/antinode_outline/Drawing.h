#pragma once

#include "Outline.h"
#include "PathBuilder.h"

#include <Eigen/Geometry>

#include <filesystem>
#include <string>
#include <string_view>

namespace antinode
{
/** What of a drawing is the outline, and what the drawing may not say. */
struct DrawingChoice
{
    std::string layer;       ///< A layer, group or element by its name or id; empty: all that is visible.
    double unit = 0;         ///< m of one unit of the drawing; 0: what the drawing says.
    double joint = 1e-5;     ///< m: how far ends may lie apart that belong together.
    double deviation = 1e-6; ///< m: how far arcs may lie from the free curve for which they stand.
};

/** The outline that an SVG or DXF drawing shows, in m, y upwards: its closed paths, loose lines and arcs being joined;
   the largest is the outer one, the others are holes. The origin is that of a DXF drawing, and the lower left corner of
   an SVG's page. Each line, arc or curve that is drawn is an edge of its own; they count from the outer path on.
    @param source  how errors name it
    @throws InputError  source, what is wrong, where, what is allowed
    [worker] Docs/FileFormats.md, Docs/Design/outlines.md */
Outline outlineFromDrawing (std::string_view bytes, const std::string& source, const DrawingChoice&);

/** The same, of a file. @throws InputError  as well where it cannot be read [worker] */
Outline readOutlineFile (const std::filesystem::path&, const DrawingChoice&);

/** What is drawn in one go: lines and arcs, each beginning where the one before ends. Arcs may turn back. Lengths in m.
 */
struct Stroke
{
    std::string name; ///< For messages, for example "plate.svg: path 'rim'".
    std::vector<PathPiece> pieces;
};

/** The largest number of pieces that a drawing may have before they are joined. */
inline constexpr std::size_t maximumStrokePieces = 200000;

/** Whether a place of a drawing lies where one can be, at most 1000 m from the origin; not where it is no number. [any]
 */
bool isWithinReach (const Eigen::Vector2d&);

/** The strokes of a drawing while it is read. */
struct DrawnStrokes
{
    std::string source; ///< The drawing's name, for messages.
    std::vector<Stroke> list;
    std::size_t pieces = 0; ///< Of all strokes.

    /** Takes up a stroke, unless it has no pieces.
        @throws InputError  where there are more than maximumStrokePieces, or one of them is not within reach
        [worker] */
    void add (Stroke);
};

/** Lines and arcs under an affine map. [any] */
void transform (std::vector<PathPiece>&, const Eigen::Affine2d&);

/** Closed paths from strokes: closed ones as they are, open ones joined at ends that lie within a tolerance. Pieces
   shorter than a tenth of it are left out.
    @throws InputError  which stroke is open or where more than two meet
    [worker] */
std::vector<ClosedPath> joinedStrokes (std::vector<Stroke>, double tolerance);
} // namespace antinode
