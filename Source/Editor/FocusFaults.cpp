#include "FocusFaults.h"

#include <antinode_base/NumberText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_focus/SuitableFocus.h>

#include <algorithm>

namespace antinode
{
namespace
{
constexpr double poorCapture = 0.9, poorVelocity = 0.9;

/** "The focus", or one of several. */
std::string named (std::size_t target, std::size_t targets)
{
    return targets > 1 ? "Focus " + std::to_string (target + 1) : "The focus";
}
} // namespace

std::vector<std::string> placeFaults (const Surface& surface, const FocusDescription& focus)
{
    std::vector<std::string> faults;
    const auto& targets = focus.targets;

    for (std::size_t i = 0; i < targets.size(); ++i)
        if (const auto distance = distanceToEdge (surface, targets[i].x, targets[i].y); distance < targets[i].width / 2)
            faults.push_back (named (i, targets.size()) + " lies on an edge: " + fixedText (distance * milli, 1)
                              + " mm from it, which is less than half of its width. Move it inwards, or lower Width.");

    return faults;
}

std::vector<std::string> designFaults (const ModalModel& model, const FocusDesign& design)
{
    auto faults = placeFaults (model.surface, design.description);
    const auto captured = std::min_element (design.moments.begin(), design.moments.end(),
                                            [] (const auto& a, const auto& b) { return a.captured < b.captured; })
                              ->captured;
    const auto usesAll = static_cast<Eigen::Index> (design.controlledModes.size()) == model.modes();

    if (captured < poorCapture)
        faults.push_back ("The controlled modes represent only " + fixedText (captured, 2)
                          + " of the focus (good: 0.9 or more). Raise Width"
                          + (usesAll ? "" : ", set Controlled modes to more or to chosen,") + " or move the focus.");

    return faults;
}

std::vector<std::string> outcomeFaults (const RenderedFocus& focus, const FocusOutcome& outcome)
{
    std::vector<std::string> faults;
    const auto targets = outcome.targets.size();

    for (std::size_t i = 0; i < targets; ++i)
    {
        const auto& wanted = outcome.targets[i].wanted;
        const auto reached = wanted.phase * outcome.targets[i].velocityAtCentre;

        if (focus.design.captured >= poorCapture && reached < poorVelocity * wanted.peakVelocity)
            faults.push_back (named (i, targets) + " reaches " + inWords (reached * milli) + " of "
                              + inWords (wanted.peakVelocity * milli)
                              + " mm/s. Lower Peak velocity, raise Focus time, or choose another Allocation.");
    }

    if (focus.felt)
        for (std::size_t i = 0; i < focus.felt->targets.size(); ++i)
            if (const auto level = focus.felt->targets[i].level; level < 0)
                faults.push_back (named (i, focus.felt->targets.size()) + " is not felt: " + fixedText (level, 1)
                                  + " dB SL, where skin feels from 0 dB SL on. Raise Peak velocity.");

    return faults;
}
} // namespace antinode
