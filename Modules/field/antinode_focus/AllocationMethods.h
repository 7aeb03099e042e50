#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>

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
} // namespace antinode
