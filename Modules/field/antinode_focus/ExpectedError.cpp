#include "ExpectedError.h"

#include "Detuning.h"
#include "Tolerance.h"

#include <antinode_base/NumberText.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
// What drawings, and shapes of drawings, were off plates of solid elements by. Docs/Theory.md, section 7.4.
constexpr DetuningSpread drawnSpread { 0.0015, 0.1, 0.04, 0.0015 };
constexpr DetuningSpread measuredSpread { 1e-5, 0.001, 0, 0 };
constexpr double drawnShapes = 0.04;
constexpr double shapesAtPoints = 0.04; // Of drawings, and between measured points.
constexpr int usualPoints = 6;

/** How far shapes and participations together are off, of the field. */
double shapeError (const ModeOrigin& origin)
{
    switch (origin.source)
    {
        case ModeSource::given:
            return 0;
        case ModeSource::drawn:
            return drawnShapes;
        case ModeSource::measured:
            return origin.unexplained;
        case ModeSource::retuned:
            break;
    }

    // One point gives no shapes.
    return origin.points < 2 ? drawnShapes : origin.unexplained;
}

std::string inPercent (double share)
{
    return inWords (std::round (1000 * share) / 10);
}

std::string rangeInWords (const ExpectedError& expected)
{
    const auto median = inPercent (expected.median), high = inPercent (expected.high);
    return median + (high == median ? "" : " to " + high) + " %";
}

ExpectedError errorOf (const ModalModel& model, const FocusDesign& design, const ModeOrigin& origin)
{
    constexpr int draws = 20;
    constexpr double most = 0.9;
    const ToleranceStudy study (model, design, { spreadOf (origin), draws, 1 });
    std::vector<double> errors;

    for (std::size_t i = 0; i < draws; ++i)
        errors.push_back (std::hypot (study.draw (i).fieldError, shapeError (origin)));

    std::sort (errors.begin(), errors.end());
    return { errors[draws / 2], errors[static_cast<std::size_t> (most * draws)], {} };
}

/** Where the modes come from, and what makes them better. */
std::string originInWords (const ModalModel& model, const FocusDesign& design)
{
    const auto& origin = model.origin;
    const auto points = std::to_string (origin.points) + " points";

    switch (origin.source)
    {
        case ModeSource::given:
            return "the device does not record how its modes were found";
        case ModeSource::measured:
            return "measured at " + points;
        case ModeSource::retuned:
            return "drawn, retuned at " + points + "; 'antinode identify' measures shapes, too";
        case ModeSource::drawn:
            break;
    }

    const auto retuned = errorOf (model, design, { ModeSource::retuned, usualPoints, drawnShapes, true });
    return "drawn, with materials as stated, not measured; 'antinode retune' with " + std::to_string (usualPoints)
           + " measured points brings " + rangeInWords (retuned);
}
} // namespace

DetuningSpread spreadOf (const ModeOrigin& origin)
{
    switch (origin.source)
    {
        case ModeSource::drawn:
            return drawnSpread;
        case ModeSource::retuned:
        case ModeSource::measured:
            return measuredSpread;
        case ModeSource::given:
            break;
    }

    return usualSpread;
}

std::optional<ExpectedError> expectedError (const ModalModel& model, const FocusDesign& design)
{
    if (model.hasComplexModes())
        return {};

    auto expected = errorOf (model, design, model.origin);
    expected.sentence = "expect " + rangeInWords (expected) + " (" + originInWords (model, design) + ")";
    return expected;
}

ModalModel likelyDevice (const ModalModel& model, std::uint64_t number)
{
    auto device = detuned (model, spreadOf (model.origin), drawSeed (1, number));
    // A factor of each mode: that of a damping ratio which nothing uses.
    const auto factors = detuned (withoutShapes (model), { 0, shapesAtPoints, 0, 0 }, drawSeed (2, number));

    for (Eigen::Index c = 0; c < device.coordinates(); ++c)
    {
        const auto k = c % device.modes();
        device.participation.row (c) *= factors.dampingRatios[k] / model.dampingRatios[k];
    }

    return device;
}
} // namespace antinode
