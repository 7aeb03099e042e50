#include "PanelGroup.h"

#include "EditorLook.h"

#include <algorithm>

namespace antinode
{
namespace
{
/** A tab: its name, underlined where it is shown. */
class Tab : public juce::TextButton
{
public:
    using TextButton::TextButton;

    void paintButton (juce::Graphics& g, bool isOver, bool) override
    {
        const auto& palette = EditorLook::findPalette (*this);
        const auto isShown = getToggleState();
        g.setColour (isShown || isOver ? palette.text : palette.mutedText);
        g.setFont (EditorLook::font (EditorLook::smallTextHeight, false));
        g.drawText (getButtonText(), getLocalBounds(), juce::Justification::centred);

        if (! isShown && ! hasKeyboardFocus (false))
            return;

        g.setColour (hasKeyboardFocus (false) ? palette.text : palette.accent);
        g.fillRect (getLocalBounds().removeFromBottom (2).reduced (4, 0));
    }
};
} // namespace

PanelGroup::PanelGroup (const juce::String& title)
{
    setTitle (title);
}

void PanelGroup::setPanels (const std::vector<Panel>& newPanels)
{
    for (auto& panel : panels)
        removeChildComponent (panel.content);

    panels = newPanels;
    tabs.clear();

    for (const auto& panel : panels)
    {
        auto tab = std::make_unique<Tab> (panel.name);
        tab->setTooltip (panel.tooltip);
        tab->onClick = [this, name = panel.name] { show (name); };
        addAndMakeVisible (*tab);
        tabs.push_back (std::move (tab));
        addChildComponent (panel.content);
    }

    const auto isThere = std::any_of (panels.begin(), panels.end(), [this] (const auto& p) { return p.name == shown; });

    if (! panels.empty())
        show (isThere ? shown : panels.front().name);
}

void PanelGroup::show (const juce::String& name)
{
    shown = name;

    for (std::size_t i = 0; i < panels.size(); ++i)
    {
        tabs[i]->setToggleState (panels[i].name == name, juce::dontSendNotification);
        panels[i].content->setVisible (panels[i].name == name);
    }

    resized();
    repaint();
}

void PanelGroup::paint (juce::Graphics& g)
{
    const auto& palette = EditorLook::findPalette (*this);
    g.fillAll (palette.panel);
    g.setColour (palette.outline);
    g.fillRect (getLocalBounds().removeFromTop (rows * tabHeight).removeFromBottom (1));
}

/** In as many rows as it takes to show all. */
void PanelGroup::placeTabs (juce::Rectangle<int> area)
{
    constexpr int largestPadding = 24, leastPadding = 14;
    const auto font = EditorLook::font (EditorLook::smallTextHeight);
    std::vector<int> widths;
    auto text = 0;

    for (const auto& tab : tabs)
    {
        widths.push_back (font.getStringWidth (tab->getButtonText()));
        text += widths.back();
    }

    const auto count = static_cast<int> (tabs.size()), width = area.getWidth();
    // All of the row where it is short, else no more than looks well.
    const auto padding = count > 0 ? std::clamp ((width - text) / count, leastPadding, largestPadding) : 0;
    auto left = 0, row = 0;

    for (std::size_t i = 0; i < tabs.size(); ++i)
    {
        const auto wanted = std::min (widths[i] + padding, width);

        if (left > 0 && left + wanted > width)
        {
            left = 0;
            ++row;
        }

        tabs[i]->setBounds (area.getX() + left, row * tabHeight, wanted, tabHeight);
        left += wanted;
    }

    rows = row + 1;
}

void PanelGroup::resized()
{
    placeTabs (getLocalBounds().reduced (6, 0));
    const auto area = getLocalBounds().withTrimmedTop (rows * tabHeight);

    for (auto& panel : panels)
        if (panel.content->isVisible())
            panel.content->setBounds (area);
}
} // namespace antinode
