#pragma once

#include "DeviceChecks.h"

#include <antinode_base/Progress.h>
#include <antinode_fingers/Finger.h>
#include <antinode_focus/FocusDescription.h>
#include <antinode_render/PowerFlow.h>
#include <antinode_structure/DeviceDescription.h>

#include <memory>
#include <string>
#include <vector>

namespace antinode
{
inline constexpr TaskText designTask { "design", "Computes the voltages of a focus",
                                       "Docs/Theory.md, sections 2 to 4" };

/** A focus on a device, and how its voltages are played. */
struct FocusRequest
{
    FocusDescription focus;
    DeviceDescription device;
    double sampleRate = 192000;                  ///< Hz
    std::string reconstruction = "band_limited"; ///< Or "zero_order_hold".
    std::vector<Finger> fingers;                 ///< Beside those of the focus.
    double repetitions = 10;                     ///< Per second, for the electrical power.
    std::filesystem::path thresholdFile;         ///< What skin feels; empty: the built-in table.
    bool usesCache = true;
};

/** [any] */
std::vector<Field> fields (FocusRequest&);

/** [any] */
Playback playbackOf (const FocusRequest&);

/** The focus with all fingers, and with the threshold of skin of the request where it asks for one.
    @throws InputError  where that cannot be read [worker] */
FocusDescription focusOf (const FocusRequest&);

/** A design, with what it takes to play it. */
struct DesignedFocus
{
    WideDesign made;
    Playback playback;
    double repetitions = 10; ///< Per second.
    std::filesystem::path thresholdFile;
};

/** @throws InputError, LimitError  as setUp and designOn [worker] */
DesignedFocus design (const FocusRequest&, const ShowProgress&);

/** What of the playback a request leaves open. */
struct LeftOpen
{
    bool sampleRate = false, reconstruction = false;
};

/** A design that was written before, on the device of the request, or, where that is left open, on the one that it
   names.
    @param assignments  values of keys of the device
    @throws InputError  for a file that cannot be read, for a playback that it cannot be played by, and for overridden
                        keys of a focus, which is designed already
    [worker] */
DesignedFocus writtenDesign (FocusRequest, const LeftOpen&, const std::filesystem::path& file,
                             const std::string& device, const std::vector<std::string>& assignments);

/** The modes that a design on a wide model knows: under fingers that it knows those of the loaded surface. [any] */
ModalModel designedModel (const WideModel&);

/** The device's own modes. [any] */
ModalModel ownModel (const DesignedFocus&);

/** The electrical power of a design, by a render; where there can be none, the reason is why the power is unknown.
    [worker] */
FocusPower designedPower (const DesignedFocus&);

/** design.json. [worker] Docs/FileFormats.md. */
std::string designFileText (const DesignedFocus&, const FocusPower&);
} // namespace antinode
