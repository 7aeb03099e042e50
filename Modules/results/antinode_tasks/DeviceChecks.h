#pragma once

#include "Field.h"

#include <antinode_documents/Library.h>
#include <antinode_model/Surface.h>
#include <antinode_structure/DeviceDescription.h>

#include <filesystem>
#include <optional>
#include <vector>

namespace antinode
{
/** Refuses a focus that was made for a plate on a line, whose places have no y.
    @throws InputError  naming the target, probe or finger [any] */
void checkKindOfPlaces (const ModalModel&, const FocusDescription&);

/** Refuses places beside a line. @param what  "point" @throws InputError  naming the place [any] */
void checkKindOfPlaces (const ModalModel&, const Eigen::MatrixX2d& places, const std::string& what);

/** Refuses ceramics that a device does not have. @param idle  counted from 1 @throws InputError [any] */
void checkIdleCeramics (const std::vector<int>& idle, const ModalModel&);

/** A focus designed for a device and the plate that it is played on, which is widened where the design asks for it.
    @throws InputError, LimitError  as designWide, and as checkKindOfPlaces [worker] */
WideDesign designOn (const Setup&, const FocusDescription&);

/** The sample rate of a task, 8 kHz to 2 MHz. [any] */
Field sampleRateField (double& rate);

/** The focus of a task: the first field of its request. [any] */
Field focusField (FocusDescription&);

/** The device of a task with a focus, which may name it. [any] */
Field deviceOfFocusField (DeviceDescription&);

/** Where the surface of a modal device ends. [any] */
Field outlineField (std::filesystem::path& outline);

/** Whether it is a drawing (.svg, .dxf), not a device. [any] */
bool isDrawingFile (const std::filesystem::path& outline);

/** The boundary that is named: that of a plate, or a drawing, of which no edge is held; none where it is empty.
    @throws InputError  where it cannot be read or has none [worker] */
std::optional<SurfaceBoundary> boundaryFrom (const std::filesystem::path& outline);
} // namespace antinode
