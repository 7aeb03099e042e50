#pragma once

#include "RenderedFocus.h"

#include <antinode_focus/SpillOver.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace antinode
{
/** A focus with one weight of the felt level elsewhere, as the plate model played it. */
struct FeltTradeoffPoint
{
    double weight = 0;
    double peakVoltage = 0;           ///< V
    double fieldError = 0;            ///< Against what the controlled modes represent.
    double target = 0;                ///< dB over threshold, of the weakest one.
    std::optional<double> elsewhere;  ///< dB, the largest farther than feltNeighbourhood from all targets.
    std::optional<double> bystanders; ///< dB, the largest at the fingers and at the places of the focus.
    std::string failure;              ///< Why there is no design; empty if there is one.
};

/** Voltage and felt contrast of one focus by the weight of the felt level elsewhere. */
struct FeltTradeoff
{
    std::vector<FeltTradeoffPoint> points; ///< By weight, ascending.
    std::string threshold;                 ///< Its source.
    std::size_t planned = 0;               ///< How many points there are when all are designed.
};

/** Designs a focus with each weight, plays it on the wide model and looks at what is felt.
    @param focus     with `felt`
    @param options   with a threshold
    @param progress  called with all points so far after each; may be empty
    @throws InputError  as designWide, where not even the first design can be made; Cancelled as checkWatch()
    [worker] Docs/Theory.md, section 4.14. */
FeltTradeoff sweepFeltWeights (const WideModel&, const FocusDescription& focus, const RenderOptions& options,
                               const WidenModel&, const std::function<void (const FeltTradeoff&)>& progress = {});
} // namespace antinode
