#pragma once

#include "SpillOver.h"

#include <functional>

namespace antinode
{
/** A design that is made for a device and knows what it leaves in modes beyond it. */
struct WideDesign
{
    WideModel wide; ///< With modes to widePlay times the highest that the design knows, where there are so many.
    FocusDesign design;
};

/** A wide model with fingers on it: all of them in what is played, those that designs know in what these are made for.
    Without fingers itself. The device's own modes and those beyond are not told apart then.
    @throws InputError  as loadedModel
    [worker] Docs/Theory.md, section 1.12. */
WideModel loadedByFingers (const WideModel&, const std::vector<Finger>&);

/** The same for voltages that are played: where fingers may lift off, they are added as the voltages are played, and
   the modes that are played are those without them. [worker] */
WideModel playedUnderFingers (const WideModel&, const std::vector<Finger>&);

/** Gives a device with modes to a frequency, Hz, or as far as they can be solved. */
using WidenModel = std::function<WideModel (const ModalModel& known, double frequency)>;

/** Designs a focus within a wide model, which is widened where the design guards modes beyond the device's own. Where
    fingers are on the surface, the wide model is loaded by all of them, and the design by those that it knows.
    @throws InputError, LimitError  as designFocus
    [worker] Docs/Theory.md, sections 1.12 and 5.2. */
WideDesign designWide (WideModel, const FocusDescription&, Playback, const WidenModel&,
                       DesignExtent extent = DesignExtent::complete);
} // namespace antinode
