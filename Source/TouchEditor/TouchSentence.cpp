#include "TouchSentence.h"

#include "LatencyVolts.h"

#include <Editor/JuceText.h>

#include <antinode_session/DesignSentences.h>

namespace antinode
{
juce::String touchSentence (TouchProcessor& processor, const TouchSnapshot& snapshot)
{
    const auto& parameters = processor.parameters();

    if (auto warning = processor.warning(); warning.isNotEmpty())
        return warning;

    if (snapshot.isSolving)
        return "Solving the device.";

    if (snapshot.isDesigning)
        return "Designing the filters: " + juce::String (juce::roundToInt (100 * snapshot.progress)) + " %.";

    const auto foci = processor.session().focusProgress();
    const auto underFingers = processor.session().fociUnderFingers();

    if (! foci.isDone())
        return juce::String ("Designing the foci of notes")
               + (underFingers == FociUnderFingers::designing ? " for the fingers that rest: " : ": ")
               + juce::String (foci.designed) + " of " + juce::String (foci.wanted) + ".";

    if (! parameters.arm().get())
        return "Disarmed: all voltages are 0 V.";

    const auto volts = noiseVolts (snapshot, parameters.controls(), parameters.settings().latency);

    if (snapshot.model != nullptr && volts && *volts > voltageLimits (*snapshot.model).minCoeff())
        return "Loud: noise at these levels needs " + juce::String (juce::roundToInt (*volts)) + " V of "
               + juce::String (juce::roundToInt (voltageLimits (*snapshot.model).minCoeff()))
               + " V; what is beyond is cut, and then also felt elsewhere.";

    if (const auto unplayable = unplayableNotes (foci, processor.getSampleRate()); ! unplayable.empty())
        return fromUtf8 (unplayable);

    return underFingers == FociUnderFingers::known ? "The foci of notes know the fingers that rest."
           : underFingers == FociUnderFingers::outdated
               ? "Fingers have moved: the foci of notes are those from before, "
                 "until the fingers rest."
               : juce::String();
}
} // namespace antinode
