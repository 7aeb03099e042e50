#pragma once

#include "Detuning.h"

#include <antinode_base/Reflection.h>
#include <antinode_fingers/Finger.h>
#include <antinode_fingers/Sensation.h>

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace antinode
{
struct AllocationChoice;
struct ModalModel;

/** How ceramics share what is played. Docs/Theory.md, section 4.7. */
enum class AllocationMethod
{
    exact,        ///< Exact terminal rows within the limits, soft guard modes: the default.
    leastVoltage, ///< Samples of any form, near the lowest voltage of any, or of the least energy within the limits.
    paper         ///< Rows (29) within the limits: the paper's problem.
};

/** The words of files, messages and tables. */
inline constexpr WordList<AllocationMethod, 3> allocationMethodWords { { { "exact", AllocationMethod::exact },
                                                                         { "least_voltage",
                                                                           AllocationMethod::leastVoltage },
                                                                         { "paper", AllocationMethod::paper } } };

/** Multiples of the lower bound that only the limits end. */
inline constexpr double upToLimits = std::numeric_limits<double>::infinity();

/** A method that is no longer offered, and what is used where a document or a host asks for it. */
struct RetiredMethod
{
    std::string_view word;
    AllocationMethod method;
    bool isUpToLimits = false; ///< By least voltage: as AllocationChoice::timesBound says with upToLimits.
    const char* outcome;       ///< What that gives, for its sentence.
};

/** What exact rows give instead of another method of exact rows. */
inline constexpr auto outcomeOfExact = "gives the same velocities at the focus, with more voltage within the limit";

/** In the order of the plug-in's parameter, of which hosts keep the index. */
inline constexpr std::array retiredMethods {
    RetiredMethod { .word = "one_to_one",
                    .method = AllocationMethod::paper,
                    .outcome = "shares each mode among all ceramics and keeps the voltage limit" },
    RetiredMethod { .word = "minimum_norm",
                    .method = AllocationMethod::paper,
                    .outcome = "gives the same voltages where they keep the limit" },
    RetiredMethod { .word = "minimum_peak", .method = AllocationMethod::exact, .outcome = outcomeOfExact },
    RetiredMethod { .word = "dictionary",
                    .method = AllocationMethod::leastVoltage,
                    .outcome = "gives the same velocities at the focus, at about the same voltage" },
    RetiredMethod { .word = "free_waveform",
                    .method = AllocationMethod::leastVoltage,
                    .isUpToLimits = true,
                    .outcome = "gives the same voltages" }
};

/** A choice with what is used instead of a method: exact rows where displacements are to be 0. [any] */
AllocationChoice withRetired (AllocationChoice, const RetiredMethod&);

/** What is used instead of a method on a model: exact rows where modes are complex, since samples need real ones. Other
    choices stay as they are. [any] */
AllocationChoice suitedTo (const ModalModel&, AllocationChoice);

/** What is used instead of the method that was asked for, and what to write; empty where it is offered. [any] */
std::string retirementInWords (const AllocationChoice&);

/** Where less is to be felt than at the targets. */
enum class FeltAt
{
    everywhere, ///< On the surface farther than feltNeighbourhood from all targets.
    fingers,    ///< At the fingers of the focus.
    places      ///< At places that are given.
};

/** The felt level elsewhere over the whole event counts in what a free waveform minimises.
    Docs/Design/allocation.md */
struct FeltChoice
{
    FeltAt at = FeltAt::everywhere;
    std::vector<std::pair<double, double>> places; ///< x, y, m; with FeltAt::places only.
    double weight = 10;  ///< At 1 the energies of voltages and of what is felt count alike, each in that of the
                         ///< design without it.
    double after = 0.02; ///< s: how long voltages may go on after the focus.
};

/** Beyond this distance from the targets nothing should be felt, m: about the width of two fingertips. */
inline constexpr double feltNeighbourhood = 0.03;

/** The errors that a design is robust against, and their weight. Docs/Theory.md, section 7.5. */
struct Robustness
{
    DetuningSpread spread = usualSpread;
    double weight =
        1000; ///< The cost of an expected error as large as the wanted velocities, as a multiple of the least energy.
};

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
    double peakVelocity = 0; ///< m/s, more than 0. With a level the search for it begins here.
    int phase = 1;           ///< 1 or -1: the sign of the peak.
    TargetProfile profile = TargetProfile::radial;
    std::optional<double> widthY = {}; ///< Full width at half maximum in y, m, of a separable target; none: as in x.
    std::optional<double> time = {};   ///< s from the trigger; none: the focus time. Several times make a train.
    std::optional<double> level = {};  ///< dB SL at its centre, in place of the peak velocity. A design has none any
                                       ///< more: it has the velocity that reaches it.
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
    std::optional<Robustness> robust;       ///< With exact or near the bound only: what the design is robust against.
    std::optional<double> timesBound = {};  ///< With least voltage only: the peak in multiples of what any waveform
                                            ///< needs, above 1, or upToLimits: the least energy within the limits;
                                            ///< none: usualTimesBound.
    const RetiredMethod* retired = nullptr; ///< The method that was asked for, where it is no longer offered.

    /** Whether the peak is to be near the lowest of any waveform, not only within the limits. */
    bool isNearBound() const
    {
        return method == AllocationMethod::leastVoltage && timesBound.value_or (usualTimesBound) < upToLimits;
    }

    /** Whether the waveform is that of the least energy of any within the limits. */
    bool isUpToLimits() const { return method == AllocationMethod::leastVoltage && ! isNearBound(); }
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
    std::optional<FeltChoice> felt; ///< With samples up to the limits only: less is to be felt elsewhere.
    SkinThreshold threshold;        ///< Of felt and of levels. Not in files: the library's, or that of a command.
};
} // namespace antinode
