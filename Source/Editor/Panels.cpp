#include "Panels.h"

#include "EditorLook.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

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

namespace
{
constexpr int scoresMargin = 12;

} // namespace

int ScoresView::Page::layOut (int width)
{
    layout.createLayout (words, static_cast<float> (width - 2 * scoresMargin));
    return static_cast<int> (std::ceil (layout.getHeight())) + 2 * scoresMargin;
}

void ScoresView::Page::paint (juce::Graphics& g)
{
    layout.draw (g, getLocalBounds().reduced (scoresMargin).toFloat());
}

ScoresView::ScoresView()
{
    setTitle ("Scores and remarks");
    page.setTitle ("Scores and remarks");
    viewport.setViewedComponent (&page, false);
    viewport.setScrollBarsShown (true, false);
    addAndMakeVisible (viewport);
}

void ScoresView::setPicture (std::shared_ptr<const DesignPicture> newPicture)
{
    picture = std::move (newPicture);
    layOut();
}

void ScoresView::write()
{
    const auto& palette = EditorLook::findPalette (*this);
    const auto plain = EditorLook::font (EditorLook::smallTextHeight), strong = EditorLook::font (15, true),
               small = EditorLook::font (5);
    auto& words = page.words;
    words.clear();
    words.setLineSpacing (2);

    if (picture != nullptr && ! picture->error.empty())
        words.append (fromUtf8 (picture->error) + "\n\n", EditorLook::font(), palette.warning);

    if (picture == nullptr || picture->rendered == nullptr)
    {
        words.append ("The render is not ready yet.", plain, palette.mutedText);
        page.setDescription (words.getText());
        return;
    }

    for (const auto& warning : picture->rendered->warnings)
    {
        words.append (fromUtf8 (warning) + "\n", plain, palette.warning);
        words.append ("\n", small);
    }

    for (const auto& score : picture->rendered->scores)
    {
        words.append (fromUtf8 (score.name) + "   ", plain, palette.mutedText);
        words.append (fromUtf8 (score.value) + "\n", strong, palette.text);
        words.append (fromUtf8 (score.sentence) + "\n", plain, palette.mutedText);
        words.append ("\n", small);
    }

    for (const auto& choice : picture->rendered->choices)
    {
        words.append (fromUtf8 (choice) + "\n", plain, palette.text);
        words.append ("\n", small);
    }

    page.setDescription (words.getText());
}

void ScoresView::layOut()
{
    write();
    const auto width = getWidth() - viewport.getScrollBarThickness();

    if (width > 0)
        page.setSize (width, std::max (page.layOut (width), viewport.getHeight()));

    page.repaint();
}

void ScoresView::resized()
{
    viewport.setBounds (getLocalBounds());
    layOut();
}

namespace
{
constexpr int settingsMargin = 12, settingsRow = 28, scaleNameWidth = 170;
constexpr std::array percents { 75, 100, 125, 150, 175, 200, 250, 300 };
constexpr int withTheWindow = 1; // identifiers of a choice cannot be 0
} // namespace

SettingsPanel::SettingsPanel (SeparateNodes nodesToTurn) : nodes (std::move (nodesToTurn))
{
    setTitle ("Settings");
    scaleName.setFont (EditorLook::font (EditorLook::smallTextHeight));
    scale.setTitle ("Size of text and controls");
    scale.setTooltip ("How large all of the window is drawn, as far as all of it stays reachable");
    scale.addItem ("with the window", withTheWindow);

    for (const auto percent : percents)
        scale.addItem (juce::String (percent) + " %", percent);

    setScale (0);
    scale.onChange = [this]
    {
        const auto chosen = scale.getSelectedId();

        if (onScale)
            onScale (chosen == withTheWindow ? 0.0 : chosen / 100.0);
    };
    separate.setTooltip (
        "Leave it off unless custom nodes are inserted: forces, allocation, gains, limiter and plate then run as "
        "separate nodes, with the same samples at a higher cost. Foci are designed again when it is switched.");
    separate.onClick = [this] { nodes.turn (separate.getToggleState()); };
    addAndMakeVisible (scaleName);
    addAndMakeVisible (scale);

    if (nodes.turn)
        addAndMakeVisible (separate);

    refresh();
}

void SettingsPanel::setScale (double wanted)
{
    scale.setSelectedId (wanted > 0 ? juce::roundToInt (100 * wanted) : withTheWindow, juce::dontSendNotification);

    if (scale.getSelectedId() == 0)
        scale.setText (juce::String (juce::roundToInt (100 * wanted)) + " %", juce::dontSendNotification);
}

void SettingsPanel::refresh()
{
    if (nodes.areOn)
        separate.setToggleState (nodes.areOn(), juce::dontSendNotification);
}

void SettingsPanel::resized()
{
    auto area = getLocalBounds().reduced (settingsMargin);
    auto row = area.removeFromTop (settingsRow).reduced (0, 2);
    scaleName.setBounds (row.removeFromLeft (scaleNameWidth));
    scale.setBounds (row.removeFromLeft (140));
    area.removeFromTop (settingsMargin);
    separate.setBounds (area.removeFromTop (settingsRow));
}
} // namespace antinode
