#pragma once

#include <juce_audio_processors/juce_audio_processors.h>

#include <functional>

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
} // namespace antinode
