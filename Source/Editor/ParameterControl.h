#pragma once

#include "ParameterLink.h"

#include <memory>

namespace antinode
{
/** A parameter's name and what sets it: a bar to be dragged or typed into, a list of words, or a switch. [message
    thread] */
class ParameterControl : public juce::Component
{
public:
    explicit ParameterControl (juce::RangedAudioParameter&);
    ~ParameterControl() override;

    /** The component with the keyboard focus. */
    juce::Component& control() { return *input; }

    /** Shows the parameter's value where it has changed. */
    void refresh() { link.refresh(); }

    /** Shows the value's text again: texts of places are in mm of the device. */
    void refreshText();

    /** Whether it is a place along y, which a line has not. */
    bool isAlongY() const;

    void resized() override;

private:
    void makeBar();
    void makeList (int words);
    void makeSwitch();
    void show (float value);

    juce::RangedAudioParameter& parameter;
    ParameterLink link;
    juce::Label name;
    std::unique_ptr<juce::Component> input;
};
} // namespace antinode
