#include "StatusLine.h"

#include "EditorLook.h"
#include "JuceText.h"

#include <antinode_reports/Lettering.h>

#include <algorithm>
#include <utility>

namespace antinode
{
namespace
{
constexpr int cornerWidth = 14; // where a window is resized
constexpr int firstLine = 24, furtherLine = 18, mostLines = 4;
constexpr double saidLasts = 20; // s
} // namespace

StatusLine::StatusLine()
{
    setTitle ("Status");
}

void StatusLine::say (const juce::String& sentence)
{
    said = sentence;
    saidFor = 0;
}

juce::String StatusLine::text() const
{
    return shown.empty() ? juce::String() : fromUtf8 (shown.front().text);
}

Urgency StatusLine::urgency() const
{
    return shown.empty() ? Urgency::calm : shown.front().urgency;
}

int StatusLine::wantedHeight() const
{
    return firstLine + furtherLine * (std::clamp (static_cast<int> (shown.size()), 1, mostLines) - 1);
}

void StatusLine::show (std::vector<UserMessage> present, const juce::String& figures, double seconds)
{
    saidFor += seconds;

    if (saidFor > saidLasts)
        said.clear();

    if (said.isNotEmpty())
        present.insert (present.begin(), { Urgency::warning, said.toStdString() });

    present = worstFirst (std::move (present));

    if (present == shown && figures == figuresShown)
        return;

    const auto before = wantedHeight();
    shown = std::move (present);
    figuresShown = figures;
    juce::StringArray texts;

    for (const auto& message : shown)
        texts.add (fromUtf8 (message.text));

    setDescription (texts.joinIntoString ("\n"));
    setTooltip (texts.joinIntoString ("\n\n"));
    repaint();

    if (onHeight && wantedHeight() != before)
        onHeight();
}

void StatusLine::paint (juce::Graphics& g)
{
    const auto& palette = EditorLook::findPalette (*this);
    g.fillAll (palette.panel);
    auto area = getLocalBounds().reduced (10, 0).toFloat();
    const TextStyle style { EditorLook::smallTextHeight, false, palette.mutedText };

    for (int i = 0; i < std::min (static_cast<int> (shown.size()), mostLines); ++i)
    {
        const auto& [urgency, text] = shown[static_cast<std::size_t> (i)];
        const auto isCalm = urgency == Urgency::calm;
        const auto urgent = urgency == Urgency::warning ? palette.warning : palette.caution;
        const auto more = static_cast<int> (shown.size()) - mostLines;
        const auto right = (i == 0                           ? figuresShown
                            : i + 1 == mostLines && more > 0 ? "and " + juce::String (more) + " more"
                                                             : juce::String())
                               .toStdString();
        auto line = area.removeFromTop (static_cast<float> (i == 0 ? firstLine : furtherLine));
        line.removeFromRight (cornerWidth);
        drawText (g, right, line.removeFromRight (textWidth (right, style) + 2), juce::Justification::centredRight,
                  style);
        g.setColour (isCalm ? palette.armed : urgent);
        g.fillEllipse (line.removeFromLeft (8).withSizeKeepingCentre (8, 8));
        line.removeFromLeft (8);
        line.removeFromRight (16);
        drawText (g, text, line, juce::Justification::centredLeft,
                  { EditorLook::smallTextHeight, false, isCalm ? palette.text : urgent });
    }
}
} // namespace antinode
