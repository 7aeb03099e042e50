#include "WideDesign.h"

#include <antinode_base/NumberText.h>
#include <antinode_fingers/LoadedModel.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace antinode
{
namespace
{
/** Fingers change the modes: those that the design knows of are in what it is made for, all of them in what is played.
 */
WideDesign designUnderFingers (const WideModel& wide, const FocusDescription& focus, Playback playback)
{
    std::vector<Finger> known;
    std::copy_if (focus.fingers.begin(), focus.fingers.end(), std::back_inserter (known),
                  [] (const auto& finger) { return finger.isKnown; });
    auto played = loadedModel (wide.model, focus.fingers);
    auto designed = loadedModel (firstModes (wide.model, wide.known), known);
    auto design = known.empty() ? designWithin (wide, focus, playback) : designFocus (designed, focus, playback);
    const auto count = played.modes();
    const auto sentence = "Not told apart: fingers mix the modes of the device with those beyond. Played are "
                          + std::to_string (count) + " modes, to " + inWords (played.frequencyHz (count - 1)) + " Hz.";
    design.choices.push_back ("Fingers on the surface: " + std::to_string (focus.fingers.size())
                              + ", of which the design knows " + std::to_string (known.size()) + ".");
    return { { std::move (played), count, sentence, std::move (designed) }, std::move (design) };
}
} // namespace

WideDesign designWide (WideModel wide, const FocusDescription& focus, Playback playback, const WidenModel& widen)
{
    if (! focus.fingers.empty())
        return designUnderFingers (wide, focus, playback);

    auto design = designWithin (wide, focus, playback);

    if (auto& spill = design.spillOver; spill && spill->guardedBeyond > 0 && wide.obstacle.empty()
                                        && wide.highestFrequency() < widePlay * spill->designedFrequency)
    {
        wide = widen (firstModes (wide.model, wide.known), widePlay * spill->designedFrequency);
        spill->share = spillOverShare (wide, design);
        spill->playedModes = static_cast<int> (wide.model.modes());
        spill->playedFrequency = wide.highestFrequency();
        spill->obstacle = wide.obstacle;
    }

    return { std::move (wide), std::move (design) };
}
} // namespace antinode
