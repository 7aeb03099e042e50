#include "ProbePanel.h"

namespace antinode
{
ProbePanel::ProbePanel (const ProbeTrace& trace) : chart ("Designed velocity at the probe"), live (trace)
{
    addAndMakeVisible (chart);
    addAndMakeVisible (live);
}

void ProbePanel::resized()
{
    auto area = getLocalBounds();
    chart.setBounds (area.removeFromTop (area.getHeight() / 2));
    live.setBounds (area);
}
} // namespace antinode
