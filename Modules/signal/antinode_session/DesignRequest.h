#pragma once

#include "Documents.h"

#include <antinode_focus/FocusDescription.h>
#include <antinode_focus/SpillOver.h>
#include <antinode_model/ModalModel.h>
#include <antinode_model/VoltageProgram.h>

#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace antinode
{
/** A requested bank: one focus at its own position, for FocusBank::livePlace, and moved to many positions, for the
    notes. */
struct DesignRequest
{
    std::shared_ptr<const ModalModel> model;
    FocusDescription focus;                        ///< Its first target is moved, the others keep their distance to it.
    std::vector<std::pair<double, double>> places; ///< x, y in m, up to 128; may be empty.
    std::vector<int> first;                        ///< The notes' places that are wanted first, in this order.
    Playback playback;
    std::function<WideModel()> widen; ///< Gives the model with modes beyond; none: nothing is known of any. [worker]
    std::shared_ptr<const DesignDocument> written = {}; ///< Plays at its own place; none: the focus is designed there.
};

/** What a place of a bank needs, V; 0: it has no focus. */
struct PlaceVolts
{
    double peak = 0;
    double bound = 0; ///< No waveform needs less, of those that the method chooses from; 0: not known.

    bool operator== (const PlaceVolts&) const = default;
};

/** The progress of a worker. */
struct DesignProgress
{
    int designed = 0, wanted = 0;  ///< Places of the newest request, its own one among them.
    int failed = 0;                ///< Of these: places without a focus.
    std::vector<int> failedNotes;  ///< The notes' places without a focus, ascending.
    std::vector<PlaceVolts> volts; ///< Of the notes' places, as many as were asked for.
    bool hasFirst = false;         ///< Whether its own place and those that are wanted first were handed over.
    std::string error;             ///< Why the last of them failed, in one sentence.
    std::string liveError;         ///< Why the focus at its own place failed; empty if it did not.
    double firstMilliseconds = 0;  ///< From the newest request to its first focus.
    double endSeconds = 0;         ///< After a trigger: no focus that was handed over sounds later, brakes included.

    bool isDone() const { return designed >= wanted; }
};
} // namespace antinode
