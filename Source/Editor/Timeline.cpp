#include "Timeline.h"

#include "EditorLook.h"
#include "FieldFrames.h"

#include <cmath>

namespace antinode
{
namespace
{
constexpr double framesPerSecond = 24;
constexpr int valueWidth = 124;

juce::String timeText (double frame)
{
    const auto milliseconds = 1000 * FieldFrames::frameTime (juce::roundToInt (frame));
    return (milliseconds < 0 ? juce::String::fromUTF8 ("focus \xE2\x88\x92 ") : juce::String ("focus + "))
           + juce::String (std::abs (milliseconds), 2) + " ms";
}
} // namespace

Timeline::Timeline()
{
    setTitle ("Time");
    play.setButtonText ("Play");
    play.setTitle ("Play around the focus");
    play.setClickingTogglesState (true);
    play.setTooltip ("Plays the field in slow motion from 3 ms before to 3 ms after the focus. Key: P");
    play.onStateChange = [this] { play.setButtonText (isPlaying() ? "Pause" : "Play"); };
    play.onClick = [this] { position = place.getValue(); };
    focus.setButtonText ("Focus");
    focus.setTitle ("Show the focus");
    focus.setTooltip ("Shows the instant of the focus. Key: F");
    focus.onClick = [this]
    {
        setPlaying (false);
        place.setValue (FieldFrames::atFocus);
    };
    place.setSliderStyle (juce::Slider::LinearHorizontal);
    place.setTextBoxStyle (juce::Slider::TextBoxRight, true, valueWidth, 20);
    place.setRange (0, FieldFrames::count - 1, 1);
    place.textFromValueFunction = timeText;
    place.setValue (FieldFrames::atFocus, juce::dontSendNotification);
    place.updateText();
    place.setDoubleClickReturnValue (true, FieldFrames::atFocus);
    place.setTitle ("Time from the focus");
    place.setTooltip ("Displayed instant relative to the focus, ms.");
    place.setWantsKeyboardFocus (true);
    addAndMakeVisible (play);
    addAndMakeVisible (focus);
    addAndMakeVisible (place);
}

int Timeline::frame() const
{
    return juce::roundToInt (place.getValue());
}

void Timeline::advance (double seconds)
{
    if (! isPlaying())
        return;

    position = std::fmod (position + seconds * framesPerSecond, FieldFrames::count - 1);
    place.setValue (std::floor (position), juce::dontSendNotification);
}

void Timeline::paint (juce::Graphics& g)
{
    g.fillAll (EditorLook::findPalette (*this).panel);
}

void Timeline::resized()
{
    auto area = getLocalBounds().reduced (8, 6);
    play.setBounds (area.removeFromLeft (60));
    area.removeFromLeft (6);
    focus.setBounds (area.removeFromLeft (60));
    area.removeFromLeft (8);
    place.setBounds (area);
}
} // namespace antinode
