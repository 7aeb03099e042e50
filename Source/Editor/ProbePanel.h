#pragma once

#include "ChartView.h"
#include "LiveTrace.h"

namespace antinode
{
/** The velocity at the probe: as designed, and live below. [message thread] */
class ProbePanel final : public juce::Component
{
public:
    explicit ProbePanel (const ProbeTrace&);

    ChartView& designed() { return chart; }
    void refresh()
    {
        if (isVisible())
            live.refresh();
    }

    void resized() override;

private:
    ChartView chart;
    LiveTrace live;
};
} // namespace antinode
