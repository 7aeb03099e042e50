#pragma once

#include <Processor/AntinodeProcessor.h>
#include <juce_audio_processors/juce_audio_processors.h>

#include <functional>
#include <memory>
#include <vector>

namespace antinode
{
/** A parameter and what shows and sets it. It looks at the parameter when it is told to, rather than listening: hosts
   automate on the audio thread, where JUCE's own attachments, which listen, post messages. [message thread] */
class ParameterLink
{
public:
    /** @param show  gets the parameter's value; called by refresh() alone */
    ParameterLink (juce::RangedAudioParameter&, std::function<void (float value)> show);

    /** Shows the value where it is another than it was. */
    void refresh();

    /** Changes by the user. */
    void beginGesture() { parameter.beginChangeGesture(); }
    void set (float value);
    void endGesture() { parameter.endChangeGesture(); }
    void setAsGesture (float value);

private:
    juce::RangedAudioParameter& parameter;
    std::function<void (float)> showValue;
    float shown = -1; ///< 0 to 1 once something is shown.
};

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

    /** The text of the value that is there, until it is another; empty: the parameter's own. */
    void showInstead (const juce::String& text);

    /** Whether it is a place along y, which a line has not. */
    bool isAlongY() const;

    void resized() override;

private:
    void makeBar();
    void makeList (int words);
    void makeSwitch();
    void show (float value);
    void showWord (juce::ComboBox&, int step);

    juce::RangedAudioParameter& parameter;
    ParameterLink link;
    juce::Label name;
    std::unique_ptr<juce::Component> input;
    juce::String instead; ///< Of the parameter's text,
    float insteadAt = 0;  ///< at this share of its range.
};

/** All parameters in their groups, one below the other. [message thread] */
class ParameterPanel final : public juce::Component
{
public:
    explicit ParameterPanel (AntinodeProcessor&);

    /** Shows what has changed. */
    void refresh();

    /** Shows all texts again: the device is another one. @param isLine  then nothing is along y */
    void refreshTexts (bool isLine);

    /** The text of a parameter's value that is there, as ParameterControl has it. */
    void showInstead (const juce::String& identifier, const juce::String& text);

    /** Lays the controls out for a width, and fills a place at least so high. @return  the height that the controls
        need */
    int layOut (int width, int minimumHeight);

    const std::vector<std::unique_ptr<ParameterControl>>& controls() const { return all; }

    void paint (juce::Graphics&) override;

private:
    struct Group
    {
        juce::String name;
        std::size_t first = 0, count = 0; ///< Of the controls.
        juce::Rectangle<int> heading;
    };

    std::vector<Group> groups;
    std::vector<std::unique_ptr<ParameterControl>> all;
};
} // namespace antinode
