#include "Screenshots.h"

#include <Standalone/MainComponent.h>
#include <Touch/TouchContent.h>

#include <antinode_documents/Library.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>

namespace antinode
{
namespace
{
constexpr double touchRate = 48000;
constexpr int touchBlock = 480, touchBlocks = 60;

/** A tone that swells, a burst, and a low tone. */
float trackSample (int finger, int n)
{
    const auto time = n / touchRate;
    const auto tone = [&] (double frequency) { return std::sin (2 * std::numbers::pi * frequency * time); };
    const double values[] = { 0.9 * tone (200) * (0.6 + 0.4 * tone (4)),
                              0.7 * tone (330) * std::exp (-8 * std::fmod (time, 0.3)), 0.5 * tone (80) };
    return static_cast<float> (values[finger]);
}

void playTracks (TouchProcessor& processor, TouchContent& content)
{
    juce::MidiBuffer midi;

    for (int b = 0; b < touchBlocks; ++b)
    {
        juce::AudioBuffer<float> buffer (processor.getTotalNumOutputChannels(), touchBlock);
        buffer.clear();

        for (int k = 0; k < 3; ++k)
            for (int n = 0; n < touchBlock; ++n)
                buffer.setSample (k, n, trackSample (k, b * touchBlock + n));

        processor.processBlock (buffer, midi);
        content.refresh (touchBlock / touchRate);
    }
}

/** Four fingers on the glass plate, three of which play, and a focus for notes. */
void putDown (TouchProcessor& processor)
{
    processor.load (deviceDocument ("glass-148x210"));
    processor.parameters().setValues ({ { "finger1_x", 22 },
                                        { "finger1_y", 35 },
                                        { "finger1_state", 2 },
                                        { "finger1_load", 2 },
                                        { "finger2_x", 55 },
                                        { "finger2_y", 70 },
                                        { "finger2_state", 2 },
                                        { "finger2_load", 2 },
                                        { "finger3_x", 80 },
                                        { "finger3_y", 30 },
                                        { "finger3_state", 2 },
                                        { "finger3_load", 3 },
                                        { "finger4_x", 40 },
                                        { "finger4_y", 22 },
                                        { "finger4_state", 1 },
                                        { "finger4_load", 1 } });
    processor.loadFocus (focusDocument ("glass-centre"));
    processor.prepareToPlay (touchRate, touchBlock);
}

/** Plays until there is something to see. */
void playUntilSeen (TouchProcessor& processor, TouchContent& content)
{
    refreshUntil (content, [&] { return content.hasPicture() && content.volts().contains ("5 ms: "); });
    playTracks (processor, content);
}
} // namespace

void takeTouch (const juce::File& file)
{
    TouchProcessor processor (32, juce::AudioProcessor::wrapperType_Undefined);
    processor.setNonRealtime (true);
    putDown (processor);
    TouchEditor editor (processor);
    playUntilSeen (processor, editor.content());
    writePicture (editor, file);
}

void takeTouchStandalone (const juce::File& file)
{
    TouchHost host (SettingsFile ({}), false);
    host.processor().setNonRealtime (true);
    putDown (host.processor());
    MainComponent window (host);
    window.setSize (1500, 720);
    host.arm().setValueNotifyingHost (1);
    window.showSettings ("Inputs");
    playUntilSeen (host.processor(), window.touchEditor()->content());
    window.update();
    writePicture (window, file);
}
} // namespace antinode
