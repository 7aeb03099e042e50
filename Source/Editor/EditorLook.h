#pragma once

#include <antinode_reports/Theme.h>
#include <juce_core/juce_core.h>
#include <juce_graphics/juce_graphics.h>
#include <juce_gui_basics/juce_gui_basics.h>

#include <string>

namespace antinode
{
/** The colours of the editor: those of the charts, and what they have no need of. */
struct Palette
{
    Theme charts;         ///< How charts look inside of it.
    juce::Colour window;  ///< Between the panels.
    juce::Colour panel;   ///< The charts' background.
    juce::Colour raised;  ///< Controls.
    juce::Colour outline; ///< Round panels and controls.
    juce::Colour text, mutedText;
    juce::Colour accent;   ///< Values, and what has the keyboard.
    juce::Colour fire;     ///< The wanted spot and what fires it.
    juce::Colour armed;    ///< Outputs that play.
    juce::Colour warning;  ///< Limits, errors, STOP.
    juce::Colour caution;  ///< What plays, but not all of it.
    juce::Colour onStrong; ///< Text on the strong colours above.
    bool isDark = true;

    /** [any] */
    static const Palette& dark();
    static const Palette& light();
};

/** How controls look, in the embedded fonts: JUCE's text is blank on a machine without any. [message thread] */
class EditorLook : public juce::LookAndFeel_V4
{
public:
    static constexpr float textHeight = 13, smallTextHeight = 12;

    EditorLook();

    void setPalette (const Palette&);
    const Palette& palette() const { return *colours; }

    static juce::Font font (float height = textHeight, bool bold = false);

    /** The look of a component inside an editor. */
    static const Palette& findPalette (const juce::Component&);

    juce::Typeface::Ptr getTypefaceForFont (const juce::Font&) override;
    juce::Font getTextButtonFont (juce::TextButton&, int) override { return font(); }
    juce::Font getComboBoxFont (juce::ComboBox&) override { return font (smallTextHeight); }
    juce::Font getPopupMenuFont() override { return font(); }
    juce::Font getLabelFont (juce::Label& label) override { return font (label.getFont().getHeight()); }
    juce::Label* createSliderTextBox (juce::Slider&) override;
    void drawButtonBackground (juce::Graphics&, juce::Button&, const juce::Colour&, bool isOver, bool isDown) override;
    void drawButtonText (juce::Graphics&, juce::TextButton&, bool isOver, bool isDown) override;
    void drawToggleButton (juce::Graphics&, juce::ToggleButton&, bool isOver, bool isDown) override;
    void drawComboBox (juce::Graphics&, int width, int height, bool isDown, int x, int y, int w, int h,
                       juce::ComboBox&) override;
    void positionComboBoxText (juce::ComboBox&, juce::Label&) override;
    void drawLinearSlider (juce::Graphics&, int x, int y, int width, int height, float position, float minimum,
                           float maximum, juce::Slider::SliderStyle, juce::Slider&) override;
    juce::Rectangle<int> getTooltipBounds (const juce::String&, juce::Point<int> at,
                                           juce::Rectangle<int> area) override;
    void drawTooltip (juce::Graphics&, const juce::String&, int width, int height) override;

private:
    void outlineControl (juce::Graphics&, const juce::Component&, juce::Rectangle<float>) const;
    juce::TextLayout tooltipLayout (const juce::String&) const;

    const Palette* colours = &Palette::dark();
};

/** UTF-8 as text for JUCE. [any] */
juce::String fromUtf8 (const std::string& text);
} // namespace antinode
