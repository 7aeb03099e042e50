#pragma once

#include "DesignFocus.h"

#include <functional>

namespace antinode
{
/** Scores come from a plate with modes to so many times the highest frequency that is designed for or guarded. */
inline constexpr double widePlay = 2.5;

/** What of a field may lie in modes beyond the known ones before more of them are guarded. */
inline constexpr double allowedSpillOver = 1e-3;

/** A device with modes beyond those that it says, all on its own points. */
struct WideModel
{
    ModalModel model;                        ///< The device's modes, bit for bit, then those beyond.
    Eigen::Index known = 0;                  ///< How many are the device's own.
    std::string obstacle;                    ///< Why they do not go on to where they were wanted; empty where they do.
    std::optional<ModalModel> designed = {}; ///< What designs are made for where fingers change the modes; none: the
                                             ///< known ones.

    /** The highest frequency of all, Hz. */
    double highestFrequency() const { return model.frequencyHz (model.modes() - 1); }
};

/** The lowest modes of a model, for example the device's own of a wide one. [any] */
ModalModel firstModes (const ModalModel&, Eigen::Index count);

/** A device's modes and those beyond them of a second solution, taken to the points of the first.
    @param wide  real modes of the same device, more of them
    @throws InputError  where wide is another device, or has no more modes
    [worker] Docs/Theory.md, section 5.2. */
WideModel withModesBeyond (const ModalModel& known, const ModalModel& wide);

/** RMS over the surface of the part of a field that modes beyond the known ones carry, relative to the whole field.
    @param modalVelocities  of all modes, m/s kg^1/2; 0 where nothing moves
    [any] */
double spillOverShare (const WideModel&, const Eigen::VectorXd& modalVelocities);

/** The largest of these at the foci of a design, by the closed form. [worker] */
double spillOverShare (const WideModel&, const FocusDesign&);

/** Designs a focus with the device's own modes. Where more than allowedSpillOver of the field is then in modes beyond,
   more and more of these are guarded until it is not; where that does not help, or makes the field worse, the first
   design stays, with a warning.
    @throws  as designFocus
    [worker] Docs/Theory.md, section 5.2. */
FocusDesign designWithin (const WideModel&, const FocusDescription&, Playback,
                          DesignExtent extent = DesignExtent::complete);

/** The same for playing, with modes beyond guarded from the start, as another place of the same bank needed them.
    @param guarded  the device's modes and those that are guarded beyond, by firstModes
    @param known    how many are the device's own
    @throws  as designFocus
    [worker] */
FocusDesign designGuarding (const ModalModel& guarded, Eigen::Index known, FocusDescription, Playback);

/** To which frequency modes beyond are looked for: widePlay times the highest, where the plate model can play it. Hz
    [any] */
double frequencyBeyond (const ModalModel& known, double sampleRate);

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
