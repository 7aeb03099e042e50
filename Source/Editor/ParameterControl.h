#pragma once

#include <juce_audio_processors/juce_audio_processors.h>

#include <memory>

namespace antinode
{
/** A parameter's name and what sets it: a bar to be dragged or typed into, a list of words, or a switch. [message thread] */
class ParameterControl : public juce::Component
{
public:
    explicit ParameterControl (juce::RangedAudioParameter&);
    ~ParameterControl() override;

    /** What takes the keyboard. */
    juce::Component& control() { return *input; }

    /** Shows the value's text anew: texts of places are in mm of the device. */
    void refreshText();

    void resized() override;

private:
    void makeBar();
    void makeList (int words);
    void makeSwitch();

    juce::RangedAudioParameter& parameter;
    juce::Label name;
    std::unique_ptr<juce::Component> input;
    std::unique_ptr<juce::SliderParameterAttachment> barAttachment; ///< Goes before what it is attached to.
    std::unique_ptr<juce::ComboBoxParameterAttachment> listAttachment;
    std::unique_ptr<juce::ButtonParameterAttachment> switchAttachment;
};
} // namespace antinode
