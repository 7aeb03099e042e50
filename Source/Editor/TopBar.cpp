#include "TopBar.h"

#include "EditorLook.h"

#include <algorithm>

namespace antinode
{
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
} // namespace antinode
