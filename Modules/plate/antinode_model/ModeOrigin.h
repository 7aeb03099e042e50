#pragma once

namespace antinode
{
/** Where the modes of a device come from. */
enum class ModeSource
{
    given,   ///< A file has them and says no more.
    drawn,   ///< Computed from a drawing.
    retuned, ///< Drawn; frequencies, damping and participations by measurement.
    measured ///< Shapes too.
};

/** How modes came about, by which a design knows how far a device may be from them. Docs/Theory.md, section 7.4. */
struct ModeOrigin
{
    ModeSource source = ModeSource::given;
    int points = 0;           ///< Where they were measured.
    double unexplained = 0;   ///< What they leave of what was measured there, RMS over RMS.
    bool scaleIsKnown = true; ///< False: shapes have a size by convention; forces on the surface mean nothing to them.

    bool operator== (const ModeOrigin&) const = default;
};
} // namespace antinode
