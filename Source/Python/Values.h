#pragma once

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
};

/** Waveforms as Python holds them. */
struct WaveformsValue
{
    std::string document; ///< JSON
    WaveformsDescription description;
};

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

/** A render with its outcome. */
struct RenderValue
{
    RenderedFocus focus;
    FocusOutcome outcome;
};
} // namespace antinode
