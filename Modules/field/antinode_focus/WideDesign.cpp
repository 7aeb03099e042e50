#include "WideDesign.h"

#include <antinode_base/NumberText.h>
#include <antinode_fingers/LoadedModel.h>
#include <antinode_fingers/OneSidedContact.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace antinode
{
namespace
{
std::vector<Finger> knownFingers (const std::vector<Finger>& fingers)
{
    std::vector<Finger> known;
    std::copy_if (fingers.begin(), fingers.end(), std::back_inserter (known),
                  [] (const auto& finger) { return finger.isKnown; });
    return known;
}

WideDesign designUnderFingers (const WideModel& wide, const FocusDescription& focus, Playback playback,
                               DesignExtent extent)
{
    const auto known = knownFingers (focus.fingers).size();
    auto played = playedUnderFingers (wide, focus.fingers);
    auto design = known == 0 ? designWithin (wide, focus, playback, extent)
                             : designFocus (*played.designed, focus, playback, extent);
    design.choices.push_back ("Fingers on the surface: " + std::to_string (focus.fingers.size())
                              + ", of which the design knows " + std::to_string (known) + ".");
    return { std::move (played), std::move (design) };
}
} // namespace

WideModel loadedByFingers (const WideModel& wide, const std::vector<Finger>& fingers)
{
    if (fingers.empty())
        return wide;

    auto played = loadedModel (wide.model, fingers);
    auto designed = loadedModel (firstModes (wide.model, wide.known), knownFingers (fingers));
    const auto count = played.modes();
    const auto sentence = "Not separable: fingers mix the modes of the device with those beyond. Played are "
                          + std::to_string (count) + " modes, to " + inWords (played.frequencyHz (count - 1)) + " Hz.";
    return { std::move (played), count, sentence, std::move (designed) };
}

WideModel playedUnderFingers (const WideModel& wide, const std::vector<Finger>& fingers)
{
    auto played = loadedByFingers (wide, fingers);

    if (canLiftOff (fingers))
    {
        played.model = wide.model;
        played.known = wide.model.modes();
    }

    return played;
}

WideDesign designWide (WideModel wide, const FocusDescription& focus, Playback playback, const WidenModel& widen,
                       DesignExtent extent)
{
    if (! focus.fingers.empty())
        return designUnderFingers (wide, focus, playback, extent);

    auto design = designWithin (wide, focus, playback, extent);

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
