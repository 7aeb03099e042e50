#include "FingerPanel.h"

#include <Editor/EditorLook.h>

namespace antinode
{
namespace
{
constexpr int controlHeight = 21, controlGap = 4, fingerHeading = 26, fingerMargin = 10;
} // namespace

FingerPanel::FingerPanel (TouchParameters& parameters)
{
    setTitle ("Fingers and output");
    setFocusContainerType (FocusContainerType::focusContainer);

    for (std::size_t k = 0; k < buttons.size(); ++k)
    {
        buttons[k].setButtonText (juce::String (k + 1));
        buttons[k].setTitle ("Finger " + juce::String (k + 1));
        buttons[k].setTooltip ("Shows the controls of finger " + juce::String (k + 1));
        buttons[k].onClick = [this, k] { select (k); };
        addAndMakeVisible (buttons[k]);
        const auto& finger = parameters.finger (k);

        for (juce::RangedAudioParameter* const parameter : std::initializer_list<juce::RangedAudioParameter*> {
                 finger.presence, finger.x, finger.y, finger.level, finger.load })
        {
            fingers.push_back (std::make_unique<ParameterControl> (*parameter));
            addChildComponent (*fingers.back());
        }
    }

    for (juce::RangedAudioParameter* const parameter : std::initializer_list<juce::RangedAudioParameter*> {
             &parameters.latency(), &parameters.gain(), &parameters.arm(), &parameters.bypass() })
    {
        output.push_back (std::make_unique<ParameterControl> (*parameter));
        addAndMakeVisible (*output.back());
    }

    select (0);
}

void FingerPanel::select (std::size_t finger)
{
    shown = finger;

    for (std::size_t i = 0; i < fingers.size(); ++i)
        fingers[i]->setVisible (i / perFinger == shown);

    lookAndFeelChanged();
}

void FingerPanel::lookAndFeelChanged()
{
    const auto& palette = EditorLook::findPalette (*this);

    for (std::size_t k = 0; k < buttons.size(); ++k)
    {
        buttons[k].setColour (juce::TextButton::buttonColourId, k == shown ? palette.accent : palette.raised);
        buttons[k].setColour (juce::TextButton::textColourOffId, k == shown ? palette.onStrong : palette.text);
    }

    repaint();
}

void FingerPanel::refresh()
{
    for (std::size_t i = 0; i < perFinger; ++i)
        fingers[shown * perFinger + i]->refresh();

    for (const auto& control : output)
        control->refresh();
}

void FingerPanel::refreshTexts (bool isLine)
{
    for (const auto& control : fingers)
    {
        control->refreshText();
        control->setEnabled (! (isLine && control->isAlongY()));
    }
}

int FingerPanel::height()
{
    return 2 * fingerHeading + static_cast<int> (perFinger + ofOutput) * (controlHeight + controlGap) + controlGap;
}

void FingerPanel::resized()
{
    auto area = getLocalBounds().reduced (fingerMargin, 0);
    auto heading = area.removeFromTop (fingerHeading).withTrimmedLeft (60).reduced (0, 3);
    const auto width = heading.getWidth() / mostFingers;

    for (auto& button : buttons)
        button.setBounds (heading.removeFromLeft (width).reduced (1, 0));

    const auto row = [&]
    {
        const auto bounds = area.removeFromTop (controlHeight);
        area.removeFromTop (controlGap);
        return bounds;
    };

    for (std::size_t i = 0; i < perFinger; ++i)
    {
        const auto bounds = row(); // Of all fingers: one is visible.

        for (auto each = i; each < fingers.size(); each += perFinger)
            fingers[each]->setBounds (bounds);
    }

    area.removeFromTop (fingerHeading);

    for (const auto& control : output)
        control->setBounds (row());
}

void FingerPanel::paint (juce::Graphics& g)
{
    const auto& palette = EditorLook::findPalette (*this);
    g.fillAll (palette.panel);
    g.setColour (palette.mutedText);
    g.setFont (EditorLook::font (EditorLook::smallTextHeight, true));
    auto area = getLocalBounds().reduced (fingerMargin, 0);
    g.drawText ("Finger", area.removeFromTop (fingerHeading), juce::Justification::centredLeft);
    area.removeFromTop (static_cast<int> (perFinger) * (controlHeight + controlGap));
    g.drawText ("Output", area.removeFromTop (fingerHeading), juce::Justification::centredLeft);
}
} // namespace antinode
