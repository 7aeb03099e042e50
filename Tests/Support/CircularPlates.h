#pragma once

#include <vector>

namespace antinode::tests
{
/** What a ring of a circular plate is made of, from the edge of the one inside it to its own. */
struct PlateRing
{
    double outerRadius = 0; ///< m
    double stiffness = 1;   ///< D, N m
    double poissonRatio = 0.3;
    double massPerArea = 1; ///< kg/m^2
};

/** An edge with springs; stiff ones hold it. */
struct CircularEdge
{
    double translation = 0; ///< N/m^2
    double rotation = 0;    ///< N
};

inline constexpr double rigid = 1e30; ///< A spring that holds.

/** A circular plate of rings about a hole, or about its centre where that has no radius. */
struct CircularPlate
{
    double hole = 0; ///< Radius, m.
    std::vector<PlateRing> rings;
    CircularEdge inner, outer;
};

/** A mode with n nodal diameters, for n > 0 one of two. */
struct CircularMode
{
    double angularFrequency = 0; ///< rad/s
    int diameters = 0;
};

/** The lowest flexible modes, ascending, those with nodal diameters twice: the roots of the determinant of Bessel's
   functions of all rings, found by bisection. Leissa, Vibration of Plates, NASA SP-160 (1969), chapter 2. */
std::vector<CircularMode> circularModes (const CircularPlate&, int count);

/** dw/dr at the edge of the first ring of a mode without nodal diameters, mass-normalised; its sign is arbitrary. */
double slopeAtFirstRing (const CircularPlate&, double angularFrequency);
} // namespace antinode::tests
