#pragma once

#include "AudioHost.h"

#include <Touch/TouchProcessor.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace antinode
{
/** A finger as an option says it. */
struct WantedFinger
{
    double x = 0, y = 0; ///< m
    double level = 5e-6; ///< m that 1.0 of its input moves it; 0: it rests and feels nothing.
};

/** The standalone program without its windows, playing Antinode Touch: inputs of the audio device feed fingers. */
class TouchHost : public AudioHost
{
public:
    /** As AudioHost. [message thread] */
    TouchHost (SettingsFile, bool keepsSettings);
    ~TouchHost() override;

    TouchProcessor& processor() { return player; }

    /** Which inputs fingers feel, from the next block on; kept. [message thread] */
    void setInputs (const FingerInputs&);

    /** Puts these fingers down in place of all others as soon as the device is solved; a place outside it becomes
        fingersError(). [message thread] */
    void setFingers (std::vector<WantedFinger>);

    /** Whether the wanted fingers are down, or cannot be. [message thread] */
    bool hasFingers() const { return wantedFingers.empty(); }
    const std::string& fingersError() const { return fingerFailure; }

    /** Opens all inputs of the device. */
    void openAudio (const AudioChoice&) override;
    void setTouch (const TouchPorts&) override;
    void shutDown() override;

    RemotePlayer remotePlayer() override;
    Eigen::VectorXd limits() override;
    void stopAll() override { player.stopAll(); }
    bool playsFoci() const override { return false; }
    juce::String latencyText() override;
    juce::String latencyAdviceText() override;

    /** Puts wanted fingers down where the device is solved, as the host does 20 times a second. [message thread] */
    void tick() override;

private:
    TouchPorts openPorts() override { return player.network().ports(); }
    TouchCounters touchCounters() override { return player.network().counters(); }
    juce::String touchLines (const TouchCounters&) override;
    std::string unusedTouches (const TouchCounters&) override;
    void keepState (StandaloneSettings&) override;
    std::uint64_t generation() override;
    void setControl (OscControl control) override { player.network().setControl (std::move (control)); }
    AudioChoice audioToKeep (AudioChoice opened) const override;
    std::map<std::string, double> fingerValues (const Surface&);

    TouchProcessor player { TouchProcessor::maximumCeramics, juce::AudioProcessor::wrapperType_Undefined };
    std::vector<WantedFinger> wantedFingers;
    std::string fingerFailure;
    std::shared_ptr<const ModalModel> seenModel;
    std::shared_ptr<const FocusDocument> seenFocus;
    std::uint64_t seen = 0; ///< How many models and focuses were.
};
} // namespace antinode
