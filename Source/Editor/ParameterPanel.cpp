#include "ParameterPanel.h"

#include "EditorLook.h"

#include <algorithm>

namespace antinode
{
namespace
{
constexpr int panelRowHeight = 21, minimumGap = 3, largestGap = 8, headingHeight = 22, groupGap = 3, panelMargin = 10;
} // namespace

ParameterPanel::ParameterPanel (AntinodeProcessor& processor)
{
    setTitle ("Parameters");
    setFocusContainerType (FocusContainerType::focusContainer);

    for (const auto* const group : processor.getParameterTree().getSubgroups (false))
    {
        groups.push_back ({ group->getName(), all.size(), 0, {} });

        for (auto* const parameter : group->getParameters (false))
        {
            all.push_back (std::make_unique<ParameterControl> (dynamic_cast<juce::RangedAudioParameter&> (*parameter)));
            addAndMakeVisible (*all.back());
            ++groups.back().count;
        }
    }
}

void ParameterPanel::refresh()
{
    for (const auto& control : all)
        control->refresh();
}

void ParameterPanel::refreshTexts (bool isLine)
{
    for (const auto& control : all)
    {
        control->refreshText();
        control->setEnabled (! (isLine && control->isAlongY()));
    }
}

int ParameterPanel::layOut (int width, int minimumHeight)
{
    const auto rows = static_cast<int> (all.size()), parts = static_cast<int> (groups.size());
    const auto others = panelMargin / 2 + parts * (headingHeight + groupGap) + rows * panelRowHeight;
    const auto rowGap = rows > 0 ? juce::jlimit (minimumGap, largestGap, (minimumHeight - others) / rows) : 0;
    auto y = panelMargin / 2;

    for (auto& group : groups)
    {
        group.heading = { panelMargin, y, width - 2 * panelMargin, headingHeight };
        y += headingHeight;

        for (auto i = group.first; i < group.first + group.count; ++i)
        {
            all[i]->setBounds (panelMargin, y, width - 2 * panelMargin, panelRowHeight);
            y += panelRowHeight + rowGap;
        }

        y += groupGap;
    }

    setSize (width, std::max (y, minimumHeight));
    return y;
}

void ParameterPanel::paint (juce::Graphics& g)
{
    const auto& palette = EditorLook::findPalette (*this);
    g.fillAll (palette.panel);
    g.setFont (EditorLook::font (EditorLook::smallTextHeight, true));

    for (const auto& group : groups)
    {
        g.setColour (palette.mutedText);
        g.drawText (group.name, group.heading, juce::Justification::centredLeft);
    }
}
} // namespace antinode
