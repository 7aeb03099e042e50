#pragma once

#include "Detuning.h"
#include "FocusDesign.h"
#include "FocusScore.h"

#include <antinode_model/ModalModel.h>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace antinode
{
/** The property of a device that deviates. */
enum class ToleranceKind
{
    frequency,
    damping,
    participation,
    drift
};

/** One deviating property, all others being nominal. */
struct ToleranceCause
{
    std::optional<int> mode; ///< None: all of them, of a drift.
    ToleranceKind kind = ToleranceKind::frequency;
    double fieldError = 0; ///< RMS over the errors of the RMS change of the field / RMS of the wanted field.
};

/** The effect of the spread of each mode's frequency, damping and participations alone on the field at the focus, and
   of a drift of all frequencies; controlled modes and others, the worst first. Those without a spread are left out.
   Reference is the truncated field. [worker] Docs/Theory.md, section 7.4. */
std::vector<ToleranceCause> toleranceCauses (const ModalModel&, const FocusDesign&, const DetuningSpread&);

/** "Mode 7 (6120 Hz): its frequency alone changes the field by 0.8 %." [any] */
std::string causeSentence (const ToleranceCause&, const ModalModel&);

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

/** One of several designs that are compared on the same devices. */
struct DesignTolerance
{
    std::string name;       ///< "nominal" or "robust".
    double peakVoltage = 0; ///< V
    Tolerance tolerance;
};

/** The field error that is to be expected on the device itself, RMS over RMS of what the controlled modes represent. */
struct ExpectedError
{
    double median = 0;
    double high = 0;      ///< One of ten devices has more.
    std::string sentence; ///< Both, why, and what brings them down.
};

/** How far devices usually are from modes of such an origin. [any] Docs/Theory.md, section 7.4. */
DetuningSpread spreadOf (const ModeOrigin&);

/** By few draws of devices around the model, and by what its origin says of shapes: a design is as good as the modes
    that it knows. None for complex modes. [worker] Docs/Theory.md, section 7.4. */
std::optional<ExpectedError> expectedError (const ModalModel&, const FocusDesign&);

/** A device that the model may stand for, at points: detuned as its origin says, and each mode larger or smaller by
   what shapes are usually off at a point, drawn or between measured ones.
    @param number  the same gives the same device
    [worker] Docs/Theory.md, section 7.4. */
ModalModel likelyDevice (const ModalModel&, std::uint64_t number);
} // namespace antinode
