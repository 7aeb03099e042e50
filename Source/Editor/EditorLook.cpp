#include "EditorLook.h"

#include <antinode_fonts.h>

#include <cmath>

namespace antinode
{
namespace
{
juce::Colour rgb (juce::uint32 value)
{
    return juce::Colour (0xFF000000U | value);
}

Palette fromCharts (const Theme& charts)
{
    Palette palette {
        compact (charts), {}, charts.background, {}, {}, charts.text, charts.mutedText, {}, {}, {}, {}, {}, {}
    };
    palette.charts.padding = 8;
    palette.charts.labelHeight = 12;
    palette.warning = charts.limit;
    return palette;
}

Palette makeDark()
{
    auto palette = fromCharts (Theme::dark());
    palette.window = rgb (0x0C0F13);
    palette.raised = rgb (0x212831);
    palette.outline = rgb (0x2F3843);
    palette.accent = rgb (0x56B4E9);
    palette.fire = rgb (0xF5853F);
    palette.armed = rgb (0x2FC19A);
    palette.caution = rgb (0xE8B33B);
    palette.onStrong = rgb (0x0C0F13);
    return palette;
}

Palette makeLight()
{
    auto palette = fromCharts (Theme::light());
    palette.window = rgb (0xE3E8ED);
    palette.raised = rgb (0xEEF1F5);
    palette.outline = rgb (0xC6CED7);
    palette.accent = rgb (0x0072B2);
    palette.fire = rgb (0xB94F00);
    palette.armed = rgb (0x00795A);
    palette.caution = rgb (0x855E00);
    palette.onStrong = rgb (0xFFFFFF);
    palette.isDark = false;
    return palette;
}
} // namespace

const Palette& Palette::dark()
{
    static const auto palette = makeDark();
    return palette;
}

const Palette& Palette::light()
{
    static const auto palette = makeLight();
    return palette;
}

namespace
{
constexpr auto corner = 4.0f;
constexpr auto tooltipWidth = 320.0f;

/** The embedded fonts as JUCE's typefaces; freed with JUCE's own shared objects. */
class Typefaces : private juce::DeletedAtShutdown
{
public:
    ~Typefaces() override { clearSingletonInstance(); }

    juce::Typeface::Ptr regular = load ("DejaVuSans.ttf"), bold = load ("DejaVuSans-Bold.ttf");

