#pragma once

#include "AudioHost.h"
#include "TouchInput.h"

#include <Processor/AntinodeProcessor.h>

#include <optional>

namespace antinode
{
/** From a note to its focus, and what that is made of. s */
struct TriggerLatency
{
    double focusTime = 0; ///< From the trigger until the focus: the modes need it to build up.
    double block = 0;     ///< A note that arrives during a block is played with the next one.
    double output = 0;    ///< From a played sample until it is at the output, as the device's driver says.

    double whole() const { return focusTime + block + output; }
};

/** "focus 36 ms after a note: 25 focus time, 5.3 block, 5.3 output". [any] */
juce::String latencyInWords (const TriggerLatency&);

/** How to lower the largest part. [any] */
juce::String latencyAdvice (const TriggerLatency&);

/** The standalone program without its windows, playing foci. */
class StandaloneHost : public AudioHost
{
public:
    /** As AudioHost. [message thread] */
    StandaloneHost (SettingsFile, bool keepsSettings);
    ~StandaloneHost() override;

    AntinodeProcessor& processor() { return player; }
    TouchInput& touch() { return touchInput; }

    void setTouch (const TouchPorts&) override;
    void shutDown() override;

    RemotePlayer remotePlayer() override;

    /** Puts touches that rest on the surface as fingers, and lifts those that have left, where that is due. The host
        does so itself 20 times a second. [message thread] */
    void restTouches();

    Eigen::VectorXd limits() override;
    void stopAll() override { player.session().stopAll(); }
    bool playsFoci() const override { return true; }
    juce::String latencyText() override;
    juce::String latencyAdviceText() override;

private:
    TouchPorts openPorts() override { return touchInput.ports(); }
    TouchCounters touchCounters() override { return touchInput.counters(); }
    juce::String touchLines (const TouchCounters&) override;
    std::string unusedTouches (const TouchCounters&) override;
    void keepState (StandaloneSettings& settings) override { settings.state = player.state(); }
    std::uint64_t generation() override { return player.session().snapshot()->generation; }
    void setControl (OscControl control) override { touchInput.setControl (std::move (control)); }
    void tick() override;

    AntinodeProcessor player { AntinodeProcessor::maximumCeramics, juce::AudioProcessor::wrapperType_Undefined };
    TouchInput touchInput { player.session() };
    bool wasArmed = false;
    std::uint64_t seenMutes = 0; ///< When they were looked at last.
};

/** Of the open device and the focus that plays; none where one of them is missing. [message thread] Docs/Manual/
    latency.md */
std::optional<TriggerLatency> triggerLatency (StandaloneHost&);
} // namespace antinode
