#pragma once

#include "PathBuilder.h"

#include <Eigen/Geometry>

#include <string>

namespace antinode
{
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
