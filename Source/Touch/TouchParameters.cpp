#include "TouchParameters.h"

#include <Processor/GroupBuilder.h>
#include <Processor/ParameterTexts.h>

#include <antinode_graph/FilterNode.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace antinode
{
namespace
{
constexpr double quietest = -60, loudest = 20; // dB
constexpr float quietestText = -60 + 1e-3F;    // below which it is called silent
constexpr double metresPerMicrometre = 1e-6;

/** Where fingers are at first, in % of the surface, far from each other; the first one plays. */
constexpr std::pair<double, double> firstFingers[mostFingers] = { { 30, 40 }, { 70, 60 }, { 30, 75 }, { 70, 25 },
                                                                  { 50, 50 }, { 15, 20 }, { 85, 80 }, { 50, 15 } };

FingerParameters addFinger (GroupBuilder& group, int index, const SurfaceSource& surface)
{
    const auto number = juce::String (index + 1), identifier = "finger" + number + "_", name = "Finger " + number + " ";
    const auto [x, y] = firstFingers[index];
    FingerParameters finger {};
    finger.x = group.number (identifier + "x", name + "x", "", { 0, 100 }, x, placeTexts (surface, SurfaceAxis::x));
    finger.y = group.number (identifier + "y", name + "y", "", { 0, 100 }, y, placeTexts (surface, SurfaceAxis::y));
    finger.presence = group.choice (identifier + "state", name + "state", { "absent", "silent", "plays" },
                                    static_cast<int> (index == 0 ? FingerPresence::plays : FingerPresence::absent));
    finger.level =
        group.number (identifier + "level", name + "level", "", { 0.01, 100, true }, 5, unitTexts ("\xC2\xB5m", 3));
    finger.load = group.choice (identifier + "load", name + "load", { "none", "light", "medium", "firm" });
    return finger;
}
} // namespace

TouchParameters::TouchParameters (juce::AudioProcessor& processor, const SurfaceSource& surface)
{
    for (int i = 0; i < mostFingers; ++i)
    {
        const auto number = juce::String (i + 1);
        GroupBuilder group (processor, "finger" + number, "Finger " + number, ordered);
        fingers[static_cast<std::size_t> (i)] = addFinger (group, i, surface);
        group.addToProcessor();
    }

    std::vector<juce::String> latencies;
    std::transform (touchLatencies.begin(), touchLatencies.end(), std::back_inserter (latencies),
                    [] (double latency) { return juce::String (juce::roundToInt (1000 * latency)) + " ms"; });
    GroupBuilder output (processor, "output", "Output", ordered);
    chosenLatency = output.choice ("latency", "Latency", latencies);
    outputGain =
        output.number ("gain", "Gain", "", { quietest, loudest }, 0, unitTexts ("dB", 1, quietestText, "silent"));
    armed = output.flag ("arm", "Arm", true, "armed", "disarmed", false);
    bypassed = output.flag ("bypass", "Bypass", false, "bypassed", "playing");
    output.addToProcessor();
    begin();
}

TouchSettings TouchParameters::settings() const
{
    TouchSettings now;

    for (std::size_t k = 0; k < fingers.size(); ++k)
        now.fingers[k] = { static_cast<float> (fingers[k].x->get()), static_cast<float> (fingers[k].y->get()),
                           static_cast<FingerPresence> (fingers[k].presence->get()),
                           static_cast<FingerLoad> (fingers[k].load->get()) };

    now.latency = static_cast<std::size_t> (chosenLatency->get());
    return now;
}

PlayControls TouchParameters::controls() const
{
    PlayControls now;
    const auto decibels = outputGain->get();
    const auto factor = decibels <= quietest ? 0.0 : std::pow (10, decibels / 20);

    for (std::size_t k = 0; k < fingers.size(); ++k)
        if (static_cast<FingerPresence> (fingers[k].presence->get()) == FingerPresence::plays)
            now.levels[k] = std::min (FilterNode::largestLevel, fingers[k].level->get() * metresPerMicrometre * factor);

    now.focusGain = std::min (1.0, factor);
    now.latency = static_cast<std::size_t> (chosenLatency->get());
    now.isArmed = *armed && ! *bypassed;
    return now;
}
} // namespace antinode
