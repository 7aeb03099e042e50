#include "StandaloneLook.h"

#include <antinode_fonts.h>

#include <string_view>

namespace antinode
{
namespace
{
juce::Typeface::Ptr embedded (std::string_view name)
{
    for (const auto& file : fonts::files())
        if (name == file.name)
            return juce::Typeface::createSystemTypefaceFor (file.begin, file.text().size());

    return nullptr;
}
} // namespace

StandaloneLook::StandaloneLook() : plain (embedded ("DejaVuSans.ttf")), bold (embedded ("DejaVuSans-Bold.ttf"))
{
    setColour (juce::ResizableWindow::backgroundColourId, juce::Colour (0xff1b2226));
    setColour (juce::TextButton::buttonColourId, juce::Colour (0xff34424a));
    setColour (juce::TextButton::buttonOnColourId, warning().darker (0.6F));
    setColour (juce::TabbedComponent::backgroundColourId, juce::Colour (0xff222b30));
    setColour (juce::TabbedComponent::outlineColourId, juce::Colours::transparentBlack);
}

juce::Typeface::Ptr StandaloneLook::getTypefaceForFont (const juce::Font& font)
{
    return font.isBold() ? bold : plain;
}

juce::Font StandaloneLook::getTextButtonFont (juce::TextButton&, int height)
{
    constexpr int big = 40; // pixels
    return height > big ? juce::Font (18, juce::Font::bold) : juce::Font (14);
}
} // namespace antinode
