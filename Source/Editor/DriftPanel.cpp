#include "DriftPanel.h"

#include "EditorLook.h"

#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_session/UserMessages.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace antinode
{
namespace
{
constexpr double percent = 100, secondsInMinute = 60, fewMinutes = 3;

constexpr int driftMargin = 8, driftRow = 24, driftGap = 6, sentenceHeight = 40;

/** Identifiers of a choice cannot be 0. */
int identifierOf (FollowingSensor sensor)
{
    return static_cast<int> (sensor) + 1;
}

/** "x is outside the surface; allowed: -75 to 75 mm", or nothing. */
juce::String faultOf (const char* axis, double millimetres, double lowest, double highest)
{
    if (millimetres >= lowest * milli && millimetres <= highest * milli)
        return {};

    return fromUtf8 (std::string (axis) + " is outside the surface; allowed: " + inWords (lowest * milli) + " to "
                     + inWords (highest * milli) + " mm");
}
} // namespace

LineChart driftChart (const FollowingStatus& status)
{
    const auto count = static_cast<Eigen::Index> (status.trace.size());
    const auto latest = count > 0 ? status.trace.back().time : 0;
    const auto isLong = latest > fewMinutes * secondsInMinute;
    Eigen::VectorXd times (count), drifts (count), deviations (count);

    for (Eigen::Index i = 0; i < count; ++i)
    {
        const auto& moment = status.trace[static_cast<std::size_t> (i)];
        const auto isKnown = moment.state == FollowingState::following;
        times[i] = moment.time / (isLong ? secondsInMinute : 1);
        drifts[i] = isKnown ? percent * moment.common : std::numeric_limits<double>::quiet_NaN();
        deviations[i] = percent * moment.deviation;
    }

    LineChart chart;
    chart.title = "Drift that all frequencies share";
    chart.xLabel = isLong ? "time of playing (min)" : "time of playing (s)";
    chart.yLabel = "drift (%)";
    chart.series = { { "drift", times, drifts, LineStyle::solid, false, true },
                     { "two deviations", times, drifts + 2 * deviations, LineStyle::dotted },
                     { "", times, drifts - 2 * deviations, LineStyle::dotted, false, false, 1 } };
    return chart;
}

DriftPanel::DriftPanel (DriftPanelSource sourceToShow) : source (std::move (sourceToShow))
{
    setTitle ("Drift");
    const std::pair<FollowingSensor, const char*> sensors[] {
        { FollowingSensor::none, "No sensor" },
        { FollowingSensor::velocity, "Velocity at a place" },
        { FollowingSensor::displacement, "Displacement at a place" },
        { FollowingSensor::ceramicCurrent, "Current of an idle ceramic" },
        { FollowingSensor::ceramicCharge, "Charge of an idle ceramic" }
    };

    for (const auto& [kind, name] : sensors)
        sensor.addItem (name, identifierOf (kind));

    sensor.setTooltip ("What the sensor's input hears of the surface");
    ceramic.setTooltip ("The ceramic that listens; it is not driven");
    freeze.setTooltip ("Keeps the foci as they are; nothing is learnt");
    reset.setTooltip ("Forgets the drift: foci are designed for the device as it is described. Undo brings it back");
    sentence.setFont (EditorLook::font (EditorLook::smallTextHeight));
    sentence.setJustificationType (juce::Justification::topLeft);
    sensor.onChange = [this]
    {
        auto wanted = shown;
        wanted.sensor = static_cast<FollowingSensor> (sensor.getSelectedId() - 1);
        change (wanted);
    };
    ceramic.onChange = [this]
    {
        auto wanted = shown;
        wanted.ceramic = std::max (0, ceramic.getSelectedId() - 1);
        change (wanted);
    };
    freeze.onClick = [this]
    {
        auto wanted = shown;
        wanted.isFrozen = freeze.getToggleState();
        change (wanted);
    };
    reset.onClick = [this] { forget(); };
    undo.setTooltip ("Brings back the drift that Reset has forgotten");
    undo.onClick = [this]
    {
        source.following.setDrift (std::exchange (forgotten, nullptr));
        undo.setVisible (false);
    };

    for (std::size_t i = 0; i < places.size(); ++i)
    {
        placeNames[i].setText (i == 0 ? "x (mm)" : "y (mm)", juce::dontSendNotification);
        placeNames[i].setFont (EditorLook::font (EditorLook::smallTextHeight));
        places[i].setEditable (true);
        places[i].setTitle (i == 0 ? "x of the sensor, mm" : "y of the sensor, mm");
        places[i].onTextChange = [this] { takePlace(); };
        addChildComponent (placeNames[i]);
        addChildComponent (places[i]);
    }

    for (auto* const child : std::initializer_list<juce::Component*> { &sensor, &freeze, &reset, &sentence, &chart })
        addAndMakeVisible (child);

    addChildComponent (ceramic);
    addChildComponent (undo);
    showSettings ({});
    refresh();
}

void DriftPanel::change (const FollowingSettings& wanted)
{
    fault.clear();

    if (wanted != shown)
        source.change (wanted);

    refresh();
}

/** What is known is kept for Undo, unless who has the panel does so. */
void DriftPanel::forget()
{
    if (source.reset)
        return source.reset();

    if (auto known = source.following.drift(); known != nullptr)
    {
        forgotten = std::move (known);
        source.following.setDrift (nullptr);
        undo.setVisible (true);
    }
}

/** A place outside is said and not taken, and so is a text that is no number. */
void DriftPanel::takePlace()
{
    auto wanted = shown;

    for (const auto& [text, value] : { std::pair (places[0].getText(), &wanted.xMillimetres),
                                       std::pair (places[1].getText(), &wanted.yMillimetres) })
    {
        const auto typed = typedNumber (text.toStdString(), { "mm" });

        if (! typed)
        {
            fault = "\"" + text + "\" is no place; allowed: a number of mm";
            showSettings (shown);
            sentence.setText (fault, juce::dontSendNotification);
            return;
        }

        *value = *typed;
    }

    if (const auto model = source.model(); model != nullptr)
    {
        const auto& surface = model->surface;
        auto found = faultOf ("x", wanted.xMillimetres, surface.xMinimum, surface.xMaximum);

        if (found.isEmpty() && surface.kind != SurfaceKind::line)
            found = faultOf ("y", wanted.yMillimetres, surface.yMinimum, surface.yMaximum);

        if (found.isNotEmpty())
        {
            fault = found;
            sentence.setText (fault, juce::dontSendNotification);
            return;
        }
    }

    change (wanted);
}

void DriftPanel::listCeramics (int count)
{
    if (ceramic.getNumItems() == count)
        return;

    ceramic.clear (juce::dontSendNotification);

    for (int i = 1; i <= count; ++i)
        ceramic.addItem ("Ceramic " + juce::String (i), i);

    ceramic.setSelectedId (shown.ceramic + 1, juce::dontSendNotification);
}

void DriftPanel::showSettings (const FollowingSettings& now)
{
    shown = now;
    sensor.setSelectedId (identifierOf (now.sensor), juce::dontSendNotification);
    ceramic.setSelectedId (now.ceramic + 1, juce::dontSendNotification);
    ceramic.setVisible (now.isCeramic());
    freeze.setToggleState (now.isFrozen, juce::dontSendNotification);
    freeze.setEnabled (now.isOn());
    reset.setEnabled (now.isOn());
    const double values[] { now.xMillimetres, now.yMillimetres };

    for (std::size_t i = 0; i < places.size(); ++i)
    {
        places[i].setText (fromUtf8 (inWords (values[i])), juce::dontSendNotification);
        places[i].setVisible (now.isOn() && ! now.isCeramic());
        placeNames[i].setVisible (places[i].isVisible());
    }

    resized();
}

void DriftPanel::refresh()
{
    if (const auto model = source.model(); model != nullptr)
    {
        listCeramics (static_cast<int> (model->actuators()));
        places[1].setEnabled (model->surface.kind != SurfaceKind::line);
        placeNames[1].setEnabled (places[1].isEnabled());
    }

    if (const auto now = source.following.settings(); now != shown)
        showSettings (now);

    auto newest = source.following.status();

    if (newest != status)
    {
        status = std::move (newest);
        auto drawn = status->trace.empty() ? nullptr : std::make_shared<const Chart> (driftChart (*status));
        chart.setChart (std::move (drawn), "No window was heard yet.");
    }

    sentence.setText (fault.isNotEmpty() ? fault : fromUtf8 (followingSentence (*status)), juce::dontSendNotification);
    sentence.setTooltip (sentence.getText());
}

void DriftPanel::lookAndFeelChanged()
{
    const auto& palette = EditorLook::findPalette (*this);

    for (auto& place : places)
    {
        place.setColour (juce::Label::backgroundColourId, palette.raised);
        place.setColour (juce::Label::textColourId, palette.text);
    }
}

void DriftPanel::resized()
{
    auto area = getLocalBounds().reduced (driftMargin, driftGap);
    auto row = area.removeFromTop (driftRow);
    reset.setBounds (row.removeFromRight (60));
    row.removeFromRight (driftGap);
    freeze.setBounds (row.removeFromRight (78));
    row.removeFromRight (driftGap);
    sensor.setBounds (row);
    area.removeFromTop (driftGap);

    if (shown.isOn())
    {
        row = area.removeFromTop (driftRow);
        undo.setBounds (row.withLeft (row.getRight() - 50));
        ceramic.setBounds (row.withWidth (std::min (row.getWidth(), 140)));

        for (std::size_t i = 0; i < places.size(); ++i)
        {
            placeNames[i].setBounds (row.removeFromLeft (56));
            places[i].setBounds (row.removeFromLeft (70));
            row.removeFromLeft (driftMargin);
        }

        area.removeFromTop (driftGap);
    }

    sentence.setBounds (area.removeFromTop (sentenceHeight));
    chart.setBounds (area);
}
} // namespace antinode
