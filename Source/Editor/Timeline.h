#pragma once

#include <juce_gui_basics/juce_gui_basics.h>

namespace antinode
{
/** The displayed instant around the focus: a slider over the frames, and a button that plays them in slow motion.
    [message thread] */
class Timeline final : public juce::Component
{
public:
    Timeline();

    /** Of FieldFrames. */
    int frame() const;

    bool isPlaying() const { return play.getToggleState(); }
    void setPlaying (bool shouldPlay) { play.setToggleState (shouldPlay, juce::sendNotificationSync); }

    void showFocus() { focus.triggerClick(); }

    /** Advances while playing. @param seconds  since the last call */
    void advance (double seconds);

    void paint (juce::Graphics&) override;
    void resized() override;

private:
    juce::TextButton play, focus;
    juce::Slider place;
    double position = 0; ///< In frames, while it plays.
};
} // namespace antinode
