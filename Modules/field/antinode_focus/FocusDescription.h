#pragma once

#include "Detuning.h"

#include <antinode_fingers/Finger.h>
#include <antinode_fingers/Sensation.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace antinode
{
/** How ceramics share what is played. */
enum class AllocationMethod
{
    oneToOne,     ///< Each mode by the one ceramic that excites it most.
    minimumNorm,  ///< Rows (29), least norm, no limit: closed form.
    paper,        ///< Rows (29) within the voltage limit: the paper's problem.
    exact,        ///< Exact terminal rows within the voltage limit, soft guard modes: the default.
    minimumPeak,  ///< Exact terminal rows at the least peak voltage.
    dictionary,   ///< The same with several drives per mode: near the least voltage of any waveform.
    freeWaveform, ///< Samples of any form, of the least energy within the voltage limit.
    leastVoltage  ///< The same within a limit as near as asked to the least voltage of any waveform.
};

/** What a method mixes. */
enum class AllocatedWaveforms
{
    drives,     ///< The drives that the focus describes.
    dictionary, ///< Drives of its own, with several growth rates and both quadratures per mode.
    samples     ///< Samples of its own.
};

/** What the rest of the program knows of a method. */
struct AllocationTraits
{
    AllocationMethod method;
    const char* word;     ///< In files.
    const char* sentence; ///< For the choices of a design, without a full stop.
    AllocatedWaveforms waveforms = AllocatedWaveforms::drives;
    bool hasExactRows = false;       ///< Asks for the very velocities at the focus, by rows of drives in any number.
    bool asksForMinimumPeak = false; ///< Whatever the limit.
    bool takesTrains = false;        ///< Targets with several times.
    bool takesRobustness = false;    ///< A design that is robust against errors of the model.
    bool takesFurtherDrives = false; ///< Where one drive per mode cannot meet the limit.
};

/** All methods: files, messages and parameters have their words from here. In the order of the plug-in's parameter, of
    which hosts keep the index: a further one comes last. */
inline constexpr std::array allocationMethods {
    AllocationTraits { .method = AllocationMethod::exact,
                       .word = "exact",
                       .sentence =
                           "exact terminal velocities of all controlled modes at the least norm within the voltage "
                           "limit; other modes are guarded",
                       .hasExactRows = true,
                       .takesTrains = true,
                       .takesRobustness = true,
                       .takesFurtherDrives = true },
    AllocationTraits { .method = AllocationMethod::paper,
                       .word = "paper",
                       .sentence =
                           "the paper's problem: least norm within the voltage limit, only each mode's own row" },
    AllocationTraits { .method = AllocationMethod::oneToOne,
                       .word = "one_to_one",
                       .sentence =
                           "one ceramic per mode, the one that excites it most; ignores other modes and the limit" },
    AllocationTraits { .method = AllocationMethod::minimumNorm,
                       .word = "minimum_norm",
                       .sentence = "least norm of all voltages, only each mode's own row, without a limit" },
    AllocationTraits { .method = AllocationMethod::minimumPeak,
                       .word = "minimum_peak",
                       .sentence =
                           "exact terminal velocities of all controlled modes at the least peak voltage; other modes "
                           "are guarded",
                       .hasExactRows = true,
                       .asksForMinimumPeak = true,
                       .takesTrains = true },
    AllocationTraits { .method = AllocationMethod::dictionary,
                       .word = "dictionary",
                       .sentence =
                           "exact terminal velocities of all controlled modes at the least peak voltage, with several "
                           "growth rates and both quadratures per mode; other modes are guarded",
                       .waveforms = AllocatedWaveforms::dictionary,
                       .hasExactRows = true,
                       .asksForMinimumPeak = true },
    AllocationTraits { .method = AllocationMethod::freeWaveform,
                       .word = "free_waveform",
                       .sentence =
                           "exact terminal velocities of all controlled modes by freely chosen samples of least energy "
                           "within the voltage limit; other modes are guarded",
                       .waveforms = AllocatedWaveforms::samples },
    AllocationTraits { .method = AllocationMethod::leastVoltage,
                       .word = "least_voltage",
                       .sentence =
                           "exact terminal velocities of all controlled modes by freely chosen samples near the lowest "
                           "voltage that any waveform needs; other modes are guarded",
                       .waveforms = AllocatedWaveforms::samples,
                       .asksForMinimumPeak = true,
                       .takesRobustness = true }
};

/** The row of a method. [any] */
constexpr const AllocationTraits& methodTraits (AllocationMethod method)
{
    return *std::find_if (allocationMethods.begin(), allocationMethods.end(),
                          [method] (const auto& each) { return each.method == method; });
}

/** The words of the methods that have a property, for messages: 'exact', 'minimum_peak' or 'dictionary'.
    @param joint  before the last: "or", "and" [any] */
std::string methodsThat (bool AllocationTraits::*has, std::string_view joint);

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
    double weight = 10;      ///< At 1 the energies of voltages and of what is felt count alike, each in that of the
                             ///< design without it.
    double after = 0.02;     ///< s: how long voltages may go on after the focus.
    SkinThreshold threshold; ///< Not in files: the library's, or that of a command.
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
