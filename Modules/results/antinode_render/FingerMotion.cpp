#include "FingerMotion.h"

#include "FocusOutcome.h"

#include <antinode_base/NumberText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_fingers/LoadedModel.h>
#include <antinode_focus/EventPeak.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>

namespace antinode
{
namespace
{
FingerMotion motionUnder (const RenderedFocus& focus, const Finger& finger)
{
    const Eigen::RowVectorXd velocity = contactShapes (focus.model, finger) * focus.render.modalVelocities;
    const auto peak = largestInTime (velocity);
    return { finger, velocity[focus.render.focusSample], peak.value, peak.position / focus.render.sampleRate };
}
std::string contactInWords (const std::optional<ContactHistory>& contact)
{
    return contact ? "; lifted off " + std::to_string (contact->lifts) + (contact->lifts == 1 ? " time, " : " times, ")
                         + inWords (contact->liftedTime * milli) + " ms in all"
                   : std::string {};
}
} // namespace

std::vector<FingerMotion> fingerMotions (const RenderedFocus& focus)
{
    const auto& fingers = focus.design.description.fingers;
    std::vector<FingerMotion> motions;
    std::transform (fingers.begin(), fingers.end(), std::back_inserter (motions),
                    [&] (const auto& finger) { return motionUnder (focus, finger); });

    for (std::size_t i = 0; i < focus.contacts.size(); ++i)
        motions[i].contact = focus.contacts[i];

    return motions;
}

std::vector<std::string> fingersToText (const RenderedFocus& focus)
{
    std::vector<std::string> lines;

    for (const auto& motion : fingerMotions (focus))
        lines.push_back (
            formatted ("%-14s %s at %s%s: %s mm/s at the focus, %s mm/s at most, %s ms after the trigger%s",
                       ("finger " + std::to_string (lines.size() + 1)).c_str(), motion.finger.name.c_str(),
                       placeInWords (focus.model.surface, motion.finger.x, motion.finger.y).c_str(),
                       motion.finger.isKnown ? "" : ", unknown to the design",
                       inWords (motion.velocityAtFocus * milli).c_str(), inWords (motion.peakVelocity * milli).c_str(),
                       inWords (motion.peakTime * milli).c_str(), contactInWords (motion.contact).c_str()));

    return lines;
}

nlohmann::ordered_json fingersToJson (const RenderedFocus& focus)
{
    auto list = nlohmann::ordered_json::array();

    for (const auto& motion : fingerMotions (focus))
    {
        list.push_back ({ { "x_mm", motion.finger.x * milli },
                          { "y_mm", motion.finger.y * milli },
                          { "kind", motion.finger.name },
                          { "known", motion.finger.isKnown },
                          { "velocity_at_focus_mm_s", motion.velocityAtFocus * milli },
                          { "peak_velocity_mm_s", motion.peakVelocity * milli },
                          { "peak_time_ms", motion.peakTime * milli } });

        if (motion.contact)
        {
            list.back()["lifts"] = motion.contact->lifts;
            list.back()["lifted_ms"] = motion.contact->liftedTime * milli;
        }
    }

    return list;
}
} // namespace antinode
