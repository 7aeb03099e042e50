#pragma once

#include "DetuningSpread.h"
#include "FieldPeak.h"
#include "FocusDesign.h"
#include "FocusScore.h"
#include "ToleranceCauses.h"

#include <antinode_model/ModalModel.h>

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace antinode
{
/** The devices to draw: their spread and number. */
struct ToleranceOptions
{
    DetuningSpread spread = usualSpread;
    int draws = 200; ///< 1 or more.
    std::uint64_t seed = 1;
};

/** The reported percentiles, %. */
inline constexpr std::array<double, 5> tolerancePercents { 5, 25, 50, 75, 95 };

/** A value at each of tolerancePercents. */
using Percentiles = std::array<double, tolerancePercents.size()>;

/** The tolerance of a design to devices that differ from the model. Fields are compared with what the controlled modes
    represent. */
struct Tolerance
{
    ToleranceOptions options;
    FocusScore known;                   ///< On the nominal device.
    std::vector<FocusScore> draws;      ///< On each device drawn.
    Percentiles vScore {};              ///< Over the draws.
    Percentiles fieldError {};          ///< Over the draws.
    Percentiles peakRatio {};           ///< Over the draws.
    std::vector<ToleranceCause> causes; ///< Causes of error, the largest first.
};

/** The field of a design at the focus, in closed form, on devices drawn around the model: a draw depends on its number
   alone, and the same options draw the same devices for every design, so that designs can be compared.
   Docs/Theory.md, section 7.4. */
class ToleranceStudy
{
public:
    /** Model and design live as long as the study. @throws InputError  for complex modes [worker] */
    ToleranceStudy (const ModalModel&, const FocusDesign&, const ToleranceOptions&);

    /** The score on one device. @param number  below options.draws [worker, several at once] */
    FocusScore draw (std::size_t number) const;

    /** What all draws say together. @param draws  in the order of their numbers, not empty [worker] */
    Tolerance summary (std::vector<FocusScore> draws) const;

private:
    FocusScore scoreOn (const ModalModel&) const;

    const ModalModel& model;
    const FocusDesign& design;
    ToleranceOptions options;
    ModalModel modes; ///< Of the model, without shapes.
    FieldPeak wantedPeak;
};

/** All draws and what they say. The result does not depend on the number of threads, which is that of the machine.
    @param progress  0 to 1, from any thread, one at a time
    [worker] */
Tolerance evaluateTolerance (const ModalModel&, const FocusDesign&, const ToleranceOptions&,
                             const std::function<void (double)>& progress);

/** Percentiles by linear interpolation between the ordered values, the least at 0 and the largest at 100 %.
    @param values  not empty
    [any] */
Percentiles computePercentiles (std::vector<double> values);
} // namespace antinode
