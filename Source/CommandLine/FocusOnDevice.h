#pragma once

#include <antinode_focus/WideDesign.h>
#include <antinode_render/RenderedFocus.h>
#include <antinode_structure/DeviceDescription.h>

#include <nlohmann/json_fwd.hpp>

namespace antinode
{
/** Refuses a sample rate that no voltages are played at. @throws InputError  outside 8 kHz to 2 MHz [any] */
void checkSampleRate (double rate);

/** Refuses a focus that was made for a plate on a line, whose places have no y.
    @throws InputError  naming the target, probe or finger [any] */
void checkKindOfPlaces (const ModalModel&, const FocusDescription&);

/** Refuses places beside a line. @param what  "point" @throws InputError  naming the place [any] */
void checkKindOfPlaces (const ModalModel&, const Eigen::MatrixX2d& places, const std::string& what);

/** A device with modes to widePlay times its own. @param known  as solveDevice gave it
    @throws InputError  for anything that cannot be solved. [worker] */
WideModel wideOf (const DeviceDescription&, const ModalModel& known, Playback, bool usesCache);

/** A focus designed for a device and the plate that it is played on, which is widened where the design asks for it.
    @param wide   as wideOf gave it
    @throws InputError, LimitError  as designWide [worker] */
WideDesign designOn (const DeviceDescription&, const WideModel& wide, const FocusDescription&, Playback,
                     bool usesCache);

/** The electrical power of a design, by a render; where there can be none, the reason is why the power is unknown.
    @param repetitions  per second [worker] */
FocusPower designedPower (const WideDesign&, Playback, double repetitions);

/** The modes that a design on a wide model knows: under fingers that it knows those of the loaded surface. [any] */
ModalModel designedModel (const WideModel&);

/** design.json. [worker] Docs/FileFormats.md. */
nlohmann::ordered_json designDocument (const WideDesign&, const FocusPower&);
} // namespace antinode
