#pragma once

#include "DeviceProcessor.h"
#include "ParameterSet.h"

#include <antinode_session/FocusSettings.h>
#include <antinode_session/PlayControls.h>
#include <antinode_session/Session.h>

#include <atomic>
#include <functional>
#include <memory>
#include <vector>

namespace antinode
{
/** Those of Antinode. Docs/Manual/parameters.md. */
class Parameters : public ParameterSet
{
public:
    /** Adds them to a processor, which owns them. [message thread] */
    Parameters (juce::AudioProcessor&, const SurfaceSource&);

    /** The settings of the focus. [any] */
    PlaySettings settings() const;

    /** The settings that take effect immediately, without mutes. [any] */
    PlayControls controls() const;

    /** Sets the parameters that a focus determines, and tells the host. [any but the audio thread] */
    void setFocus (const PlaySettings&);

    /** Those. [any] */
    std::vector<juce::RangedAudioParameter*> ofFocus() const;

    SwitchParameter& arm() const { return *armed; }

private:
    NumberParameter *x, *y, *width, *peakVelocity, *focusTime, *growth, *brake, *voltageLimit, *probeX, *probeY,
        *monitorGain, *outputTrim;
    IntegerParameter *shape, *method, *modes, *notes, *noteOff, *retrigger;
    SwitchParameter *focusOnNote, *armed;
};

/** The plug-in: parameters, buses and state around a session. The standalone program has one too.

    The input bus "Sensor" has one channel, or none: what listens to the surface. The main output bus "Ceramics" has 1
   to 64 channels, channel k for ceramic k, 1.0 = the device's full scale; the bus "Monitor" has the velocity at the
   probes, 1.0 = 1 m/s. */
class AntinodeProcessor : public RoleProcessor<Session, Parameters>
{
public:
    /** @param ceramics  channels of the main bus at first, 1 to 64
        @param wrapper   what it runs in: decides how channels are laid on wires
        [message thread] */
    AntinodeProcessor (int ceramics, juce::AudioProcessor::WrapperType wrapper);
    ~AntinodeProcessor() override;

    /** Loads a device, a focus, or both, and sets the parameters to the focus. Another device alone gets a focus that
       suits it as soon as it is solved. [message thread] */
    void load (std::shared_ptr<const DeviceDocument>, std::shared_ptr<const FocusDocument>);

    /** Puts other fingers on the surface; parameters stay as they are. Touches among them remain touches.
        @throws InputError  as withFingers; then nothing is changed [message thread] */
    void setFingers (const std::vector<Finger>&);

    /** Puts other touches beside the fingers of the focus. They are on the surface of this focus only, and in no state.
        @throws InputError  as withFingers; then nothing is changed [message thread] */
    void setTouches (const std::vector<Finger>&);

    /** Those that are on the surface, as focus() has them behind the fingers of its own. [any but the audio thread] */
    std::vector<Finger> touches() const;

    /** Without touches. */
    SessionState state() const override;
    void setState (const SessionState&, bool isRestored) override;

    /** The focus, with the touches on its surface. [any but the audio thread] */
    std::shared_ptr<const FocusDocument> focus() const;

    /** Bit i: ceramic i + 1 is muted. [any] */
    std::uint64_t mutes() const { return mutedCeramics; }
    void setMutes (std::uint64_t mask) { mutedCeramics = mask; }

    /** Creates the editor; set by programs that have one, so that programs without an editor do not need it. */
    static std::function<juce::AudioProcessorEditor*(AntinodeProcessor&)> makeEditor;

    const juce::String getName() const override { return "Antinode"; }
    void reset() override { session().stopAll(); }
    bool getPluginHasMainInput() const override { return false; }
    double getTailLengthSeconds() const override { return session().tailSeconds(); }
    bool acceptsMidi() const override { return true; }
    juce::AudioProcessorEditor* createEditor() override { return makeEditor ? makeEditor (*this) : nullptr; }
    Playing playing() const override;
    bool hasEditor() const override { return makeEditor != nullptr; }

private:
    AntinodeProcessor (int ceramics, WrapperType wrapper, const SessionState& first);
    std::vector<UserMessage> ownMessages() const override;
    void complete (PlayControls& now) const override { now.mutes = mutedCeramics; }
    std::shared_ptr<const FocusDocument> keptFocus() const;
    bool takeFocus (const std::shared_ptr<const FocusDocument>& chosen, const FocusDocument& before);
    void putDown (const std::vector<Finger>& own, const std::vector<Finger>& touching);

    std::atomic<std::uint64_t> mutedCeramics { 0 };
    std::shared_ptr<const FocusDocument> loadedFocus,
        touchedFocus; ///< As it is kept, and with touches; under `documents`.
};

/** The embedded demonstrator: the initial state. [worker] */
SessionState demonstrator();
} // namespace antinode
