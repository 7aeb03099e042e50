#pragma once

#include <juce_gui_basics/juce_gui_basics.h>

namespace antinode
{
/** Shows the tips of what is inside of its parent, but not of what has closer ones: JUCE's shows those of the whole window, so that two
    show the same. [message thread] */
class LocalTooltips : public juce::TooltipWindow
{
public:
    using TooltipWindow::TooltipWindow;

    juce::String getTipFor (juce::Component&) override;
};
} // namespace antinode
