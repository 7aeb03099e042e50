#pragma once

#include "InputView.h"

#include <juce_gui_basics/juce_gui_basics.h>

#include <array>

namespace antinode
{
/** The audio device and its settings. JUCE's own panel is not used, because it has a button that plays half of full
    scale past the router. */
class AudioPanel final : public juce::Component
{
public:
    /** @param hostToUse  outlives this [message thread] */
    explicit AudioPanel (AudioHost& hostToUse);

    /** Shows what is open, and what there is. [message thread] */
    void update();

    void lookAndFeelChanged() override;
    void resized() override;

private:
    void updateDevices (const AudioChoice&);
    void updateFormat (const AudioChoice&);
    void open (const AudioChoice&);
    AudioChoice shownFormat() const;
    bool isPlaying() const;

    AudioHost& host;
    juce::ComboBox type, device, rate, block, outputs, input;
    std::array<juce::Label, 6> names;
    juce::TextButton refresh { "Refresh" };
    juce::Label failure;
    InputView inputView;
    std::string shownType;   ///< Also where its device does not play.
    std::string scannedType; ///< Of the next line.
    std::vector<std::string> scannedDevices;
};
} // namespace antinode
