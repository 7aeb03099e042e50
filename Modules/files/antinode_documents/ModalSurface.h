#pragma once

#include <Eigen/Core>
#include <antinode_model/Surface.h>
#include <antinode_text/JsonReader.h>

#include <optional>
#include <vector>

namespace antinode
{
/** A surface of given points, in the order that the model wants. */
struct GivenSurface
{
    Surface surface;
    std::vector<Eigen::Index> order; ///< The index in the file of each point of the surface.
};

/** The surface of a modal device: "points_mm", "weights_kg", "areas_m2".
    Points with one common y are a line, with y = 0 and ascending in x. Where areas are not given, those of a line are
   half the distance to the neighbours and those of a plate go with the weights.
    @param exact  SI numbers to the last bit, or none
    @throws InputError [worker] */
GivenSurface readSurface (const JsonObject& device, const std::optional<JsonObject>& exact);

/** A number to the last bit that stands in for one that was read in the unit of its key.
    @throws InputError  when the two disagree by more than rounding [worker] */
double refined (double value, const JsonValue& exact);

// The boundary of a modal device: "outline", as of a plate, and "held_edges", those of its edges that cannot move.
// Docs/FileFormats.md.

/** Puts the boundary of a file on a surface of given points, which then extends to it; without one nothing.
    @throws InputError  as readOutline, and where a point lies outside it [worker] */
void readBoundary (const JsonObject& device, Surface&);

/** Writes what readBoundary() understands. A hole of which a part is held counts as held. [worker] */
void boundaryToJson (nlohmann::ordered_json& device, const SurfaceBoundary&);

/** Numbers as base64 of little-endian 4-byte floating point: a quarter of what they take as text, to 7 digits. [any] */
std::string compactNumbers (const Eigen::VectorXd&);

/** The same back. @throws InputError  where it is not that, has another count, or a number is not finite [worker] */
Eigen::VectorXd readCompactNumbers (const JsonValue&, Eigen::Index count);
} // namespace antinode
