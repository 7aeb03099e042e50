#pragma once

#include <juce_gui_basics/juce_gui_basics.h>

namespace antinode
{
/** How the program's own controls look: dark, in the embedded fonts, since JUCE's text is blank on a machine without any. [message thread] */
class StandaloneLook : public juce::LookAndFeel_V4
{
public:
    StandaloneLook();

    juce::Typeface::Ptr getTypefaceForFont (const juce::Font&) override;

    /** Big buttons speak loudly. */
    juce::Font getTextButtonFont (juce::TextButton&, int height) override;

    static juce::Colour danger() { return juce::Colour (0xffc62828); }
    static juce::Colour ready() { return juce::Colour (0xff2e7d32); }
    static juce::Colour warning() { return juce::Colour (0xffffb74d); }
    static juce::Colour quietText() { return juce::Colour (0xff9aa5ad); }

private:
    juce::Typeface::Ptr plain, bold;
};
} // namespace antinode
