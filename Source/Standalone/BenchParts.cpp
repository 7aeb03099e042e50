#include "BenchPanel.h"

#include <Editor/EditorLook.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_reports/Lettering.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
constexpr int wireNameWidth = 30, wireButtonWidth = 62, wireFieldWidth = 56, wireGap = 4;
constexpr float aimRadius = 9, pointRadius = 4; // pixels
} // namespace

BenchSurface::BenchSurface()
    : SurfaceView ("The surface with the points that are measured", "The cross: where the sensor is to be aimed", false)
{
}

void BenchSurface::show (const BenchState& state)
{
    const auto isAimed = state.step == BenchStep::aiming || state.step == BenchStep::playing;
    points = state.points;
    measured = state.measured;
    findings = state.findings;
    aim = isAimed ? state.point : -1;
    setPicture (state.picture);
}

juce::Point<float> BenchSurface::pixelsOf (double x, double y) const
{
    return plot().at (x * milli, isLine() ? 0 : y * milli);
}

void BenchSurface::paintOnTop (juce::Graphics& g)
{
    const auto& palette = EditorLook::findPalette (*this);

    for (const auto& found : findings)
    {
        const auto& ceramic = model().ceramics[static_cast<std::size_t> (found.output)];
        const auto area = juce::Rectangle<float> (pixelsOf (ceramic.xMinimum, ceramic.yMaximum),
                                                  pixelsOf (ceramic.xMaximum, ceramic.yMinimum));
        g.setColour (palette.warning);
        g.drawRect (area.expanded (1, isLine() ? aimRadius : 1), 2);
    }

    for (Eigen::Index p = 0; p < points.rows(); ++p)
    {
        const auto at = pixelsOf (points (p, 0), points (p, 1));

        if (p == aim)
            paintAim (g, at, palette);

        const auto dot = juce::Rectangle<float> (2 * pointRadius, 2 * pointRadius).withCentre (at);
        g.setColour (p == aim ? palette.fire : palette.text);

        if (measured[static_cast<std::size_t> (p)])
            g.fillEllipse (dot);
        else
            g.drawEllipse (dot, 1.5F);

        drawText (g, std::to_string (p + 1), dot.translated (2 * pointRadius + 3, -pointRadius - 2).expanded (6, 4),
                  juce::Justification::centred, { EditorLook::smallTextHeight, p == aim, palette.text });
    }
}

/** Lines to the edges, from which the place is measured. */
void BenchSurface::paintAim (juce::Graphics& g, juce::Point<float> at, const Palette& palette) const
{
    const auto area = plot().plot;
    g.setColour (palette.fire.withAlpha (0.6F));
    const float dashes[] = { 4, 4 };
    g.drawDashedLine ({ area.getX(), at.y, area.getRight(), at.y }, dashes, 2);
    g.drawDashedLine ({ at.x, area.getY(), at.x, area.getBottom() }, dashes, 2);
    g.setColour (palette.fire);
    g.drawEllipse (juce::Rectangle<float> (2 * aimRadius, 2 * aimRadius).withCentre (at), 2);
    g.drawLine ({ at.x - 2 * aimRadius, at.y, at.x + 2 * aimRadius, at.y }, 1.5F);
    g.drawLine ({ at.x, at.y - 2 * aimRadius, at.x, at.y + 2 * aimRadius }, 1.5F);
}

juce::String aimInWords (const Surface& surface, const Eigen::Vector2d& place)
{
    const auto words = [] (double metres) { return juce::String (fixedText (milli * metres, 1)) + " mm"; };
    const auto x = words (place.x() - surface.xMinimum) + " from the left edge";
    return surface.kind == SurfaceKind::line ? x + ", in the middle"
                                             : x + ", " + words (place.y() - surface.yMinimum) + " from the lower edge";
}

juce::String capacitanceInWords (double expected, double read)
{
    constexpr double tolerance = 0.2, factor = 2;
    const auto ratio = read / expected;
    const auto isNear = [&] (double wanted) { return std::abs (ratio / wanted - 1) <= tolerance; };

    if (isNear (1))
        return "as drawn";

    if (isNear (factor))
        return "double: wired in parallel?";

    if (isNear (1 / factor))
        return "half: wired in series?";

    return ratio < 1 / factor ? "broken wire or ceramic?" : "another ceramic or wiring?";
}

WireRow::WireRow (std::size_t ceramicToShow) : ceramic (ceramicToShow)
{
    name.setText (juce::String (static_cast<int> (ceramic) + 1), juce::dontSendNotification);
    identify.setTooltip ("Plays soft bursts on this ceramic only. Works only while armed, on the bench");
    identify.setMouseClickGrabsKeyboardFocus (false);
    identify.onClick = [this]
    {
        if (onIdentify)
            onIdentify();
    };
    capacitance.setTooltip ("What a multimeter reads at the wires of this ceramic, nF; in grey what the drawing says");
    tone.setTooltip ("What a scope reads at the amplifier while Identify plays, V peak; in grey what it should be. "
                     "Another reading sets the volts at full scale of this output (Settings, Routing)");
    capacitance.onReturnKey = capacitance.onFocusLost = [this] { readCapacitance(); };
    tone.onReturnKey = tone.onFocusLost = [this] { readTone(); };

    for (auto* const editor : { &capacitance, &tone })
    {
        editor->setInputRestrictions (8, "0123456789.,nFV ");
        editor->setFont (EditorLook::font (EditorLook::smallTextHeight));
        editor->setJustification (juce::Justification::centredLeft);
        editor->setEscapeAndReturnKeysConsumed (false);
        addAndMakeVisible (editor);
    }

    for (auto* const label : { &name, &words })
    {
        label->setFont (EditorLook::font (EditorLook::smallTextHeight));
        addAndMakeVisible (label);
    }

    words.setMinimumHorizontalScale (0.7F);
    addAndMakeVisible (identify);
}

