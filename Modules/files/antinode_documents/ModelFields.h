#pragma once

#include "FieldStream.h"

#include <antinode_model/ModalModel.h>
#include <antinode_outline/OutlineFields.h>

namespace antinode
{
/** All fields of a modal model, in the order of their declaration, to be written or read. A field that is missing here
   does not compile. @throws InputError  as FieldReader [worker] */
void fields (auto& stream, Struct<InputLag> auto& lag)
{
    auto& [delay, timeConstant, angle] = lag;
    stream (delay, timeConstant, angle);
}

void fields (auto& stream, Struct<Ceramic> auto& ceramic)
{
    auto& [name, xMinimum, xMaximum, yMinimum, yMaximum, voltageLimit, slewLimit, capacitance, lossFactor, area,
           currentLimit, amplifierVoltage, lag, outline] = ceramic;
    stream (name, xMinimum, xMaximum, yMinimum, yMaximum, voltageLimit, slewLimit, capacitance, lossFactor, area,
            currentLimit, amplifierVoltage, lag, outline);
}

void fields (auto& stream, Struct<GridAxis> auto& axis)
{
    auto& [places, weights, edges, first] = axis;
    stream (places, weights, edges, first);
}

void fields (auto& stream, Struct<PlateGrid> auto& grid)
{
    auto& [x, y] = grid;
    stream (x, y);
}

void fields (auto& stream, Struct<HeldEdges> auto& held)
{
    auto& [left, right, bottom, top] = held;
    stream (left, right, bottom, top);
}

void fields (auto& stream, Struct<SurfaceBoundary> auto& boundary)
{
    auto& [outline, held] = boundary;
    stream (outline, held);
}

void fields (auto& stream, Struct<Surface> auto& surface)
{
    auto& [kind, xMinimum, xMaximum, yMinimum, yMaximum, points, masses, areas, grid, held, boundary] = surface;
    auto isPlate = kind == SurfaceKind::plate;
    stream (isPlate, xMinimum, xMaximum, yMinimum, yMaximum, points, masses, areas, grid, held, boundary);

    if constexpr (! std::is_const_v<std::remove_reference_t<decltype (surface)>>)
        kind = isPlate ? SurfaceKind::plate : SurfaceKind::line;
}

void fields (auto& stream, Struct<ModalModel> auto& model)
{
    auto& [name, surface, angularFrequencies, dampingRatios, shapes, slopes, participation, staticShare, ceramics,
           fullScaleVoltage, coversWholeBody, rigidBodyModes, unknowns, frequencyErrors, warnings, origin] = model;
    stream (name, surface, angularFrequencies, dampingRatios, shapes, slopes, participation, ceramics, fullScaleVoltage,
            coversWholeBody, rigidBodyModes, unknowns, frequencyErrors, warnings);

    // Only what is drawn is solved, and cached.
    if constexpr (! std::is_const_v<std::remove_reference_t<decltype (model)>>)
    {
        staticShare.resize (0, 0);
        origin = { ModeSource::drawn };
    }
}
} // namespace antinode
