#pragma once

#include <juce_gui_basics/juce_gui_basics.h>

namespace antinode
{
/** One output's level as a bar that falls slowly, with a lamp that stays on after samples were clamped. */
class LevelBar : public juce::Component, public juce::SettableTooltipClient
{
public:
    /** @param peak  share of full scale since the last call; 60 dB are shown @param clamped  samples held back so far
        [message thread] */
    void show (float peak, std::int64_t clamped);

    void paint (juce::Graphics&) override;

private:
    float level = 0;
    bool isClamped = false;
};

/** What the panels of settings share, pixels at scale 1. */
inline constexpr int panelRowHeight = 28, panelMargin = 12;
} // namespace antinode
