#pragma once

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
} // namespace antinode
