#include "WindowContent.h"

#include "EditorLook.h"

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

namespace
{
constexpr int barMargin = 8, barGap = 6;
}

TopBar::TopBar()
{
    setTitle ("Commands");
    theme.setButtonText (juce::String::fromUTF8 ("\xE2\x97\x90"));
    theme.setTitle ("Light or dark");
    theme.setTooltip ("Light or dark");
}

void TopBar::addLeft (juce::Component& component, int widest)
{
    left.push_back ({ &component, widest, barGap });
    addAndMakeVisible (component);
}

void TopBar::addRight (juce::Component& component, int width, int gap)
{
    right.push_back ({ &component, width, gap });
    addAndMakeVisible (component);
}

void TopBar::paint (juce::Graphics& g)
{
    g.fillAll (EditorLook::findPalette (*this).panel);
}

void TopBar::resized()
{
    auto area = getLocalBounds().reduced (barMargin, 6);

    for (const auto& [component, width, gap] : right)
    {
        component->setBounds (area.removeFromRight (width));
        area.removeFromRight (gap);
    }

    auto rest = static_cast<int> (left.size());

    for (const auto& [component, widest, gap] : left)
    {
        const auto share = (area.getWidth() - gap * (rest - 1)) / rest;
        component->setBounds (area.removeFromLeft (std::min (widest, share)));
        area.removeFromLeft (gap);
        --rest;
    }
}

double windowScale (int width, int height, const ContentSizes& sizes, double wanted)
{
    const auto most =
        std::min (static_cast<double> (width) / sizes.leastWidth, static_cast<double> (height) / sizes.leastHeight);
    const auto suitable = std::max (1.0, std::min (static_cast<double> (width) / sizes.roomyWidth,
                                                   static_cast<double> (height) / sizes.roomyHeight));
    return std::min (most, wanted > 0 ? wanted : suitable);
}

juce::String LocalTooltips::getTipFor (juce::Component& component)
{
    for (const auto* place = &component; place != nullptr; place = place->getParentComponent())
        for (auto* const child : place->getChildren())
            if (auto* const closest = dynamic_cast<LocalTooltips*> (child))
                return closest == this ? TooltipWindow::getTipFor (component) : juce::String();

    return {};
}

WindowContent::WindowContent (const juce::String& title, const Shape& shapeOfIt) : windowShape (shapeOfIt)
{
    juce::LookAndFeel::setDefaultLookAndFeel (&fonts.get());
    setLookAndFeel (&look);
    setTitle (title);
    addAndMakeVisible (bar);
    addAndMakeVisible (status);
    bar.theme.onClick = [this] { setDark (! isDark()); };
    status.onHeight = [this] { resized(); };
}

void WindowContent::begin()
{
    setDark (true); // Children have looked for their look before they had us as a parent.
    setSize (windowShape.sizes.leastWidth, windowShape.sizes.leastHeight);
    refresh (0);
}

void WindowContent::setDark (bool isDark)
{
    look.setPalette (isDark ? Palette::dark() : Palette::light());
    sendLookAndFeelChange();

    if (onTheme)
        onTheme();
}

std::vector<UserMessage> WindowContent::messagesBeside() const
{
    return moreMessages ? moreMessages() : std::vector<UserMessage>();
}

void WindowContent::paint (juce::Graphics& g)
{
    g.fillAll (look.palette().window);
}

void WindowContent::resized()
{
    auto area = getLocalBounds();
    bar.setBounds (area.removeFromTop (windowShape.barHeight));
    status.setBounds (area.removeFromBottom (status.wantedHeight()));
    layOut (area);
}
} // namespace antinode
