#pragma once

#include "History.h"

#include <antinode_drafts/CeramicEdits.h>
#include <antinode_drafts/CeramicFaults.h>

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace antinode
{
/** The loaded device while it is drawn. Every edit that is right loads the device that it makes, with the focus as it
   is, as one entry of the history; one that is not is said, and nothing changes. So a host keeps what is drawn at any
   time. [message thread] */
class DeviceDraft
{
public:
    DeviceDraft (AntinodeProcessor&, History&);

    /** Gets why an edit is not taken, or what an action did. */
    std::function<void (const juce::String&)> say;

    /** Takes the loaded device where it is another one than before; what is dragged is then over. */
    void refresh();

    /** What is shown: the loaded device, or what becomes of it while something is dragged. */
    const nlohmann::json& document() const { return shown; }

    /** The same, read; of the last right one while something wrong is dragged. */
    const std::shared_ptr<const DeviceDocument>& device() const { return read; }

    /** Whether it can be drawn: not where its modes are given. */
    bool isDrawn() const;

    /** Whether what is shown is not loaded yet. */
    bool isEdited() const { return before != nullptr; }

    const std::vector<CeramicFault>& faults() const { return found; }

    /** Another number whenever something else is shown. */
    int changes() const { return changeCount; }

    /** What is shown from here to drop(). @param edited  a document like the loaded one */
    void drag (nlohmann::json edited);

    /** Loads what was dragged; where it is wrong, what was there before is shown again. */
    void drop();

    /** Drops it without loading anything. */
    void cancel();

    /** An edit in one step. */
    void apply (const nlohmann::json& edited);

    /** Loads a device that is none of the loaded one, with a focus that suits it. */
    void begin (const nlohmann::json& device);

    /** Takes these ceramics away; mutes stay those of the others. */
    void removeCeramics (const CeramicChoice&);

    /** A plate gets the outline of an SVG or DXF drawing; ceramics, feet and masses outside of it go. */
    void takeOutline (const std::string& file);

    // What is selected on the surface, and edited in the panel.

    CeramicChoice ceramics;
    std::optional<std::size_t> point;
    std::string edge; ///< Empty: all.

    /** The selected ceramics, or all where none is. */
    CeramicChoice chosenOrAll() const;

private:
    juce::String take (const nlohmann::json& edited);
    juce::String tryTo (const std::function<void()>&);
    void show (nlohmann::json edited);
    void load (std::shared_ptr<const DeviceDocument>, std::uint64_t mutes);

    AntinodeProcessor& processor;
    History& history;
    std::shared_ptr<const DeviceDocument> loaded, read;
    std::shared_ptr<const nlohmann::json> before; ///< What is loaded, while something is dragged.
    nlohmann::json shown;
    std::vector<CeramicFault> found;
    int changeCount = 0;
};
} // namespace antinode
