#include "PlainPanel.h"

#include "StandaloneLook.h"

namespace antinode
{
PlainPanel::PlainPanel (StandaloneHost& hostToUse) : host (hostToUse)
{
    arm.onClick = [this]
    {
        auto& armed = host.processor().parameters().arm();
        armed.setValueNotifyingHost (armed.get() ? 0.0F : 1.0F);
    };
    fire.onClick = [this] { host.processor().session().fire (1); };
    fire.setColour (juce::TextButton::buttonColourId, StandaloneLook::ready());
    status.setJustificationType (juce::Justification::centred);

    for (auto* const child : std::initializer_list<juce::Component*> { &status, &arm, &fire })
        addAndMakeVisible (child);

    showState();
    startTimerHz (10);
}

void PlainPanel::showState()
{
    const auto now = host.processor().session().snapshot();
    const auto isArmed = host.processor().parameters().arm().get();
    arm.setButtonText (isArmed ? "DISARM" : "ARM");
    fire.setEnabled (isArmed);
    status.setText (now->model == nullptr ? juce::String ("Solving the device")
                                          : juce::String (now->model->name) + ", " + juce::String (now->focus.name)
                                                + (isArmed ? ": armed" : ": disarmed, outputs are at 0 V"),
                    juce::dontSendNotification);
}

void PlainPanel::resized()
{
    auto area = getLocalBounds().withSizeKeepingCentre (260, 210);
    status.setBounds (area.removeFromTop (40).withX (0).withWidth (getWidth()));
    arm.setBounds (area.removeFromTop (60));
    area.removeFromTop (10);
    fire.setBounds (area);
}
} // namespace antinode
