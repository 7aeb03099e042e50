#include "LocalTooltips.h"

#include <algorithm>

namespace antinode
{
juce::String LocalTooltips::getTipFor (juce::Component& component)
{
    for (const auto* place = &component; place != nullptr; place = place->getParentComponent())
        for (auto* const child : place->getChildren())
            if (auto* const closest = dynamic_cast<LocalTooltips*> (child))
                return closest == this ? TooltipWindow::getTipFor (component) : juce::String();

    return {};
}
} // namespace antinode
