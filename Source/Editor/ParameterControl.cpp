#include "ParameterControl.h"

#include "EditorLook.h"
#include "ParameterHelp.h"

#include <Processor/StepParameters.h>

namespace antinode
{
namespace
{
constexpr int maximumWords = 12; // longer lists are counts
constexpr int longest = 64;      // of a value's text

/** A slider whose keys are gestures too, and whose value is typed in after Return. */
class Bar : public juce::Slider
{
public:
    explicit Bar (juce::RangedAudioParameter& parameterToSet)
        : Slider (LinearBar, TextBoxRight), parameter (parameterToSet)
    {
        setSliderSnapsToMousePosition (false);
    }

    bool keyPressed (const juce::KeyPress& key) override
    {
        if (key == juce::KeyPress::returnKey)
        {
            showTextBox();
            return true;
        }

        parameter.beginChangeGesture();
        const auto isTaken = Slider::keyPressed (key);
        parameter.endChangeGesture();
        return isTaken;
    }

private:
    juce::RangedAudioParameter& parameter;
};

/** A parameter's range for a slider, which counts in double. */
juce::NormalisableRange<double> parameterRange (const juce::RangedAudioParameter& parameter)
{
    const auto& range = parameter.getNormalisableRange();
    juce::NormalisableRange<double> wide {
        static_cast<double> (range.start), static_cast<double> (range.end),
        [range] (double, double, double share)
        { return static_cast<double> (range.convertFrom0to1 (static_cast<float> (share))); },
        [range] (double, double, double value)
        { return static_cast<double> (range.convertTo0to1 (static_cast<float> (value))); },
        [range] (double, double, double value)
        { return static_cast<double> (range.snapToLegalValue (static_cast<float> (value))); }
    };
    wide.interval = static_cast<double> (range.interval);
    return wide;
}
} // namespace

ParameterControl::ParameterControl (juce::RangedAudioParameter& parameterToSet)
    : parameter (parameterToSet), link (parameter, [this] (float value) { show (value); })
{
    name.setText (parameter.getName (longest), juce::dontSendNotification);
    name.setFont (EditorLook::font (EditorLook::smallTextHeight));
    name.setBorderSize ({ 0, 0, 0, 4 });
    name.setMinimumHorizontalScale (1);
    name.setInterceptsMouseClicks (false, false);
    addAndMakeVisible (name);
    const auto range = parameter.getNormalisableRange();
    const auto words = static_cast<int> (range.end - range.start) + 1;

    if (dynamic_cast<SwitchParameter*> (&parameter) != nullptr)
        makeSwitch();
    else if (dynamic_cast<IntegerParameter*> (&parameter) != nullptr && words <= maximumWords)
        makeList (words);
    else
        makeBar();

    input->setTitle (parameter.getName (longest));
    input->setComponentID (parameter.getParameterID());
    input->setWantsKeyboardFocus (true);
    addAndMakeVisible (*input);
    refresh();
}

ParameterControl::~ParameterControl() = default;

void ParameterControl::makeBar()
{
    auto bar = std::make_unique<Bar> (parameter);
    bar->setTooltip (helpText (parameter) + "\nDrag, or click to type a value.");
    bar->valueFromTextFunction = [this] (const juce::String& text)
    { return static_cast<double> (parameter.convertFrom0to1 (parameter.getValueForText (text))); };
    bar->textFromValueFunction = [this] (double value)
    { return parameter.getText (parameter.convertTo0to1 (static_cast<float> (value)), 0); };
    bar->setNormalisableRange (parameterRange (parameter));
    bar->setDoubleClickReturnValue (true,
                                    static_cast<double> (parameter.convertFrom0to1 (parameter.getDefaultValue())));
    bar->onDragStart = [this] { link.beginGesture(); };
    bar->onValueChange = [this, set = bar.get()] { link.set (static_cast<float> (set->getValue())); };
    bar->onDragEnd = [this] { link.endGesture(); };
    input = std::move (bar);
}

void ParameterControl::makeList (int words)
{
    auto list = std::make_unique<juce::ComboBox>();

    for (int i = 0; i < words; ++i)
        list->addItem (parameter.getText (parameter.convertTo0to1 (static_cast<float> (i)), longest), i + 1);

    list->setTooltip (helpText (parameter));
    list->onChange = [this, set = list.get()]
    { link.setAsGesture (parameter.getNormalisableRange().start + static_cast<float> (set->getSelectedItemIndex())); };
    input = std::move (list);
}

void ParameterControl::makeSwitch()
{
    auto button = std::make_unique<juce::ToggleButton>();
    button->setTooltip (helpText (parameter));
    button->onClick = [this, set = button.get()]
    {
        link.setAsGesture (set->getToggleState() ? 1.0f : 0.0f);
        refreshText();
    };
    input = std::move (button);
}

void ParameterControl::show (float value)
{
    if (auto* const bar = dynamic_cast<juce::Slider*> (input.get()))
        bar->setValue (static_cast<double> (value), juce::dontSendNotification);
    else if (auto* const list = dynamic_cast<juce::ComboBox*> (input.get()))
        list->setSelectedItemIndex (juce::roundToInt (value - parameter.getNormalisableRange().start),
                                    juce::dontSendNotification);
    else if (auto* const button = dynamic_cast<juce::ToggleButton*> (input.get()))
    {
        button->setToggleState (value >= 0.5f, juce::dontSendNotification);
        refreshText();
    }
}

void ParameterControl::refreshText()
{
    if (auto* const bar = dynamic_cast<juce::Slider*> (input.get()))
    {
        bar->updateText();
        bar->setTooltip (helpText (parameter) + "\nDrag, or click to type a value.");
    }
    else if (auto* const button = dynamic_cast<juce::ToggleButton*> (input.get()))
        button->setButtonText (parameter.getCurrentValueAsText());
}

bool ParameterControl::isAlongY() const
{
    const auto identifier = parameter.getParameterID();
    return identifier == "y" || identifier.endsWith ("_y");
}

void ParameterControl::resized()
{
    constexpr int nameWidth = 112;
    auto area = getLocalBounds();
    name.setBounds (area.removeFromLeft (nameWidth));
    input->setBounds (area);
}
} // namespace antinode
