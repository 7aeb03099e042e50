#pragma once

#include <juce_gui_basics/juce_gui_basics.h>

#include <catch2/catch.hpp>

#include <chrono>
#include <functional>
#include <set>
#include <thread>

namespace antinode::test
{
/** Lets an editor's content look until something is reached, a minute at most. */
template <typename Content>
void refreshUntil (Content& content, const std::function<bool()>& isReached)
{
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds (60);

    do
    {
        REQUIRE (std::chrono::steady_clock::now() < end);
        std::this_thread::sleep_for (std::chrono::milliseconds (2));
        content.refresh (0.002);
    } while (! isReached());
}

/** What a mouse does to a component. */
inline juce::MouseEvent mouseAt (juce::Component& component, juce::Point<float> place, juce::Point<float> pressedAt)
{
    const auto now = juce::Time::getCurrentTime();
    return { juce::Desktop::getInstance().getMainMouseSource(),
             place,
             juce::ModifierKeys::leftButtonModifier,
             0,
             0,
             0,
             0,
             0,
             &component,
             &component,
             now,
             pressedAt,
             now,
             1,
             place != pressedAt };
}

/** A mouse that is pressed where it is. */
inline juce::MouseEvent mouseAt (juce::Component& component, juce::Point<float> place)
{
    return mouseAt (component, place, place);
}

/** A component and all that is visible in it. */
inline void forEachShown (juce::Component& component, const std::function<void (juce::Component&)>& look)
{
    look (component);

    for (auto* const child : component.getChildren())
        if (child->isVisible())
            forEachShown (*child, look);
}

/** How many colours a picture has: nothing drawn has few. */
inline int countColours (const juce::Image& image)
{
    std::set<juce::uint32> colours;

    for (int y = 0; y < image.getHeight(); y += 2)
        for (int x = 0; x < image.getWidth(); x += 2)
            colours.insert (image.getPixelAt (x, y).getARGB());

    return static_cast<int> (colours.size());
}
} // namespace antinode::test
