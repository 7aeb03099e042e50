#include "WindowContent.h"

#include <algorithm>

namespace antinode
{
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
