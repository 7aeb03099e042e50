#pragma once

#include "RenderedFocus.h"

#include <antinode_engine/LagFilters.h>
#include <antinode_focus/Tolerance.h>

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace antinode
{
/** What became of one target: wanted against reached. */
struct TargetOutcome
{
    Target wanted;
    double time = 0;              ///< s from the trigger, of the focus sample.
    FieldPeak peak;               ///< Reached: the peak of the target's sign next to its centre.
    double velocityAtCentre = 0;  ///< Reached, m/s.
    std::optional<double> width;  ///< Full width at half maximum along x, m; none where the surface ends before.
    std::optional<double> widthY; ///< The same along y, of a plate.
};

/** What a user asked for and what the plate model reached. Docs/Theory.md, section 5. */
struct FocusOutcome
{
    std::vector<TargetOutcome> targets;    ///< By time.
    FieldPeak sideLobe;                    ///< The largest velocity outside the focal spots at the first focus.
    double wantedSideLobe = 0;             ///< The same of the wanted field, of its peak.
    FieldPeak elsewhere;                   ///< The largest outside the focal spots at any time.
    double eventContrast = 0;              ///< Peak at the first focus / elsewhere; 0 where nothing lies outside.
    std::string limit;                     ///< What limits the field, with the key to change.
    std::optional<ExpectedError> expected; ///< On the device itself; none for complex modes.
};

/** [worker] */
FocusOutcome evaluateOutcome (const RenderedFocus&);

/** Wanted against reached as lines of text of two columns, then what limits the field. [any] */
std::string outcomeToText (const RenderedFocus&, const FocusOutcome&);

/** A place in mm: "24 mm", on a plate "60, 88 mm". [any] */
std::string placeInWords (const Surface&, double x, double y);

/** The largest velocity outside the focal spots at the focus, as a share of the peak: "21.7 % of the peak at 54 mm".
    [any] */
std::string sideLobeInWords (const RenderedFocus&, const FocusOutcome&);

/** The same at any time, with the time from the focus. [any] */
std::string elsewhereInWords (const RenderedFocus&, const FocusOutcome&);

/** What undoing lags costs, in one line. [any] */
std::string lagsInWords (const UndoneLags&);

/** As summary.json has it. [any] Docs/FileFormats.md. */
nlohmann::ordered_json lagJson (const UndoneLags&);
} // namespace antinode
