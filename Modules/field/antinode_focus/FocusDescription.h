#pragma once

#include "AllocationMethods.h"
#include "FeltChoice.h"
#include "Robustness.h"

#include <antinode_fingers/Finger.h>

#include <optional>
#include <string>
#include <vector>

namespace antinode
{
/** The shape of a wanted field around its centre. Docs/Theory.md, section 2; paper (34). */
enum class TargetShape
{
    sinc,    ///< sin (a r) / (a r)
    bump,    ///< e exp (-1 / (1 - (r/a)^2)), 0 beyond a
    gaussian ///< exp (-4 ln 2 (r / width)^2)
};

/** How a target's shape spreads over a plate; on a line both are the same. Docs/Theory.md, section 2.1. */
enum class TargetProfile
{
    radial,   ///< A function of the distance from the centre.
    separable ///< The product of one profile in x and one in y.
};

/** One wanted place. */
struct Target
{
    TargetShape shape = TargetShape::sinc;
    double x = 0, y = 0;     ///< Centre, m.
    double width = 0;        ///< Full width at half maximum, m.
    double peakVelocity = 0; ///< m/s, more than 0.
    int phase = 1;           ///< 1 or -1: the sign of the peak.
    TargetProfile profile = TargetProfile::radial;
    std::optional<double> widthY = {}; ///< Full width at half maximum in y, m, of a separable target; none: as in x.
    std::optional<double> time = {};   ///< s from the trigger; none: the focus time. Several times make a train.
};

enum class ModeOrder
{
    energy,   ///< Those that represent most of the target's energy first.
    frequency ///< The lowest first.
};

/** The controlled modes: at most one of count, captured, maximumFrequency; none: enough for 0.99 captured. */
struct ModeChoice
{
    std::optional<int> count;
    ModeOrder order = ModeOrder::energy;
    std::optional<double> captured;         ///< sqrt (S/K) to be reached, 0 to 1.
    std::optional<double> maximumFrequency; ///< Hz
    std::optional<int> among; ///< Only the first so many modes may be controlled, the others are guarded; none: any.
                              ///< Not in files: designWithin() sets it.
};

enum class DriveKind
{
    offsetFree, ///< The default: no constant part, hardly any step at the start. Docs/Theory.md, section 3.3.
    paper       ///< Paper (26) and appendix B, corrected. Docs/Theory.md, section 3.2.
};

/** How the modes reach their velocity. Lists hold one value for all modes, or one per controlled mode. */
struct TransientChoice
{
    DriveKind drive = DriveKind::offsetFree;
    std::vector<double> growth;               ///< gamma, at least 0; empty: chosen so that all modes rise together.
    std::vector<int> cycles;                  ///< N, at least 0; empty: as many as fit before the focus time.
    std::optional<double> maximumDuration;    ///< s, of the drive before the focus time.
    std::optional<double> brake;              ///< gamma' > 1: decay after the focus, as a multiple of the free decay.
    std::optional<double> brakeDuration = {}; ///< T_b, s: all is at rest so long after the focus.
};

/** How near least voltage goes to its bound by default: nearer ones spill over into more modes. */
inline constexpr double usualTimesBound = 1.25;

struct AllocationChoice
{
    AllocationMethod method = AllocationMethod::exact;
    std::optional<double> voltageLimit; ///< V for every ceramic; else (and at most) the device's own.
    std::optional<int> guardModes;      ///< The number of guarded uncontrolled modes (the lowest ones); none: all.
    double guardWeight = 100;
    std::optional<double>
        window; ///< s before the focus time in which the norm is taken and the limit is imposed; none: all.
    bool isUndisplaced =
        false; ///< At the focus the controlled modes are to be undisplaced as well; with exact rows, not robust.
    std::optional<Robustness> robust;      ///< With exact or least voltage only: what the design is robust against.
    std::optional<double> timesBound = {}; ///< With least voltage only: the peak in multiples of what any waveform
                                           ///< needs, above 1; none: usualTimesBound.
};

/** A wanted focus: position, shape, velocity, time and method. Docs/FileFormats.md. */
struct FocusDescription
{
    std::string name;
    std::vector<Target> targets;
    double focusTime = 0; ///< t_f, s after the trigger.
    ModeChoice modes;
    TransientChoice transients;
    AllocationChoice allocation;
    std::optional<double> edgeWindow;              ///< Tukey taper as a fraction of the surface's length, 0 to 1.
    std::vector<std::pair<double, double>> probes; ///< x, y, m.
    std::vector<Finger> fingers;                   ///< That rest on the surface.
    std::optional<FeltChoice> felt;                ///< With free waveforms only: less is to be felt elsewhere.
};
} // namespace antinode
