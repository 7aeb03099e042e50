#pragma once

#include <juce_gui_basics/juce_gui_basics.h>

#include <vector>

namespace antinode
{
/** The commands of a window, from both ends; the theme is one in every window. [message thread] */
class TopBar final : public juce::Component
{
public:
    TopBar();

    juce::TextButton theme;

    /** At the left, after those that are there: narrower where there is no room. */
    void addLeft (juce::Component&, int widest);

    /** At the right, before those that are there. @param gap  beyond it */
    void addRight (juce::Component&, int width, int gap = 6);

    void paint (juce::Graphics&) override;
    void resized() override;

private:
    struct Item
    {
        juce::Component* component;
        int width, gap;
    };

    std::vector<Item> left, right;
};
} // namespace antinode
