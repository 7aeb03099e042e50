#pragma once

#include "DesignRequest.h"
#include "PlayControls.h"

#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace antinode
{
/** Middle C plays the focus at its own position, whatever the other notes play. */
inline constexpr int spotNote = 60;

/** The place of the bank that a note means. [any] */
int bankPlaceOf (int note, NoteMeaning);

/** The places of all notes: spread over the surface, middle C at the spot. @param spot  x, y in m
    @return  x, y in m, by note number [any] */
std::vector<std::pair<double, double>> spreadNotes (const Surface&, std::pair<double, double> spot);

/** What gives the modes beyond those of a model, for DesignRequest::widen.
    @param sampleRate  that the foci are played at, Hz [any]; what it returns: [worker] */
std::function<WideModel()> modesBeyond (std::shared_ptr<const DeviceDocument>, std::shared_ptr<const ModalModel>,
                                        double sampleRate);
} // namespace antinode
