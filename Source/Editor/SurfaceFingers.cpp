#include "SurfaceFingers.h"

#include "JuceText.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Prefixes.h>
#include <antinode_reports/Lettering.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace antinode
{
namespace
{
constexpr float smallestRadius = 10; // pixels: what can be hit

float shownRadius (const Finger& finger, const PlotFrame& plot)
{
    return std::max (smallestRadius, plot.xAt (finger.radius * milli) - plot.xAt (0));
}

bool isAmong (const std::vector<Finger>& fingers, const Finger& wanted)
{
    return std::find (fingers.begin(), fingers.end(), wanted) != fingers.end();
}
} // namespace

SurfaceFingers::SurfaceFingers (AntinodeProcessor& processorToChange, History& historyToWrite)
    : processor (processorToChange), history (historyToWrite)
{
}

bool SurfaceFingers::refresh()
{
    auto loaded = processor.focus();

    if (dragged || loaded == shown)
        return false;

    shown = std::move (loaded);
    return std::exchange (fingers, shown->description.fingers) != fingers;
}

Surface SurfaceFingers::surface() const
{
    return deviceExtent (processor.device()->description);
}

juce::Point<float> SurfaceFingers::middle (std::size_t finger, const PlotFrame& plot) const
{
    const auto& each = fingers[finger];
    return plot.at (each.x * milli, surface().kind == SurfaceKind::line ? 0 : each.y * milli);
}

std::optional<std::size_t> SurfaceFingers::at (juce::Point<float> place, const PlotFrame& plot) const
{
    std::optional<std::size_t> nearest;
    auto least = 0.0f;

    for (std::size_t i = 0; i < fingers.size(); ++i)
    {
        const auto distance = place.getDistanceFrom (middle (i, plot));

        if (distance <= shownRadius (fingers[i], plot) && (! nearest || distance < least))
        {
            nearest = i;
            least = distance;
        }
    }

    return nearest;
}

void SurfaceFingers::apply (std::vector<Finger> wanted)
{
    juce::String refusal;

    // A touch may have left since it was shown, as while another finger was dragged.
    if (const auto now = processor.focus(); shown != nullptr)
        std::erase_if (
            wanted, [&] (const auto& finger)
            { return isAmong (shown->description.fingers, finger) && ! isAmong (now->description.fingers, finger); });

    try
    {
        validate (wanted, surface());
        history.record ([&] { processor.setFingers (wanted); });
    }
    catch (const InputError& failure)
    {
        refusal = fromUtf8 (failure.what());
    }

    if (say)
        say (refusal);

    shown = nullptr;
    refresh();
}

/** A menu may speak of a finger that is not there any more. */
void SurfaceFingers::change (std::size_t finger, const std::function<void (Finger&)>& edit)
{
    if (finger >= fingers.size())
        return;

    auto wanted = fingers;
    edit (wanted[finger]);
    apply (std::move (wanted));
}

void SurfaceFingers::rest (const std::string& kind, double x, double y)
{
    auto wanted = fingers;
    wanted.push_back (builtInFinger (kind, x, surface().kind == SurfaceKind::line ? 0 : y));
    apply (std::move (wanted));
}

void SurfaceFingers::lift (std::size_t finger)
{
    if (finger >= fingers.size())
        return;

    auto wanted = fingers;
    wanted.erase (wanted.begin() + static_cast<std::ptrdiff_t> (finger));
    apply (std::move (wanted));
}

void SurfaceFingers::liftAll()
{
    apply ({});
}

void SurfaceFingers::setKind (std::size_t finger, const std::string& kind)
{
    change (finger,
            [&] (Finger& each)
            {
                const auto isKnown = each.isKnown;
                each = builtInFinger (kind, each.x, each.y);
                each.isKnown = isKnown;
            });
}

void SurfaceFingers::setKnown (std::size_t finger, bool isKnown)
{
    change (finger, [isKnown] (Finger& each) { each.isKnown = isKnown; });
}

void SurfaceFingers::drag (std::size_t finger, double x, double y)
{
    dragged = finger;
    fingers[finger].x = x;
    fingers[finger].y = y;
}

void SurfaceFingers::drop()
{
    const auto finger = std::exchange (dragged, std::nullopt);

    if (! finger)
        return;

    if (liesOn (surface(), fingers[*finger].x, fingers[*finger].y))
        apply (fingers);
    else
        lift (*finger);
}

void SurfaceFingers::paint (juce::Graphics& g, const PlotFrame& plot, const Palette& palette) const
{
    const auto extent = surface();

    for (std::size_t i = 0; i < fingers.size(); ++i)
    {
        const auto& finger = fingers[i];
        const auto radius = shownRadius (finger, plot);
        const auto disc = juce::Rectangle<float> (2 * radius, 2 * radius).withCentre (middle (i, plot));
        g.setColour (palette.window.withAlpha (liesOn (extent, finger.x, finger.y) ? 0.35f : 0.1f));
        g.fillEllipse (disc);
        g.setColour (palette.text.withAlpha (finger.isKnown ? 0.9f : 0.5f));
        g.drawEllipse (disc, finger.isKnown ? 2.0f : 1.0f);
        drawText (g, finger.isKnown ? finger.name : finger.name + ", unknown",
                  disc.withSizeKeepingCentre (120, 14).withY (disc.getBottom() + 1), juce::Justification::centred,
                  { 11, false, palette.text });
    }
}
} // namespace antinode
