#include "TouchSentences.h"

#include <antinode_session/DesignSentences.h>

#include <Eigen/Core>

#include <cmath>
#include <string>

namespace antinode
{
namespace
{
std::string wholeNumber (double value)
{
    return std::to_string (std::lround (value));
}

/** What goes on. */
std::string progressSentence (TouchProcessor& processor, const TouchSnapshot& snapshot)
{
    const auto foci = processor.session().focusProgress();

    if (snapshot.isSolving)
        return "Solving the device.";

    if (snapshot.isDesigning)
        return "Designing the filters: " + wholeNumber (100 * snapshot.progress) + " %.";

    if (! foci.isDone())
        return std::string ("Designing the foci of notes")
               + (processor.session().fociUnderFingers() == FociUnderFingers::designing ? " for the fingers that rest: "
                                                                                        : ": ")
               + std::to_string (foci.designed) + " of " + std::to_string (foci.wanted) + ".";

    return {};
}

/** What the fingers' levels need more than there is. */
std::string loudSentence (TouchProcessor& processor, const TouchSnapshot& snapshot)
{
    const auto& parameters = processor.parameters();
    const auto volts = noiseVolts (snapshot, parameters.controls(), parameters.settings().latency);

    if (snapshot.model == nullptr || ! volts || *volts <= voltageLimits (*snapshot.model).minCoeff())
        return {};

    return "Loud: noise at these levels needs " + wholeNumber (*volts) + " V of "
           + wholeNumber (voltageLimits (*snapshot.model).minCoeff())
           + " V; what is beyond is cut, and then also felt elsewhere.";
}

std::string fociSentence (FociUnderFingers foci)
{
    return foci == FociUnderFingers::known      ? "The foci of notes know the fingers that rest."
           : foci == FociUnderFingers::outdated ? "Fingers have moved: the foci of notes are those from before, "
                                                  "until the fingers rest."
                                                : "";
}
} // namespace

std::optional<double> noiseVolts (const TouchSnapshot& snapshot, const PlayControls& controls, std::size_t latency)
{
    const auto& design = snapshot.designs[latency];

    if (design == nullptr)
        return {};

    // Noises of different inputs add by their powers; three times their RMS cancels against the inputs'.
    const Eigen::Map<const Eigen::ArrayXd> levels (controls.levels.data(), mostFingers);
    const Eigen::VectorXd powers = design->noiseGains.array().square().matrix() * levels.square().matrix();
    return std::sqrt (powers.maxCoeff());
}

juce::String latencyVoltsText (const TouchSnapshot& snapshot, const PlayControls& controls)
{
    juce::StringArray parts;

    for (std::size_t i = 0; i < touchLatencies.size(); ++i)
        if (const auto volts = noiseVolts (snapshot, controls, i))
            parts.add (juce::String (juce::roundToInt (1000 * touchLatencies[i])) + " ms: "
                       + (*volts < 10 ? juce::String (*volts, 1) : juce::String (juce::roundToInt (*volts))) + " V");

    return parts.joinIntoString (",  ");
}
std::vector<UserMessage> touchSentences (TouchProcessor& processor, const TouchSnapshot& snapshot)
{
    auto messages = processor.messages();

    if (auto progress = progressSentence (processor, snapshot); ! progress.empty())
    {
        addMessage (messages, Urgency::calm, progress);
        return messages;
    }

    if (! processor.parameters().arm().get())
        addMessage (messages, Urgency::calm, "Disarmed: all voltages are 0 V.");
    else
        addMessage (messages, Urgency::caution, loudSentence (processor, snapshot));

    const auto unplayable = unplayableNotesMessage (processor.session().focusProgress(), processor.getSampleRate());
    addMessage (messages, unplayable.urgency, unplayable.text);
    addMessage (messages, Urgency::calm, fociSentence (processor.session().fociUnderFingers()));
    return messages;
}
} // namespace antinode
