#pragma once

#include <juce_gui_basics/juce_gui_basics.h>

namespace antinode
{
/** Shows the tooltips of components inside its parent, except those with a closer instance: JUCE's shows those of the
   whole window, so that two show the same. [message thread] */
class LocalTooltips : public juce::TooltipWindow
{
public:
    using TooltipWindow::TooltipWindow;

    juce::String getTipFor (juce::Component&) override;
};
} // namespace antinode
