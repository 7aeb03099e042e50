#pragma once

#include <antinode_focus/FocusDescription.h>
#include <antinode_model/ModalModel.h>
#include <antinode_structure/DeviceDescription.h>
#include <antinode_tracks/Waveforms.h>

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

/** Modes: what NumPy's arrays lie on. */
struct ModesValue
{
    ModalModel model;
};
} // namespace antinode
