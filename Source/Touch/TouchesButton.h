#pragma once

#include "TouchProcessor.h"

#include <juce_gui_basics/juce_gui_basics.h>

namespace antinode
{
/** Says which ports are open for touches by OSC and TUIO and how many fingers they are, and opens others.
    [message thread] */
class TouchesButton final : public juce::TextButton
{
public:
    explicit TouchesButton (TouchProcessor&);

    /** Shows what has changed. */
    void refresh();

    /** Why the ports that were chosen last cannot be opened, or empty. */
    juce::String error() const { return failure; }

    /** Opens ports, as the menu does. */
    void open (const TouchPorts&);

private:
    void showMenu();

    TouchProcessor& processor;
    juce::String failure;
};
} // namespace antinode
