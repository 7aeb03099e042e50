#include "FocusOutcome.h"

#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_focus/EventPeak.h>
#include <antinode_focus/Projection.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace antinode
{
namespace
{
constexpr double fine = 0.02; // an error that nobody needs to do anything about

std::string percent (double share)
{
    return fixedText (100 * share, 1) + " %";
}

std::string inMillimetres (double metres)
{
    return fixedText (metres * milli, 1) + " mm";
}

TargetOutcome targetOutcome (const ModalModel& model, const ReachedMoment& reached, const Target& target, double time)
{
    const auto& velocities = reached.modalVelocities;
    TargetOutcome outcome;
    outcome.wanted = target;
    outcome.time = time;
    outcome.peak = peakOfTarget (model, velocities, target);
    outcome.velocityAtCentre = shapesAt (model, target.x, target.y).dot (velocities);

    // Where nothing of the target's sign is reached, there is no width either.
    if (! (outcome.peak.velocity * target.phase > 0))
        return outcome;

    outcome.width = widthAtHalf (model, velocities, outcome.peak, false);

    if (model.surface.kind == SurfaceKind::plate)
        outcome.widthY = widthAtHalf (model, velocities, outcome.peak, true);

    return outcome;
}

/** What limits the field most: what is clipped, else what the transients leave, else what the modes lack. */
std::string limitInWords (const RenderedFocus& focus)
{
    const auto& design = focus.design;
    const auto& clipped = focus.render.limitedSamples;

    if (std::any_of (clipped.begin(), clipped.end(), [] (auto samples) { return samples > 0; }))
        return "Volts limit the field: the limiter clips "
               + std::to_string (std::accumulate (clipped.begin(), clipped.end(), std::int64_t { 0 }))
               + " samples. Lower focus.targets.0.peak_velocity_mm_s, or set focus.allocation.method to exact.";

    // The worst moment of a train speaks for all.
    std::size_t worst = 0;
    const auto transient = [&] (std::size_t i) { return focus.moments[i].truncatedScore.fieldError; };
    const auto missing = [&] (std::size_t i) { return std::sqrt (1 - std::pow (design.moments[i].captured, 2)); };

    for (std::size_t i = 1; i < focus.moments.size(); ++i)
        if (std::hypot (transient (i), missing (i)) > std::hypot (transient (worst), missing (worst)))
            worst = i;

    if (std::max (transient (worst), missing (worst)) < fine)
        return "Nothing limits the field by more than " + inWords (100 * fine) + " %.";

    const auto lifts = [] (const auto& contact) { return contact.lifts > 0; };

    if (transient (worst) > missing (worst) && std::any_of (focus.contacts.begin(), focus.contacts.end(), lifts))
        return "Fingers that lift off limit the field: it is " + percent (transient (worst))
               + " off the field that the controlled modes represent. The design assumes fingers that stay.";

    if (transient (worst) > missing (worst) && ! design.description.fingers.empty())
        return "Fingers limit the field: it is " + percent (transient (worst))
               + " off the field that the controlled modes represent. Include them in the design (focus.fingers, "
                 "known), or use the allocation 'exact'.";

    if (transient (worst) > missing (worst))
        return transientInWords (design, design.moments[worst], focus.moments[worst].modalVelocities,
                                 transient (worst));

    return lossInWords (focus.known, design, design.moments[worst]);
}

std::string row (const std::string& name, const std::string& wanted, const std::string& reached)
{
    return formatted ("  %-14s %-18s %s\n", name.c_str(), wanted.c_str(), reached.c_str());
}

std::string widthInWords (const std::optional<double>& width)
{
    return width ? inMillimetres (*width) : std::string ("to the edge");
}

std::string targetToText (const RenderedFocus& focus, const TargetOutcome& outcome)
{
    const auto& surface = focus.model.surface;
    const auto& wanted = outcome.wanted;
    const auto velocity = wanted.phase * wanted.peakVelocity;
    auto text = row ("place", placeInWords (surface, wanted.x, wanted.y),
                     placeInWords (surface, outcome.peak.x, outcome.peak.y));
    text += row ("peak velocity", inWords (velocity * milli) + " mm/s",
                 inWords (outcome.peak.velocity * milli) + " mm/s (" + percent (outcome.peak.velocity / velocity)
                     + "; at the wanted place " + inWords (outcome.velocityAtCentre * milli) + " mm/s)");

    if (surface.kind == SurfaceKind::line)
        return text + row ("width", inMillimetres (wanted.width), widthInWords (outcome.width));

    return text
           + row ("width", inMillimetres (wanted.width) + " x " + inMillimetres (wanted.widthY.value_or (wanted.width)),
                  widthInWords (outcome.width) + " x " + widthInWords (outcome.widthY));
}
} // namespace

FocusOutcome evaluateOutcome (const RenderedFocus& focus)
{
    FocusOutcome outcome;
    const auto& model = focus.model;
    std::vector<Target> all;

    for (std::size_t i = 0; i < focus.moments.size(); ++i)
        for (const auto& target : focus.design.moments[i].targets)
        {
            all.push_back (target);
            outcome.targets.push_back (
                targetOutcome (model, focus.moments[i], target,
                               static_cast<double> (focus.moments[i].sample) / focus.render.sampleRate));
        }

    const auto& first = focus.moments.front();
    const auto& targets = focus.design.moments.front().targets;
    const auto& window = focus.design.description.edgeWindow;
    const auto wanted = largestWanted (model.surface, targets, window);
    outcome.sideLobe = largestVelocity (model, first.modalVelocities, focalSpots (targets));
    outcome.wantedSideLobe =
        std::abs (largestWanted (model.surface, targets, window, focalSpots (targets)).velocity / wanted.velocity);
    outcome.elsewhere = largestInEvent (model, { focus.render.modalVelocities, focus.render.sampleRate },
                                        focalSpots (all), 0, focus.render.modalVelocities.cols() - 1);

    if (outcome.elsewhere.velocity != 0)
        outcome.eventContrast = std::abs (first.peak.velocity / outcome.elsewhere.velocity);

    outcome.limit = limitInWords (focus);
    outcome.expected = expectedError (focus.known, focus.design);
    return outcome;
}

std::string placeInWords (const Surface& surface, double x, double y)
{
    return surface.kind == SurfaceKind::line ? inMillimetres (x) : fixedText (x * milli, 1) + ", " + inMillimetres (y);
}

std::string sideLobeInWords (const RenderedFocus& focus, const FocusOutcome& outcome)
{
    const auto& lobe = outcome.sideLobe;

    if (lobe.velocity == 0)
        return "none: the focal spot covers the surface";

    return percent (std::abs (lobe.velocity / focus.moments.front().peak.velocity)) + " of the peak, at "
           + placeInWords (focus.model.surface, lobe.x, lobe.y);
}

std::string elsewhereInWords (const RenderedFocus& focus, const FocusOutcome& outcome)
{
    const auto& elsewhere = outcome.elsewhere;

    if (elsewhere.velocity == 0)
        return "none: the focal spot covers the surface";

    const auto fromFocus =
        elsewhere.time - static_cast<double> (focus.moments.front().sample) / focus.render.sampleRate;
    return percent (std::abs (elsewhere.velocity / focus.moments.front().peak.velocity)) + " of the peak, at "
           + placeInWords (focus.model.surface, elsewhere.x, elsewhere.y) + ", "
           + inWords (std::abs (fromFocus) * milli) + " ms " + (fromFocus < 0 ? "before" : "after") + " the focus";
}

std::string outcomeToText (const RenderedFocus& focus, const FocusOutcome& outcome)
{
    auto text = row ("", "wanted", "reached");

    for (const auto& target : outcome.targets)
    {
        if (outcome.targets.size() > 1)
            text += "  focus at " + inWords (target.time * milli) + " ms\n";

        text += targetToText (focus, target);
    }

    text += row ("side lobe", percent (outcome.wantedSideLobe), sideLobeInWords (focus, outcome));
    text += row ("elsewhere", "", elsewhereInWords (focus, outcome));
    text += row ("contrast", "",
                 inWords (outcome.eventContrast) + " over the whole event, against the largest elsewhere; "
                     + inWords (focus.contrast) + " at the focus, against the RMS elsewhere");

    if (focus.felt)
        text += row ("felt", "", feltInWords (focus.model.surface, *focus.felt));

    text += row ("peak voltage", inWords (focus.design.program.voltageLimits.maxCoeff()) + " V at most",
                 inWords (focus.render.voltages.cwiseAbs().maxCoeff()) + " V");

    if (focus.undone)
        text += row ("lags of ceramics", "", lagsInWords (*focus.undone));

    return text + "  " + outcome.limit + "\n";
}

namespace
{
constexpr double percentOfOne = 100;

std::int64_t limitedSamples (const UndoneLags& undone)
{
    return std::accumulate (undone.limited.begin(), undone.limited.end(), std::int64_t { 0 });
}
} // namespace

std::string lagsInWords (const UndoneLags& undone)
{
    auto text = "undone to " + inWords (percentOfOne * undone.misfit) + " %; all is " + std::to_string (undone.lateness)
                + " samples later";

    if (const auto limited = limitedSamples (undone); limited > 0)
        text +=
            "; " + std::to_string (limited)
            + " samples are beyond limits of voltage or slew rate and are cut: lower the voltage limit of the design";

    return text;
}

nlohmann::ordered_json lagJson (const UndoneLags& undone)
{
    return { { "late_samples", undone.lateness },
             { "misfit_percent", percentOfOne * undone.misfit },
             { "peak_voltage_V", undone.voltages.cwiseAbs().maxCoeff() },
             { "limited_samples", undone.limited } };
}
} // namespace antinode
