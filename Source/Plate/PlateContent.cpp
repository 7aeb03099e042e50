#include "PlateContent.h"

#include <antinode_base/Prefixes.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace antinode
{
namespace
{
constexpr int topHeight = 44, gap = 6;
constexpr double fullVelocity = 1000; // mm/s, of a full bar
} // namespace

PlateContent::PlateContent (PlateProcessor& processorToShow)
    : processor (processorToShow), device ([this] (auto chosen) { processor.load (std::move (chosen)); }),
      surfaceView (processor), tooltips (this, 600)
{
    juce::LookAndFeel::setDefaultLookAndFeel (&fonts.get());
    setLookAndFeel (&look);
    setTitle ("Antinode Plate");
    device.setTooltip ("The device that the voltages move. Click to choose another.");
    hold.setTitle ("Hold the picture");
    hold.setTooltip ("Keeps the window that is shown. Otherwise the next one follows when it has been shown, as soon "
                     "as the surface has moved as strongly again.");
    hold.setClickingTogglesState (true);
    theme.setButtonText (juce::String::fromUTF8 ("\xE2\x97\x90"));
    theme.setTitle ("Light or dark");
    theme.setTooltip ("Light or dark");
    time.setTitle ("Time");
    theme.onClick = [this] { setDark (! isDark()); };

    for (juce::Component* const child :
         { static_cast<juce::Component*> (&device), static_cast<juce::Component*> (&hold),
           static_cast<juce::Component*> (&theme), static_cast<juce::Component*> (&time),
           static_cast<juce::Component*> (&surfaceView), static_cast<juce::Component*> (&spectrum),
           static_cast<juce::Component*> (&probes), static_cast<juce::Component*> (&voltages),
           static_cast<juce::Component*> (&statusView) })
        addAndMakeVisible (child);

    statusView.onHeight = [this] { resized(); };
    setDark (true);
    setSize (sizes.leastWidth, sizes.leastHeight);
    refresh (0);
}

PlateContent::~PlateContent()
{
    motion->stop();
    setLookAndFeel (nullptr);
}

void PlateContent::setDark (bool isDark)
{
    look.setPalette (isDark ? Palette::dark() : Palette::light());
    sendLookAndFeelChange();

    if (onTheme)
        onTheme();
}

void PlateContent::lookAndFeelChanged()
{
    device.setColour (juce::TextButton::buttonColourId, look.palette().raised);
    theme.setColour (juce::TextButton::buttonColourId, look.palette().raised);

    hold.setColour (juce::TextButton::buttonColourId, look.palette().raised);
    hold.setColour (juce::TextButton::buttonOnColourId, look.palette().accent);
    hold.setColour (juce::TextButton::textColourOnId, look.palette().onStrong);

    for (juce::TextButton* const button : std::initializer_list<juce::TextButton*> { &device, &theme, &hold })
        button->setColour (juce::TextButton::textColourOffId, look.palette().text);

    time.setColour (juce::Label::textColourId, look.palette().mutedText);
    repaint();
}

void PlateContent::refresh (double seconds)
{
    if (auto now = processor.session().snapshot(); now != snapshot)
    {
        if (snapshot == nullptr || now->model != snapshot->model)
        {
            probes.forget();
            voltages.forget();
        }

        snapshot = std::move (now);
        motion->watch (snapshot);
        device.setDevice (*processor.device());
        namedProbes = 0; // Names and places of all rows are those of another device.
    }

    position += hold.getToggleState() ? 0 : seconds;
    showPicture();
    surfaceView.refresh();
    nameRows();
    showLevels (seconds);
    showStatus (seconds);
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

    const auto frames = shown->field->frames->available();

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

void PlateContent::nameRows()
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
    rows.clear();

    for (std::size_t i = 0; i < snapshot->model->ceramics.size(); ++i)
        rows.push_back ({ juce::String (i + 1), {}, voltageLimit (*snapshot->model, i) });

    voltages.setRows (std::move (rows));
}

void PlateContent::showLevels (double seconds)
{
    auto& meters = processor.session().meters();
    std::vector<double> values;
    values.reserve (static_cast<std::size_t> (LevelMeters::ceramics));

    for (int i = 0; i < PlatePath::probes; ++i)
        values.push_back (milli * static_cast<double> (meters.takeProbe (i)));

    probes.refresh (values, seconds);
    values.clear();

    for (int i = 0; i < LevelMeters::ceramics; ++i)
        values.push_back (static_cast<double> (meters.takePeak (i)));

    voltages.refresh (values, seconds);
}

void PlateContent::showStatus (double seconds)
{
    auto messages = processor.messages();
    addMessage (messages, Urgency::warning, device.error().toStdString());

    if (snapshot->isSolving)
        addMessage (messages, Urgency::calm, "Solving the device.");

    statusView.show (std::move (messages), {}, seconds);
}

void PlateContent::loadDevice (const std::string& nameOrFile)
{
    device.loadDevice (nameOrFile);
}

void PlateContent::paint (juce::Graphics& g)
{
    const auto& palette = look.palette();
    g.fillAll (palette.window);
    auto area = getLocalBounds();
    g.setColour (palette.panel);
    g.fillRect (area.removeFromTop (topHeight));
}

void PlateContent::resized()
{
    auto area = getLocalBounds();
    auto top = area.removeFromTop (topHeight).reduced (8, 6);
    statusView.setBounds (area.removeFromBottom (statusView.wantedHeight()));
    device.setBounds (top.removeFromLeft (240));
    theme.setBounds (top.removeFromRight (34));
    top.removeFromRight (gap);
    hold.setBounds (top.removeFromRight (70));
    top.removeFromLeft (2 * gap);
    time.setBounds (top);
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
