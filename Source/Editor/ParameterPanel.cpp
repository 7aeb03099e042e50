#include "ParameterPanel.h"

#include "EditorLook.h"

#include <Processor/ParameterTypes.h>

#include <algorithm>
#include <map>
#include <utility>

namespace antinode
{
namespace
{
const std::map<juce::String, const char*>& effects()
{
    static const std::map<juce::String, const char*> texts {
        { "x", "Position of the focus from left to right. Arrow keys on the surface also move it." },
        { "y", "Position of the focus from the lower edge upwards. Has no effect on a line." },
        { "width", "Full width of the focus at half maximum. Narrow foci need more modes." },
        { "shape", "Shape of the focus around its centre." },
        { "peak_velocity", "Velocity at the centre of the focus. Voltages are proportional to it." },
        { "focus_time", "Time from the trigger to the focus. More time needs less voltage." },
        { "growth",
          "Growth of the drives before the focus. Large values start late and keep the rest of the surface calmer." },
        { "brake", "Decay after the focus as a multiple of the free decay." },
        { "method", "Method that allocates the voltages to the ceramics." },
        { "voltage_limit", "Largest voltage of every ceramic. A lower limit allows less velocity." },
        { "modes", "Number of controlled modes. More modes make a sharper focus and need more voltage." },
        { "notes", "What notes play: the focus at positions spread over the surface, or always at its own position." },
        { "note_off", "Effect of a note-off on the focus that the note started." },
        { "retrigger", "Effect of a trigger while its focus still plays." },
        { "focus_on_note", "Whether the focus falls on the note; the latency is then the focus time." },
        { "probe_x", "Position of the probe from left to right. The probe can be dragged on the surface." },
        { "probe_y", "Position of the probe from the lower edge upwards." },
        { "monitor_gain", "Gain of the probe velocities on the monitor bus; at 0 dB, 1.0 is 1 m/s." },
        { "output_trim", "Gain of all voltages. Below 0 dB the velocity decreases in proportion." },
        { "arm", "If disarmed, all ceramics stay at 0 V. Key: A" },
        { "bypass", "If bypassed by the host, all ceramics stay at 0 V." },
        { "finger_x", "Place of the finger from left to right. It can be dragged on the surface." },
        { "finger_y", "Place of the finger from the lower edge upwards. Has no effect on a line." },
        { "finger_state", "Absent: nowhere. Silent: it rests and is to feel nothing. Plays: it feels its input." },
        { "finger_level", "Displacement of the surface under the finger where its input is 1.0." },
        { "finger_load", "What the finger is to the surface; the filters then know it." },
        { "latency", "From an input to the motion, reported to the host. 5 ms needs most volts." },
        { "gain", "Factor of all levels." },
    };
    return texts;
}

/** The effect of a parameter and its range with the unit, for tooltips and screen readers. */
juce::String helpText (const juce::RangedAudioParameter& parameter)
{
    constexpr int longest = 40;
    const auto identifier = parameter.getParameterID();
    const auto isOfFinger = identifier.startsWith ("finger"); // finger3_x
    const auto found =
        effects().find (isOfFinger ? "finger" + identifier.fromFirstOccurrenceOf ("_", true, false) : identifier);
    const auto effect = found == effects().end() ? juce::String() : juce::String (found->second) + "\n";
    return effect + "From " + parameter.getText (0, longest) + " to " + parameter.getText (1, longest) + ".";
}

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
        setScrollWheelEnabled (false); // The wheel scrolls the panel.
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

ParameterLink::ParameterLink (juce::RangedAudioParameter& parameterToShow, std::function<void (float)> show)
    : parameter (parameterToShow), showValue (std::move (show))
{
}

void ParameterLink::refresh()
{
    const auto now = parameter.getValue();

    if (std::exchange (shown, now) != now)
        showValue (parameter.convertFrom0to1 (now));
}

void ParameterLink::set (float value)
{
    if (const auto wanted = parameter.convertTo0to1 (value); wanted != parameter.getValue())
        parameter.setValueNotifyingHost (wanted);
}

void ParameterLink::setAsGesture (float value)
{
    beginGesture();
    set (value);
    endGesture();
}

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
    {
        const auto share = parameter.convertTo0to1 (static_cast<float> (value));
        return instead.isNotEmpty() && share == insteadAt ? instead : parameter.getText (share, 0);
    };
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
    const auto& steps = dynamic_cast<const IntegerParameter&> (parameter);

