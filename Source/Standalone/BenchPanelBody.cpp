#include "BenchPanel.h"

#include <Editor/EditorLook.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>

#include <algorithm>
#include <array>
#include <cmath>

// What the panel says and where it stands; what it does is in BenchPanel.cpp.
namespace antinode
{
namespace
{
constexpr int benchNameWidth = 148, surfaceHeight = 230, chartHeight = 200, checklistHeight = 220, benchGap = 6;

bool isWaiting (BenchStep step)
{
    return step == BenchStep::aiming || step == BenchStep::wires;
}

bool isRunning (BenchStep step)
{
    return step != BenchStep::none && step != BenchStep::done && step != BenchStep::failed;
}

int heightOf (const juce::String& text, int width)
{
    juce::AttributedString words;
    words.append (text, EditorLook::font());
    juce::TextLayout layout;
    layout.createLayout (words, static_cast<float> (std::max (1, width - 10)));
    return text.isEmpty() ? 0 : juce::roundToInt (layout.getHeight()) + 10;
}

juce::String signedPercent (double share)
{
    return (share >= 0 ? "+" : fromUtf8 ("\xE2\x88\x92")) + juce::String (fixedText (100 * std::abs (share), 1)) + " %";
}
} // namespace

void BenchPanel::Page::paint (juce::Graphics& g)
{
    g.setColour (EditorLook::findPalette (*this).mutedText);

    if (! headings.isEmpty())
        WireRow::paintHeadings (g, headings);
}

juce::String BenchPanel::title() const
{
    auto place =
        "Point " + juce::String (state.point + 1) + " of " + juce::String (static_cast<int> (state.points.rows()));

    switch (state.step)
    {
        case BenchStep::none:
            return "Measure the device";
        case BenchStep::preparing:
            return "Preparing";
        case BenchStep::aiming:
            return place + ": aim the sensor at the cross";
        case BenchStep::playing:
            if (state.ceramic < 0)
                return place;

            return place + ": ceramic " + juce::String (state.ceramic + 1) + " of "
                   + juce::String (static_cast<int> (rows.size())) + " plays";
        case BenchStep::wires:
            return "Some wires are wrong";
        case BenchStep::retuning:
            return "Retuning the drawing";
        case BenchStep::done:
            return "Retuned";
        case BenchStep::failed:
            return "Stopped";
    }

    return {};
}

juce::String BenchPanel::outcome() const
{
    const auto& now = state.retuned->now;
    const auto found = std::count (now.found.begin(), now.found.end(), true);
    auto words = juce::String (static_cast<int> (found)) + " of " + juce::String (static_cast<int> (now.found.size()))
                 + " modes found; frequencies " + signedPercent (now.frequencyChanges.minCoeff()) + " to "
                 + signedPercent (now.frequencyChanges.maxCoeff()) + " against the drawing.\nThe drawing misses "
                 + juce::String (juce::roundToInt (100 * state.missBefore))
                 + " % of the measured responses, the retuned device "
                 + juce::String (juce::roundToInt (100 * state.missAfter)) + " %.";

    if (state.latency > 0)
        words += " Latency: " + juce::String (fixedText (state.latency * milli, 3)) + " ms.";

    for (const auto& remark : state.retuned->remarks)
        words += "\n" + fromUtf8 (remark);

    return words + "\nReport: " + fromUtf8 ((state.folder / "report.html").string());
}

juce::String BenchPanel::words() const
{
    juce::String said;

    switch (state.step)
    {
        case BenchStep::none:
            said = isTour()
                       ? "The tour leads through a measurement of the loaded device without hardware: plate, wires "
                         "and sensor are simulated, and no voltage is played. Its plate is a little off the "
                         "drawing, and some of its wires are wrong."
                       : "Measures the loaded device at six points with a sensor, checks every wire by its answer, "
                         "and updates the drawing. Read the safety notes first; amplifiers stay off until the "
                         "checklist says so.";
            break;
        case BenchStep::preparing:
            said = fromUtf8 ("Solves the device and chooses six points \xE2\x80\xA6");
            break;
        case BenchStep::wires:
            for (const auto& found : state.findings)
                said += fromUtf8 (wireInWords (found)) + "\n";

            said = said.trimEnd();
            break;
        case BenchStep::retuning:
            said = fromUtf8 ("Finds the modes of the drawing in the measured responses \xE2\x80\xA6");
            break;
        case BenchStep::done:
            said = outcome();
            break;
        case BenchStep::failed:
            said = fromUtf8 (state.error);
            break;
        case BenchStep::aiming:
        case BenchStep::playing:
            said = aimInWords (state.picture->model->surface, state.points.row (state.point).transpose());

            if (! isTour() && state.step == BenchStep::aiming && ! host.arm().get())
                said += "\nPress ARM before you measure.";

            if (! state.sentences.empty())
                said += "\n" + fromUtf8 (state.sentences.back());
    }

    return saved.isEmpty() ? said : said + "\n" + saved;
}

void BenchPanel::showWords()
{
    const auto& palette = EditorLook::findPalette (*this);
    heading.setText (title(), juce::dontSendNotification);
    text.setText (words(), juce::dontSendNotification);
    const auto isWarning = state.step == BenchStep::wires || state.step == BenchStep::failed;
    heading.setColour (juce::Label::textColourId, isWarning ? palette.warning : palette.text);
    beginButton.setButtonText (state.step == BenchStep::failed ? "Go on"
                               : state.step == BenchStep::done ? "Begin again"
                                                               : "Begin");
}

void BenchPanel::layOutSensor (juce::Rectangle<int>& area)
{
    const std::array<juce::Component*, 6> fields { &bench, &input, &syncInput, &sensitivity, &inputRange, &level };
    const auto isIdle = ! isRunning (state.step);

    for (std::size_t i = 0; i < fields.size(); ++i)
    {
        const auto isShown = i == 0 || (isIdle && (! isTour() || i == fields.size() - 1));
        fields[i]->setVisible (isShown);
        names[i].setVisible (isShown);
        fields[i]->setEnabled (isIdle);

        if (! isShown)
            continue;

        auto row = area.removeFromTop (panelRowHeight).reduced (0, 2);
        names[i].setBounds (row.removeFromLeft (benchNameWidth));
        fields[i]->setBounds (row);
    }
}

void BenchPanel::layOut()
{
    const auto width = std::max (0, viewport.getWidth() - viewport.getScrollBarThickness() - benchGap);
    auto area = juce::Rectangle<int> (0, 0, width, 10000);
    const auto step = state.step;
    const auto hasPicture = state.picture != nullptr && step != BenchStep::none;
    const auto place = [&] (juce::Component& child, bool isShown, int height)
    {
        child.setVisible (isShown);

        if (isShown)
            child.setBounds (area.removeFromTop (height).withTrimmedBottom (benchGap));
    };
    const auto placeRow = [&] (std::initializer_list<std::pair<juce::Button*, bool>> buttons)
    {
        const auto count = static_cast<int> (
            std::count_if (buttons.begin(), buttons.end(), [] (const auto& each) { return each.second; }));
        auto row = count > 0 ? area.removeFromTop (panelRowHeight + benchGap).withTrimmedBottom (benchGap)
                             : juce::Rectangle<int>();
        const auto each = count > 0 ? row.getWidth() / count : 0;

        for (const auto& [button, isShown] : buttons)
        {
            button->setVisible (isShown);

            if (isShown)
                button->setBounds (row.removeFromLeft (each).reduced (1, 1));
        }
    };
    layOutSensor (area);
    place (heading, true, panelRowHeight + benchGap);
    // All buttons stay in place, so that a second click on one never meets Stop.
    const auto asks = isRunning (step) && step != BenchStep::wires;

    for (auto* const button : { &measureButton, &skipButton, &againButton })
        button->setEnabled (step == BenchStep::aiming && (button != &againButton || state.point > 0));

    placeRow ({ { &measureButton, asks },
                { &skipButton, asks },
                { &againButton, asks },
                { &correctButton, step == BenchStep::wires },
                { &goOnButton, step == BenchStep::wires } });
    placeRow ({ { &beginButton, ! isRunning (step) }, { &stopButton, isRunning (step) } });
    place (text, text.getText().isNotEmpty(), heightOf (text.getText(), width) + benchGap);
    place (surface, hasPicture && step != BenchStep::done, surfaceHeight);
    place (chart, step == BenchStep::done, chartHeight);
    place (deviceName, step == BenchStep::done, panelRowHeight + benchGap);
    placeRow ({ { &saveButton, step == BenchStep::done } });
    page.headings =
        hasPicture ? area.removeFromTop (panelRowHeight).withTrimmedBottom (benchGap) : juce::Rectangle<int>();

    for (auto& row : rows)
        place (*row, hasPicture, WireRow::height);

    area.removeFromTop (benchGap);
    place (checklist, isWaiting (step) && state.point == 0 && checklist.getText().isNotEmpty(), checklistHeight);
    page.setSize (width, area.getY());
    page.repaint();
}

void BenchPanel::lookAndFeelChanged()
{
    const auto& palette = EditorLook::findPalette (*this);

    for (auto* const editor : { &sensitivity, &inputRange, &level, &deviceName, &checklist })
        editor->applyColourToAllText (palette.text);
}

void BenchPanel::resized()
{
    viewport.setBounds (getLocalBounds().reduced (panelMargin));
    layOut();
}
} // namespace antinode
