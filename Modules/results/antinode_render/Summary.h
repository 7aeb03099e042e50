#pragma once

#include "FocusOutcome.h"
#include "RenderedFocus.h"

#include <nlohmann/json_fwd.hpp>

namespace antinode
{
/** The keys of summary.json. Docs/FileFormats.md. [any] */
nlohmann::ordered_json summaryToJson (const RenderedFocus&, const FocusOutcome&);

/** What the surface under a finger did, averaged over its contact. */
struct FingerMotion
{
    Finger finger;
    double velocityAtFocus = 0;                 ///< m/s
    double peakVelocity = 0;                    ///< m/s, with its sign.
    double peakTime = 0;                        ///< s from the trigger.
    std::optional<ContactHistory> contact = {}; ///< Where one of the fingers may lift off.
};

/** Of each finger of the focus, in their order. [worker] */
std::vector<FingerMotion> fingerMotions (const RenderedFocus&);

/** A line a finger, in two columns. [worker] */
std::vector<std::string> fingersToText (const RenderedFocus&);

/** As summary.json has them. [worker] Docs/FileFormats.md. */
nlohmann::ordered_json fingersToJson (const RenderedFocus&);
} // namespace antinode
