#include "ParameterControl.h"

#include "EditorLook.h"
#include "ParameterHelp.h"

namespace antinode
{
namespace
{
constexpr int mostWords = 12; // longer lists are counts
constexpr int longest = 64;   // of a value's text

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
} // namespace

ParameterControl::ParameterControl (juce::RangedAudioParameter& parameterToSet) : parameter (parameterToSet)
{
    name.setText (parameter.getName (longest), juce::dontSendNotification);
    name.setFont (EditorLook::font (EditorLook::smallTextHeight));
    name.setBorderSize ({ 0, 0, 0, 4 });
    name.setMinimumHorizontalScale (1);
    name.setInterceptsMouseClicks (false, false);
    addAndMakeVisible (name);
    const auto range = parameter.getNormalisableRange();
    const auto words = static_cast<int> (range.end - range.start) + 1;

    if (dynamic_cast<juce::AudioParameterBool*> (&parameter) != nullptr)
        makeSwitch();
    else if (dynamic_cast<juce::AudioParameterInt*> (&parameter) != nullptr && words <= mostWords)
        makeList (words);
    else
        makeBar();

    input->setTitle (parameter.getName (longest));
    input->setComponentID (parameter.getParameterID());
    input->setWantsKeyboardFocus (true);
    addAndMakeVisible (*input);
}

ParameterControl::~ParameterControl() = default;

void ParameterControl::makeBar()
{
    auto bar = std::make_unique<Bar> (parameter);
    bar->setTooltip (helpOf (parameter) + "\nDrag, or click to type a value.");
    barAttachment = std::make_unique<juce::SliderParameterAttachment> (parameter, *bar);
    input = std::move (bar);
}

void ParameterControl::makeList (int words)
{
    auto list = std::make_unique<juce::ComboBox>();

    for (int i = 0; i < words; ++i)
        list->addItem (parameter.getText (parameter.convertTo0to1 (static_cast<float> (i)), longest), i + 1);

    list->setTooltip (helpOf (parameter));
    listAttachment = std::make_unique<juce::ComboBoxParameterAttachment> (parameter, *list);
    input = std::move (list);
}

void ParameterControl::makeSwitch()
{
    auto button = std::make_unique<juce::ToggleButton>();
    button->setTooltip (helpOf (parameter));
    button->onStateChange = [this] { refreshText(); };
    switchAttachment = std::make_unique<juce::ButtonParameterAttachment> (parameter, *button);
    button->setButtonText (parameter.getCurrentValueAsText());
    input = std::move (button);
}

void ParameterControl::refreshText()
{
    if (auto* const bar = dynamic_cast<juce::Slider*> (input.get()))
    {
        bar->updateText();
        bar->setTooltip (helpOf (parameter) + "\nDrag, or click to type a value.");
    }
    else if (auto* const button = dynamic_cast<juce::ToggleButton*> (input.get()))
        button->setButtonText (parameter.getCurrentValueAsText());
}

void ParameterControl::resized()
{
    constexpr int nameWidth = 112;
    auto area = getLocalBounds();
    name.setBounds (area.removeFromLeft (nameWidth));
    input->setBounds (area);
}
} // namespace antinode