void WireRow::show (const BenchState& state, bool canIdentify, bool canRead, bool identifies)
{
    tone.setEnabled (canRead);
    const auto& palette = EditorLook::findPalette (*this);
    expectedCapacitance = state.picture->model->ceramics[ceramic].capacitance;
    expectedTone = ceramic < state.toneVolts.size() ? state.toneVolts[ceramic] : 0;
    capacitance.setTextToShowWhenEmpty (
        expectedCapacitance > 0 ? juce::String (fixedText (expectedCapacitance * nano, 1)) : juce::String ("?"),
        palette.mutedText);
    tone.setTextToShowWhenEmpty (juce::String (fixedText (expectedTone, 2)), palette.mutedText);
    identify.setEnabled (canIdentify);
    identify.setToggleState (identifies, juce::dontSendNotification);
    const auto answer = answerInWords (state);
    words.setText (answer.isEmpty() || ofMeter.isEmpty() ? answer + ofMeter : ofMeter + "; " + answer,
                   juce::dontSendNotification);
    const auto isWrong =
        std::any_of (state.findings.begin(), state.findings.end(),
                     [this] (const auto& found) { return found.output == static_cast<Eigen::Index> (ceramic); });
    words.setColour (juce::Label::textColourId, isWrong ? palette.warning : palette.text);
    words.setTooltip (words.getText());
}

/** Against the median of all: the level alone says little, what differs says much. */
juce::String WireRow::answerInWords (const BenchState& state) const
{
    const auto index = static_cast<Eigen::Index> (ceramic);

    if (state.answers.size() <= index)
        return {};

    for (const auto& found : state.findings)
        if (found.output == index)
            switch (found.kind)
            {
                case WireFinding::Kind::dead:
                    return "dead";
                case WireFinding::Kind::reversed:
                    return "reversed";
                case WireFinding::Kind::exchanged:
                    return "is ceramic " + juce::String (static_cast<int> (found.ceramic) + 1);
                case WireFinding::Kind::foreign:
                    return "is no ceramic of the drawing";
            }

    return "answers, " + juce::String (fixedText (milli * state.answers[index], 3)) + " mm/s per V";
}

void WireRow::enterCapacitance (const juce::String& text)
{
    capacitance.setText (text, false);
    readCapacitance();
}

void WireRow::enterTone (const juce::String& text)
{
    tone.setText (text, false);
    readTone();
}

void WireRow::readCapacitance()
{
    const auto read = typedNumber (capacitance.getText().trim().toStdString(), { "nF" }).value_or (0) / nano;
    ofMeter = read > 0 && expectedCapacitance > 0 ? capacitanceInWords (expectedCapacitance, read) : juce::String();
}

/** A gain that is far off is a mistake of the reading or of the wiring, not a gain. */
void WireRow::readTone()
{
    constexpr double furthest = 10, sameWithin = 0.005;
    const auto read = typedNumber (tone.getText().trim().toStdString(), { "V" }).value_or (0);
    const auto ratio = expectedTone > 0 ? read / expectedTone : 0;

    if (ratio > 1 / furthest && ratio < furthest && std::abs (ratio - 1) > sameWithin && onTone)
        onTone (ratio);

    tone.clear(); // It is as it should be from now on.
}

void WireRow::paintHeadings (juce::Graphics& g, juce::Rectangle<int> area)
{
    g.setFont (EditorLook::font (EditorLook::smallTextHeight));
    const auto write = [&] (const char* text, int width)
    { g.drawText (text, area.removeFromLeft (width + wireGap), juce::Justification::centredLeft); };
    write ("C", wireNameWidth);
    write ("", wireButtonWidth);
    write ("nF", wireFieldWidth);
    write ("V peak", wireFieldWidth);
    g.drawText ("Wire", area, juce::Justification::centredLeft);
}

void WireRow::lookAndFeelChanged()
{
    for (auto* const editor : { &capacitance, &tone })
        editor->applyColourToAllText (EditorLook::findPalette (*this).text);
}

void WireRow::resized()
{
    auto area = getLocalBounds().withTrimmedBottom (2);
    const auto take = [&] (int width)
    {
        const auto taken = area.removeFromLeft (width);
        area.removeFromLeft (wireGap);
        return taken;
    };
    name.setBounds (take (wireNameWidth));
    identify.setBounds (take (wireButtonWidth));
    capacitance.setBounds (take (wireFieldWidth));
    tone.setBounds (take (wireFieldWidth));
    words.setBounds (area);
}
} // namespace antinode
