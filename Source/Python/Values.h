#pragma once

#include <antinode_documents/ExcitationFile.h>
#include <antinode_focus/FocusDescription.h>
#include <antinode_focus/WideDesign.h>
#include <antinode_model/ModalModel.h>
#include <antinode_model/Playback.h>
#include <antinode_render/FocusOutcome.h>
#include <antinode_structure/DeviceDescription.h>
#include <antinode_tracks/Waveforms.h>

#include <memory>
#include <string>

namespace antinode
{
/** A device as Python holds it: its document, and what it says. */
struct DeviceValue
{
    std::string document; ///< JSON
    DeviceDescription description;
};

/** A focus as Python holds it. */
struct FocusValue
{
    std::string document; ///< JSON
    FocusDescription description;
    std::string device; ///< The name or file of the one that it is for; empty: it names none.
};

/** Waveforms as Python holds them. */
struct WaveformsValue
{
    std::string document; ///< JSON
    WaveformsDescription description;
    std::string device; ///< As of a focus.
};

/** An excitation: what is played to measure a device. */
using Excited = std::shared_ptr<ExcitationSheet>;

/** Modes: what NumPy's arrays lie on. */
struct ModesValue
{
    ModalModel model;
};

/** A design, with what it takes to play it. */
struct DesignValue
{
    WideDesign made;
    Playback playback;
    double repetitions = 0; ///< Per second.
    std::string thresholdFile;
};

/** What of `antinode design` and `antinode render` is the same. */
struct DesignSettings
{
    double sampleRate = 0; ///< Hz
    std::string reconstruction;
    double repetitions = 0; ///< Per second.
    std::string thresholdFile;
    bool usesCache = true;
};

/** How voltages are played. @throws InputError  for a rate or reconstruction that is not allowed [any] */
Playback playbackOf (const DesignSettings&);

/** A focus with the threshold of skin that the settings give, where it asks for one.
    @throws InputError  where it cannot be read [worker] */
FocusDescription focusWith (const FocusValue&, const DesignSettings&);

/** design.json of a design, byte by byte. [worker] */
std::string designText (const DesignValue&);

/** A render with its outcome. */
struct RenderValue
{
    RenderedFocus focus;
    FocusOutcome outcome;
};
} // namespace antinode