    for (int i = 0; i < words; ++i)
        if (steps.offers (i))
            list->addItem (parameter.getText (parameter.convertTo0to1 (static_cast<float> (i)), longest), i + 1);

    list->setTooltip (helpText (parameter));
    list->onChange = [this, set = list.get()]
    { link.setAsGesture (parameter.getNormalisableRange().start + static_cast<float> (set->getSelectedId() - 1)); };
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

/** A value that is not offered is none of the list, so that any of it can be chosen. */
void ParameterControl::showWord (juce::ComboBox& list, int step)
{
    if (list.indexOfItemId (step + 1) >= 0)
        list.setSelectedId (step + 1, juce::dontSendNotification);
    else
        list.setText (parameter.getCurrentValueAsText(), juce::dontSendNotification);
}

void ParameterControl::show (float value)
{
    if (auto* const bar = dynamic_cast<juce::Slider*> (input.get()))
        bar->setValue (static_cast<double> (value), juce::dontSendNotification);
    else if (auto* const list = dynamic_cast<juce::ComboBox*> (input.get()))
        showWord (*list, juce::roundToInt (value - parameter.getNormalisableRange().start));
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

void ParameterControl::showInstead (const juce::String& text)
{
    const auto now = parameter.convertTo0to1 (parameter.convertFrom0to1 (parameter.getValue()));

    if (instead == text && insteadAt == now)
        return;

    instead = text;
    insteadAt = now;
    refreshText();
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

namespace
{
constexpr int panelRowHeight = 21, minimumGap = 3, largestGap = 8, headingHeight = 22, groupGap = 3, panelMargin = 10;
} // namespace

ParameterPanel::ParameterPanel (AntinodeProcessor& processor)
{
    setTitle ("Parameters");
    setFocusContainerType (FocusContainerType::focusContainer);

    for (const auto* const group : processor.getParameterTree().getSubgroups (false))
    {
        groups.push_back ({ group->getName(), all.size(), 0, {} });

        for (auto* const parameter : group->getParameters (false))
        {
            all.push_back (std::make_unique<ParameterControl> (dynamic_cast<juce::RangedAudioParameter&> (*parameter)));
            addAndMakeVisible (*all.back());
            ++groups.back().count;
        }
    }
}

void ParameterPanel::refresh()
{
    for (const auto& control : all)
        control->refresh();
}

void ParameterPanel::refreshTexts (bool isLine)
{
    for (const auto& control : all)
    {
        control->refreshText();
        control->setEnabled (! (isLine && control->isAlongY()));
    }
}

void ParameterPanel::showInstead (const juce::String& identifier, const juce::String& text)
{
    for (const auto& control : all)
        if (control->control().getComponentID() == identifier)
            control->showInstead (text);
}

int ParameterPanel::layOut (int width, int minimumHeight)
{
    const auto rows = static_cast<int> (all.size()), parts = static_cast<int> (groups.size());
    const auto others = panelMargin / 2 + parts * (headingHeight + groupGap) + rows * panelRowHeight;
    const auto rowGap = rows > 0 ? juce::jlimit (minimumGap, largestGap, (minimumHeight - others) / rows) : 0;
    auto y = panelMargin / 2;

    for (auto& group : groups)
    {
        group.heading = { panelMargin, y, width - 2 * panelMargin, headingHeight };
        y += headingHeight;

        for (auto i = group.first; i < group.first + group.count; ++i)
        {
            all[i]->setBounds (panelMargin, y, width - 2 * panelMargin, panelRowHeight);
            y += panelRowHeight + rowGap;
        }

        y += groupGap;
    }

    setSize (width, std::max (y, minimumHeight));
    return y;
}

void ParameterPanel::paint (juce::Graphics& g)
{
    const auto& palette = EditorLook::findPalette (*this);
    g.fillAll (palette.panel);
    g.setFont (EditorLook::font (EditorLook::smallTextHeight, true));

    for (const auto& group : groups)
    {
        g.setColour (palette.mutedText);
        g.drawText (group.name, group.heading, juce::Justification::centredLeft);
    }
}
} // namespace antinode
