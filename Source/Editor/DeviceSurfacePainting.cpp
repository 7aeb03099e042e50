#include "DeviceSurface.h"

#include "EditorLook.h"

#include <antinode_drafts/DeviceEdits.h>
#include <antinode_reports/Lettering.h>

#include <algorithm>

namespace antinode
{
namespace
{
constexpr float cornerSize = 8; // pixels

/** How an edge looks by what holds it: the firmer, the thicker; springs are dashed. */
void strokeEdge (juce::Graphics& g, const juce::Path& path, const nlohmann::json& support, bool isSelected,
                 const Palette& palette)
{
    const auto* const usual = usualSupport (support);
    const auto isSpring = support.is_object();
    const auto width = isSpring                                       ? 3.0f
                       : usual != nullptr && usual->name == "clamped" ? 5.0f
                       : usual != nullptr && usual->name == "free"    ? 1.2f
                                                                      : 3.0f;
    auto shown = path;

    if (isSpring)
    {
        constexpr float dashes[] = { 5, 3 };
        juce::PathStrokeType (width).createDashedStroke (shown, path, dashes, 2);
    }
    else
        juce::PathStrokeType (width).createStrokedPath (shown, path);

    g.setColour (isSelected ? palette.accent : palette.text.withAlpha (0.8f));
    g.fillPath (shown);
}
} // namespace

void DeviceSurface::paintOnTop (juce::Graphics& g)
{
    const auto& palette = EditorLook::findPalette (*this);

    if (draft.isDrawn())
    {
        paintBody (g, palette);
        paintCeramics (g, palette);
        paintPoints (g, palette);
        paintGuides (g, palette);
    }

    paintSpot (g, palette);
    paintFaults (g, palette);
}

void DeviceSurface::paintBody (juce::Graphics& g, const Palette& palette)
{
    const auto& shown = drawn();

    for (std::size_t i = 0; i < shown.edges.size(); ++i)
        strokeEdge (g, shown.edges[i], supportOf (draft.document(), shown.edgeNames[i]),
                    shown.edgeNames[i] == draft.edge, palette);
}

void DeviceSurface::paintCeramics (juce::Graphics& g, const Palette& palette)
{
    const auto& all = drawn().ceramics;
    const auto hasShares =
        picture != nullptr && picture->shares.size() == std::ssize (all) && picture->question.mode.has_value();

    for (std::size_t i = 0; i < all.size(); ++i)
    {
        const auto fault = std::find_if (draft.faults().begin(), draft.faults().end(),
                                         [i] (const auto& each) { return each.ceramic == i; });
        const auto isWrong = fault != draft.faults().end();
        const auto isSelected = draft.ceramics.count (i) > 0;
        const auto share = hasShares ? picture->shares[static_cast<Eigen::Index> (i)] : 0.0;
        const auto filled = hasShares ? palette.charts.diverging.at (0.5 + share / 2) : palette.raised;
        g.setColour (filled);
        g.fillPath (all[i]);
        g.setColour (isWrong      ? fault->isForbidden ? palette.warning : palette.caution
                     : isSelected ? palette.accent
                                  : palette.text.withAlpha (0.85f));
        g.strokePath (all[i], juce::PathStrokeType (isWrong || isSelected ? 2.4f : 1.0f));
        const auto area = all[i].getBounds();
        const TextStyle style { 10, false, filled.contrasting() };

        if (const auto number = std::to_string (i + 1); textWidth (number, style) < area.getWidth())
            drawText (g, number, area, juce::Justification::centred, style);
    }

    g.setColour (palette.accent);

    if (const auto corner = cornerOf (Handle::size))
        g.fillRect (juce::Rectangle<float> (cornerSize, cornerSize).withCentre (*corner));

    if (const auto corner = cornerOf (Handle::turn))
        g.fillEllipse (juce::Rectangle<float> (cornerSize, cornerSize).withCentre (*corner));
}

/** Each beside its ceramic, where it is, within the surface. */
void DeviceSurface::paintFaults (juce::Graphics& g, const Palette& palette)
{
    for (const auto& fault : draft.faults())
    {
        if (fault.ceramic >= drawn().ceramics.size())
            continue;

        const TextStyle style { 12, false, fault.isForbidden ? palette.warning : palette.caution };
        const auto ceramic = drawn().ceramics[fault.ceramic].getBounds();
        const auto box = juce::Rectangle<float> (textWidth (fault.sentence, style) + 12, 18)
                             .withCentre ({ ceramic.getCentreX(), ceramic.getY() - 13 })
                             .constrainedWithin (getLocalBounds().toFloat().reduced (2));
        g.setColour (palette.panel.withAlpha (0.92f));
        g.fillRoundedRectangle (box, 4);
        drawText (g, fault.sentence, box, juce::Justification::centred, style);
    }
}

void DeviceSurface::paintPoints (juce::Graphics& g, const Palette& palette)
{
    const auto points = pointsOf (draft.document());
    const auto& places = drawn().points;

    for (std::size_t i = 0; i < std::min (points.size(), places.size()); ++i)
    {
        const auto at = places[i];
        juce::Path sign;

        if (points[i].mass > 0)
            sign.addEllipse (juce::Rectangle<float> (12, 12).withCentre (at));
        else
            sign.addTriangle (at.translated (-7, 6), at.translated (7, 6), at.translated (0, -7));

        g.setColour (palette.panel);
        g.strokePath (sign, juce::PathStrokeType (4));
        g.setColour (draft.point == i ? palette.accent : palette.text);
        g.fillPath (sign);
    }
}

void DeviceSurface::paintGuides (juce::Graphics& g, const Palette& palette)
{
    const auto area = plot().plot;
    g.setColour (palette.accent.withAlpha (0.8f));

    if (guides.x)
        g.fillRect (
            juce::Rectangle<float> (1, area.getHeight()).withCentre ({ plot().xAt (*guides.x), area.getCentreY() }));

    if (guides.y)
        g.fillRect (
            juce::Rectangle<float> (area.getWidth(), 1).withCentre ({ area.getCentreX(), plot().yAt (*guides.y) }));
}

void DeviceSurface::paintSpot (juce::Graphics& g, const Palette& palette) const
{
    const auto ring = juce::Rectangle<float> (15, 15).withCentre (spot());
    g.setColour (palette.window.withAlpha (0.85f));
    g.drawEllipse (ring, 4.5f);
    g.setColour (palette.fire);
    g.drawEllipse (ring, 2.5f);
    g.fillEllipse (ring.withSizeKeepingCentre (4, 4));
}
} // namespace antinode
