#pragma once

#include "AudioHost.h"
#include "MidiInputs.h"
#include "TouchInput.h"

#include <Processor/AntinodeProcessor.h>

namespace antinode
{
/** The standalone program without its windows, playing foci: processor, MIDI, touch, and what all have. */
class StandaloneHost : public AudioHost
{
public:
    /** As AudioHost. [message thread] */
    StandaloneHost (SettingsFile, bool keepsSettings);
    ~StandaloneHost() override;

    AntinodeProcessor& processor() { return player; }
    MidiInputs& midi() { return midiInputs; }
    TouchInput& touch() { return touchInput; }

    void setTouch (const TouchPorts&) override;
    void setMidi (const MidiChoice&);
    void openAll (const StandaloneSettings&) override;
    void shutDown() override;

    /** Puts touches that rest on the surface as fingers, and lifts those that have left, where that is due. The host
        does so itself 20 times a second. [message thread] */
    void restTouches();

    std::shared_ptr<const ModalModel> model() override { return player.session().snapshot()->model; }
    double fullScaleVolts() override { return player.session().fullScaleVolts(); }
    SwitchParameter& arm() override { return player.parameters().arm(); }
    void stopAll() override { player.session().stopAll(); }
    LevelMeters& meters() override { return player.session().meters(); }
    juce::String touchStatus() override;
    std::string touchOutcome() override;
    std::int64_t touchPackets() override { return touchInput.counters().packets; }
    bool playsFoci() const override { return true; }
    juce::String latencyText() override;
    juce::String latencyAdviceText() override;

private:
    void keepState (StandaloneSettings& settings) override { settings.state = player.state(); }
    void passAmplifiers (const std::vector<double>& volts) override { player.session().setAmplifiers (volts); }
    std::vector<UserMessage> playerMessages() override;
    Eigen::VectorXd limits() override;
    std::uint64_t generation() override { return player.session().snapshot()->generation; }
    void tick() override;

    AntinodeProcessor player { AntinodeProcessor::maximumCeramics, juce::AudioProcessor::wrapperType_Undefined };
    MidiQueue midiQueue { player.session().stops() };
    MidiInputs midiInputs { midiQueue };
    TouchInput touchInput { player.session() };
    std::uint64_t seenMutes = 0; ///< When they were looked at last.
};
} // namespace antinode