    JUCE_DECLARE_SINGLETON (Typefaces, false)

private:
    static juce::Typeface::Ptr load (std::string_view name)
    {
        for (const auto& file : fonts::files())
            if (name == file.name)
                return juce::Typeface::createSystemTypefaceFor (file.begin, file.text().size());

        return {};
    }
};

JUCE_IMPLEMENT_SINGLETON (Typefaces)
} // namespace

EditorLook::EditorLook()
{
    setPalette (*colours);
}

void EditorLook::setPalette (const Palette& palette)
{
    colours = &palette;
    setColourScheme ({ palette.window, palette.raised, palette.raised, palette.outline, palette.text, palette.accent,
                       palette.onStrong, palette.accent, palette.text });
    setColour (juce::Label::textColourId, palette.text);
    setColour (juce::Label::textWhenEditingColourId, palette.text);
    setColour (juce::Slider::textBoxTextColourId, palette.text);
    setColour (juce::Slider::textBoxOutlineColourId, juce::Colours::transparentBlack);
    setColour (juce::Slider::textBoxBackgroundColourId, juce::Colours::transparentBlack);
    setColour (juce::TextEditor::backgroundColourId, palette.raised);
    setColour (juce::TextEditor::outlineColourId, palette.outline);
    setColour (juce::TextEditor::focusedOutlineColourId, palette.accent);
    setColour (juce::TextEditor::highlightColourId, palette.accent.withAlpha (0.4f));
    setColour (juce::TextEditor::highlightedTextColourId, palette.text);
    setColour (juce::ListBox::backgroundColourId, palette.panel);
    setColour (juce::ScrollBar::thumbColourId, palette.mutedText.withAlpha (0.5f));
    setColour (juce::PopupMenu::backgroundColourId, palette.raised);
    setColour (juce::PopupMenu::highlightedBackgroundColourId, palette.accent);
    setColour (juce::PopupMenu::highlightedTextColourId, palette.onStrong);
    setColour (juce::CaretComponent::caretColourId, palette.text);
}

juce::Font EditorLook::font (float height, bool bold)
{
    const auto& typefaces = *Typefaces::getInstance();
    return juce::Font (bold ? typefaces.bold : typefaces.regular).withHeight (height);
}

const Palette& EditorLook::findPalette (const juce::Component& component)
{
    const auto* const look = dynamic_cast<const EditorLook*> (&component.getLookAndFeel());
    return look != nullptr ? look->palette() : Palette::dark();
}

juce::Typeface::Ptr EditorLook::getTypefaceForFont (const juce::Font& wanted)
{
    const auto& typefaces = *Typefaces::getInstance();
    return wanted.isBold() ? typefaces.bold : typefaces.regular;
}

juce::Label* EditorLook::createSliderTextBox (juce::Slider& slider)
{
    auto* const label = LookAndFeel_V4::createSliderTextBox (slider);
    label->setFont (font (smallTextHeight));
    label->setColour (juce::Label::textColourId, colours->text);
    label->setJustificationType (juce::Justification::centredRight);
    label->setBorderSize ({ 0, 6, 0, 6 });
    return label;
}

void EditorLook::outlineControl (juce::Graphics& g, const juce::Component& component, juce::Rectangle<float> area) const
{
    const auto hasKeys = component.hasKeyboardFocus (true);
    g.setColour (hasKeys ? colours->accent : colours->outline);
    g.drawRoundedRectangle (area.reduced (hasKeys ? 0.75f : 0.5f), corner, hasKeys ? 1.5f : 1.0f);
}

void EditorLook::drawButtonBackground (juce::Graphics& g, juce::Button& button, const juce::Colour& fill, bool isOver,
                                       bool isDown)
{
    const auto area = button.getLocalBounds().toFloat();
    auto colour = fill;

    if (! button.isEnabled())
        colour = colour.withMultipliedAlpha (0.5f);
    else if (isDown)
        colour = colour.contrasting (0.18f);
    else if (isOver)
        colour = colour.contrasting (0.08f);

    g.setColour (colour);
    g.fillRoundedRectangle (area.reduced (0.5f), corner);
    outlineControl (g, button, area);
}

void EditorLook::drawButtonText (juce::Graphics& g, juce::TextButton& button, bool, bool)
{
    const auto id = button.getToggleState() ? juce::TextButton::textColourOnId : juce::TextButton::textColourOffId;
    // Signs and the words that matter most.
    const auto& text = button.getButtonText();
    const auto isSign = text.length() == 1, isLoud = text.length() > 1 && text == text.toUpperCase();
    g.setFont (font (isSign ? 18.0f : textHeight, isLoud));
    g.setColour (button.findColour (id).withMultipliedAlpha (button.isEnabled() ? 1.0f : 0.4f));
    g.drawText (text, button.getLocalBounds().reduced (4, 0), juce::Justification::centred);
}

void EditorLook::drawToggleButton (juce::Graphics& g, juce::ToggleButton& button, bool isOver, bool)
{
    auto area = button.getLocalBounds().toFloat();
    const auto height = std::min (16.0f, area.getHeight() - 4);
    const auto track = area.removeFromLeft (1.8f * height + 2).withSizeKeepingCentre (1.8f * height, height);
    const auto isOn = button.getToggleState();
    g.setColour (isOn ? colours->accent : colours->raised.contrasting (isOver ? 0.1f : 0.0f));
    g.fillRoundedRectangle (track, height / 2);
    g.setColour (button.hasKeyboardFocus (true) ? colours->text : colours->outline);
    g.drawRoundedRectangle (track, height / 2, 1);
    const auto knob = track.withWidth (height).translated (isOn ? track.getWidth() - height : 0, 0).reduced (3);
    g.setColour (isOn ? colours->onStrong : colours->mutedText);
    g.fillEllipse (knob);
    g.setColour (colours->text.withMultipliedAlpha (button.isEnabled() ? 1.0f : 0.4f));
    g.setFont (font (smallTextHeight));
    g.drawText (button.getButtonText(), area.withTrimmedLeft (6), juce::Justification::centredLeft);
}

void EditorLook::drawComboBox (juce::Graphics& g, int width, int height, bool, int, int, int, int, juce::ComboBox& box)
{
    const auto area = juce::Rectangle<int> (width, height).toFloat();
    g.setColour (colours->raised);
    g.fillRoundedRectangle (area.reduced (0.5f), corner);
    outlineControl (g, box, area);
    juce::Path arrow;
    const auto centre = juce::Point<float> (area.getRight() - 11, area.getCentreY());
    arrow.addTriangle (centre.translated (-3.5f, -2), centre.translated (3.5f, -2), centre.translated (0, 3));
    g.setColour (colours->mutedText);
    g.fillPath (arrow);
}

void EditorLook::positionComboBoxText (juce::ComboBox& box, juce::Label& label)
{
    label.setBounds (box.getLocalBounds().withTrimmedRight (18));
    label.setFont (getComboBoxFont (box));
    label.setBorderSize ({ 0, 6, 0, 0 });
    label.setMinimumHorizontalScale (1);
}

void EditorLook::drawLinearSlider (juce::Graphics& g, int x, int y, int width, int height, float position, float, float,
                                   juce::Slider::SliderStyle style, juce::Slider& slider)
{
    const auto area = juce::Rectangle<int> (x, y, width, height).toFloat();
    const auto isBar = style == juce::Slider::LinearBar;
    const auto track = isBar ? area.reduced (0.5f) : area.withSizeKeepingCentre (area.getWidth(), 4);
    const auto whole = isBar ? slider.getLocalBounds().toFloat() : track;
    g.setColour (colours->raised);
    g.fillRoundedRectangle (isBar ? whole.reduced (0.5f) : track, isBar ? corner : 2);
    {
        const juce::Graphics::ScopedSaveState state (g);
        juce::Path clip;
        clip.addRoundedRectangle (track, isBar ? corner : 2);
        g.reduceClipRegion (clip);
        g.setColour (colours->accent.withAlpha (! slider.isEnabled() ? 0.1f : isBar ? 0.3f : 0.9f));
        g.fillRect (track.withRight (position));
    }

    if (isBar)
    {
        outlineControl (g, slider, whole);
        return;
    }

    g.setColour (slider.hasKeyboardFocus (true) ? colours->text : colours->accent);
    g.fillEllipse (juce::Rectangle<float> (12, 12).withCentre ({ position, area.getCentreY() }));
}

juce::TextLayout EditorLook::tooltipLayout (const juce::String& text) const
{
    juce::AttributedString words;
    words.setJustification (juce::Justification::centredLeft);
    words.append (text, font (smallTextHeight), colours->text);
    juce::TextLayout layout;
    layout.createLayout (words, tooltipWidth);
    return layout;
}

juce::Rectangle<int> EditorLook::getTooltipBounds (const juce::String& text, juce::Point<int> at,
                                                   juce::Rectangle<int> area)
{
    const auto layout = tooltipLayout (text);
    const auto width = static_cast<int> (std::ceil (layout.getWidth())) + 18;
    const auto height = static_cast<int> (std::ceil (layout.getHeight())) + 12;
    return juce::Rectangle<int> (at.x > area.getCentreX() ? at.x - width - 8 : at.x + 16,
                                 at.y > area.getCentreY() ? at.y - height - 8 : at.y + 12, width, height)
        .constrainedWithin (area);
}

void EditorLook::drawTooltip (juce::Graphics& g, const juce::String& text, int width, int height)
{
    const auto area = juce::Rectangle<int> (width, height).toFloat();
    g.setColour (colours->panel);
    g.fillRect (area);
    g.setColour (colours->outline);
    g.drawRect (area, 1);
    tooltipLayout (text).draw (g, area.reduced (9, 6));
}

juce::String fromUtf8 (const std::string& text)
{
    return juce::String::fromUTF8 (text.c_str());
}
} // namespace antinode
