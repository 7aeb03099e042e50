#pragma once

#include "DriveAllocation.h"
#include "FocusDescription.h"

#include <antinode_model/ModalModel.h>
#include <antinode_model/VoltageProgram.h>

#include <vector>

namespace antinode
{
/** The drive of one mode: an oscillation up to the focus (and a constant where the paper's drive is requested), then
   its release. Normalised: alone in its own mode it brings the modal velocity 1 (m/s kg^1/2) at t_f. */
struct ModeDrive
{
    int mode = 0;
    double growth = 0; ///< gamma
    int cycles = 0;    ///< N
    std::vector<Oscillation> oscillations;
};

/** A mode with the envelope that it is driven with. */
struct DrivenMode
{
    int mode = 0;
    double decayRate = 0;       ///< a, 1/s
    double dampedFrequency = 0; ///< b, rad/s
    double growth = 0;          ///< gamma >= 0
    int cycles = 0;             ///< N >= 0
};

/** r, 1/s: how fast drives are released. [any] Docs/Theory.md, section 3.7. */
double releaseRate();

/** How long a drive takes to be released after the focus, s: its envelope has then fallen by 2e-6. [any] */
double releaseDuration();

/** What follows an oscillation that ends at the focus, so that neither it nor its slope jumps there: the oscillation
   continues with the envelope (2 + g/r) e^{-r tau} - (1 + g/r) e^{-2 r tau}, g its growth, r = 20000/s. A drive that is
   cut would ring in any band-limited playback, and the ringing before t_f would shake high modes at the very instant of
   the focus. [any] Docs/Theory.md, section 3.7. */
std::vector<Oscillation> makeRelease (const Oscillation&);

/** An oscillation that begins without a jump of its value or slope: times (1 - e^{-r tau})^2, r that of the release, as
   three oscillations. The first is the given one; those that only shape the onset end where they have died away, or
   with it. [any] Docs/Theory.md, section 3.7. */
std::vector<Oscillation> makeOnset (const Oscillation&);

/** How a drive begins. */
enum class DriveStart
{
    jump,  ///< As its closed form says: at a value that is small where the envelope grows slowly.
    smooth ///< With an onset, as limited slew rates and currents need it.
};

/** Oscillations that end together, as they are played: with the onset where wanted, and the release. [any] */
std::vector<Oscillation> playedDrive (const std::vector<Oscillation>&, DriveStart);

/** The drive of one mode from rest. Starts at t_f - T, b T = pi/2 + 2 pi N, is released after t_f.
    [any] Docs/Theory.md, sections 3.2, 3.3 and 3.7; paper (26). */
ModeDrive driveMode (const DrivenMode&, DriveKind, double focusTime, DriveStart = DriveStart::jump);

/** How the drives of a device begin: smoothly where it limits slew rates or currents. [any] */
DriveStart driveStart (const ModalModel&);

/** The drives of all controlled modes, growth and cycles chosen if they are not given: all velocities then grow with
   one common rate of 4 / (time before the focus), with as many cycles as fit.
    @param modes  mode indices
    @throws InputError  when a list has a wrong length, the requested cycles do not fit before the focus, or an envelope
                        would grow beyond what a drive can start from
    [any] Docs/Theory.md, section 3.5. */
std::vector<ModeDrive> driveModes (const ModalModel&, const std::vector<int>& modes, double focusTime,
                                   const TransientChoice&);

/** Drives in addition to those that driveModes chose: one per mode that rises three times as fast, so that a mode's
   velocity can be made from two envelopes whose errors cancel. None if growths are given.
    @throws InputError  as driveModes
    [any] Docs/Theory.md, section 7.5. */
DriveList fasterDrives (const ModalModel&, const std::vector<int>& modes, double focusTime, const TransientChoice&);

/** The faster drives, and each of all these drives once more, begun a quarter period later, or earlier where it lasts
   no more than that: for voltage limits that one drive per mode cannot meet.
    @param choice  with offset-free drives
    @throws InputError  as driveModes
    [any] Docs/Theory.md, section 4.8. */
DriveList furtherDrives (const ModalModel&, const std::vector<int>& modes, double focusTime,
                         const TransientChoice& choice);
} // namespace antinode
