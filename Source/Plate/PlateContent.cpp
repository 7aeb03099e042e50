#include "PlateContent.h"

#include <Editor/EditorLook.h>

#include <antinode_base/Prefixes.h>
#include <antinode_reports/Lettering.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace antinode
{
namespace
{
constexpr double fullVelocity = 1000; // mm/s, of a full bar
} // namespace

ProbeSurface::ProbeSurface (PlateProcessor& processorToShow)
    : SurfaceView (
        "How the surface has moved, two hundred times slower.",
        "How the surface has moved round its largest motion of late, some two hundred times slower.\nDrag the "
        "numbered probes.",
        true),
      processor (processorToShow)
{
}

void ProbeSurface::refresh()
{
    const auto now = processor.parameters().settings();

    if (now == shown && shownProbes == processor.shownProbes())
        return;

    shown = now;
    shownProbes = processor.shownProbes();
    repaint();
}

SurfaceView::Place ProbeSurface::placeOf (int probe) const
{
    return { &processor.parameters().probeX (probe), &processor.parameters().probeY (probe) };
}

void ProbeSurface::paintOnTop (juce::Graphics& g)
{
    constexpr auto radius = 8.0F;
    const auto& palette = EditorLook::findPalette (*this);

    // The first ones last: where probes lie on each other they are in front.
    for (auto i = processor.shownProbes(); --i >= 0;)
    {
        const auto circle = juce::Rectangle<float> (2 * radius, 2 * radius).withCentre (probe (i));
        g.setColour (palette.window.withAlpha (0.85F));
        g.fillEllipse (circle);
        g.setColour (palette.armed);
        g.drawEllipse (circle, 1.6F);
        drawText (g, std::to_string (i + 1), circle, juce::Justification::centred, { 10, true, palette.text });
    }
}

void ProbeSurface::mouseDown (const juce::MouseEvent& event)
{
    for (int i = 0; isShown() && i < processor.shownProbes(); ++i)
        if (const auto offset = event.position - probe (i); offset.getDistanceFromOrigin() < grabRadius)
            return grab (placeOf (i), offset);
}

PlateContent::PlateContent (PlateProcessor& processorToShow)
    : WindowContent ("Antinode Plate", { { 720, 460, 1300, 800 }, 1040, 640, 30, 44 }), processor (processorToShow),
      device (LibraryKind::device, "device",
              [this] (const auto& json, const auto& source)
              { processor.load (std::make_shared<const DeviceDocument> (readDeviceDocument (json, source))); }),
      surfaceView (processor)
{
    device.setTooltip ("The device that the voltages move. Click to choose another.");
    hold.setTitle ("Hold the picture");
    hold.setTooltip ("Keeps the window that is shown. Otherwise the next one follows when it has been shown, as soon "
                     "as the surface has moved as strongly again.");
    hold.setClickingTogglesState (true);
    time.setTitle ("Time");
    bar.addLeft (device, 240);
    bar.addLeft (time, std::numeric_limits<int>::max());
    bar.addRight (bar.theme, 34);
    bar.addRight (hold, 70);

    for (juce::Component* const child :
         std::initializer_list<juce::Component*> { &surfaceView, &spectrum, &probes, &voltages })
        addAndMakeVisible (child);

    begin();
}

void PlateContent::refresh (double seconds)
{
    takeSnapshot();
    position += hold.getToggleState() ? 0 : seconds;
    showPicture();
    surfaceView.refresh();
    nameProbes();
    showLevels (seconds);
    showStatus (seconds);
}

void PlateContent::takeSnapshot()
{
    auto now = processor.session().snapshot();

    if (now == snapshot)
        return;

    if (snapshot == nullptr || now->model != snapshot->model)
    {
        probes.forget();
        voltages.forget();
    }

    snapshot = std::move (now);
    motion->watch (snapshot);
    device.setButtonText ("Device: " + fromUtf8 (processor.device()->description.name));
    namedProbes = 0; // Names and places of all rows are those of another device.
}

/** Goes through the window; at its end the next one is asked for, and this one is shown again until it comes. */
void PlateContent::showPicture()
{
    auto newest = motion->picture();

    if (newest == nullptr)
        return;

    if (newest != shown)
    {
        shown = std::move (newest);
        surfaceView.setPicture (shown);
        spectrum.setChart (shown->spectrum, {});
        position = 0;
    }

    const auto frames = shown->frames->available();

    if (position >= secondsOfWindow)
    {
        motion->askForNext();
        position = std::fmod (position, secondsOfWindow);
    }

    const auto frame = std::clamp (static_cast<int> (position / secondsOfWindow * frames), 0, frames - 1);
    surfaceView.setFrame (frame);
    const auto window = shown->step * (frames - 1);
    time.setText (window > 0
                      ? juce::String (milli * shown->step * frame, 1) + " of " + juce::String (milli * window, 1)
                            + " ms, " + juce::String (juce::roundToInt (secondsOfWindow / window)) + " times slower"
                      : juce::String ("at rest"),
                  juce::dontSendNotification);
}

void PlateContent::holdAt (int frame)
{
    hold.setToggleState (true, juce::dontSendNotification);
    position = (frame + 0.5) / PlatePath::capturedFrames * secondsOfWindow;
    showPicture();
}

void PlateContent::nameProbes()
{
    const auto settings = processor.parameters().settings();

    if (snapshot->model == nullptr || (settings == namedSettings && namedProbes == processor.shownProbes()))
        return;

    namedSettings = settings;
    namedProbes = processor.shownProbes();
    std::vector<LevelRows::Row> rows;

    for (int i = 0; i < namedProbes; ++i)
    {
        auto place = processor.parameters().probeX (i).getCurrentValueAsText();

        if (snapshot->model->surface.kind == SurfaceKind::plate)
            place << ", " << processor.parameters().probeY (i).getCurrentValueAsText();

        rows.push_back ({ juce::String (i + 1), place, fullVelocity });
    }

    probes.setRows (std::move (rows));
}

void PlateContent::showLevels (double seconds)
{
    auto& meters = processor.session().meters();
    std::vector<double> velocities (PlatePath::probes);

    for (int i = 0; i < PlatePath::probes; ++i)
        velocities[static_cast<std::size_t> (i)] = milli * static_cast<double> (meters.takeProbe (i));

    probes.refresh (velocities, seconds);
    voltages.showVoltages (snapshot->model.get(), meters, seconds);
}

void PlateContent::showStatus (double seconds)
{
    auto messages = messagesBeside();

    for (auto& message : processor.messages())
        messages.push_back (std::move (message));

    addMessage (messages, Urgency::warning, device.error().toStdString());

    if (snapshot->isSolving)
        addMessage (messages, Urgency::calm, "Solving the device.");

    status.show (std::move (messages), {}, seconds);
}

void PlateContent::layOut (juce::Rectangle<int> area)
{
    area = area.reduced (gap);
    auto right = area.removeFromRight (std::max (320, area.getWidth() * 2 / 5));
    area.removeFromRight (gap);
    probes.setBounds (right.removeFromTop (std::min (210, right.getHeight() * 9 / 20)));
    right.removeFromTop (gap);
    spectrum.setBounds (right);
    voltages.setBounds (area.removeFromBottom (std::min (120, area.getHeight() / 4)));
    area.removeFromBottom (gap);
    surfaceView.setBounds (area);
}
} // namespace antinode
