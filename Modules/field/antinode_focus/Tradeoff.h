#pragma once

#include "FocusDescription.h"

#include <antinode_model/ModalModel.h>
#include <antinode_model/VoltageProgram.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace antinode
{
struct FocusDesign;

/** One design of a trade-off. */
struct TradeoffPoint
{
    AllocationMethod method = AllocationMethod::exact;
    double envelopeFolds = 0; ///< Growth that all modes share, in e-folds before the focus; 0 for a free waveform.
    double limitMultiple =
        0;                  ///< Of a free waveform: its limit as a multiple of the bound of all waveforms; 0: no limit.
    double peakVoltage = 0; ///< V
    double timeInMotion =
        0;             ///< s before the focus during which the modal velocities' norm is above half of its final value.
    double vScore = 0; ///< Against what the controlled modes represent, closed form.
    double fieldError = 0;  ///< The same.
    bool isOnFront = false; ///< No other point with a field error below 5 % has both less voltage and less time.
    std::optional<double> feltContrast; ///< dB, where it is wanted and there is one.
    std::string failure;                ///< Why there is no design; empty if there is one.
};

/** Gives the felt contrast of a design in dB, none where it has none; called from several threads at once. */
using FindFeltContrast = std::function<std::optional<double> (const FocusDesign&)>;

/** Voltage and duration of one focus by all methods and growths. */
struct Tradeoff
{
    std::vector<TradeoffPoint> points; ///< Method by method, growth ascending.
    double lowerBoundVoltage = 0;      ///< V: no waveform does it below.
    double lowerBoundGap = 0;          ///< As FocusDesign has it.
    std::size_t planned = 0;           ///< How many points there are when all are designed.
    double expectedShare = 0;          ///< Of the work that is done, 0 to 1, after what each method usually takes.
};

/** Designs a focus by paper and exact with each growth, and by free waveforms with each limit, all without the voltage
   limit, and looks at each in closed form. On all threads of the processor.
    @param playback  with a rate, for the free waveforms
    @param progress  called with all points so far after each design, from one thread at a time; may be empty. Who keeps
   them has them where the rest is cancelled.
    @param contrast  what skin feels of each design; none: not wanted
    @throws InputError  as designFocus, where not even the first design can be made; Cancelled as checkWatch()
    [worker] Docs/Theory.md, section 4.10. */
Tradeoff sweepTradeoff (const ModalModel&, const FocusDescription&, Playback,
                        const std::function<void (const Tradeoff&)>& progress = {},
                        const FindFeltContrast& contrast = {});

/** How long before the focus the norm of all modal velocities is above half of what it is at the focus. The voltages
   are taken as constant over a tenth of the period of the fastest mode listed. s [worker] Docs/Theory.md, section 4.10.
 */
double timeInMotion (const ModalModel&, const VoltageProgram&, const std::vector<int>& modes);
} // namespace antinode
