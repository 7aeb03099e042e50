#pragma once

#include "DeviceProcessor.h"

#include <antinode_session/SessionOwner.h>

#include <memory>
#include <span>
#include <tuple>
#include <utility>

namespace antinode
{
/** A plug-in of one role: its parameters, and the session that looks at them and plays. A role is a class of this in a
    file of its own, with its session and its parameters (Tests/Processor/NewRoleTests.cpp has a tiny one).
    @tparam SessionType     of DeviceRounds, with process (block, controls)
    @tparam ParametersType  a ParameterSet with settings() and controls(), which say isArmed */
template <typename SessionType, typename ParametersType>
class RoleProcessor : public DeviceProcessor
{
public:
    void processBlock (juce::AudioBuffer<float>& buffer, juce::MidiBuffer& midi) override
    {
        play (buffer, midi, false);
    }
    void processBlock (juce::AudioBuffer<double>& buffer, juce::MidiBuffer& midi) override
    {
        play (buffer, midi, false);
    }
    void processBlockBypassed (juce::AudioBuffer<float>& buffer, juce::MidiBuffer& midi) override
    {
        play (buffer, midi, true);
    }
    void processBlockBypassed (juce::AudioBuffer<double>& buffer, juce::MidiBuffer& midi) override
    {
        play (buffer, midi, true);
    }

    SessionType& session() const { return **player; }
    ParametersType& parameters() const { return *controls; }

protected:
    using Settings = decltype (std::declval<ParametersType>().settings());
    using Controls = decltype (std::declval<ParametersType>().controls());

    /** @param role, first  as DeviceProcessor [message thread] */
    RoleProcessor (const Buses& buses, WrapperType wrapper, const SessionRole& role,
                   std::shared_ptr<const DeviceDocument> first)
        : DeviceProcessor (buses, wrapper, role, std::move (first))
    {
        controls = std::make_unique<ParametersType> (
            *this, [this] { return player != nullptr ? session().snapshot()->model : nullptr; });
    }

    /** Starts the session, when all is made that it may ask for. @param documents  what it begins with, by value
        @param more  behind what reads settings and tells of changes [message thread] */
    template <typename Documents, typename... More>
    void start (const Documents& documents, More&&... more)
    {
        player = std::apply (
            [&] (const auto&... each)
            {
                return std::make_unique<SessionThread<SessionType>> (
                    each..., [this] { return look(); }, [this] { post(); }, std::forward<More> (more)...);
            },
            documents);
        begin();
    }

    /** To be called before anything of the derived class is gone: the session's thread asks for it. [message thread] */
    void close()
    {
        end();

        if (player != nullptr)
            session().leave(); // Before the pointer is empty: until then its thread asks for it.

        player.reset();
    }

    /** What the parameters say. [session's thread] */
    virtual Settings look()
    {
        reportSteps();
        return controls->settings();
    }

    /** What the host plays at a sample rate, as the session is asked for it. [any but the audio thread] */
    virtual typename SessionType::Format formatAt (double sampleRate) const { return { sampleRate }; }

    /** Adds what is no parameter. [audio thread] */
    virtual void complete (Controls&) const {}

private:
    void prepareSession (double sampleRate) override { session().prepare (formatAt (sampleRate)); }
    ParameterSet& parameterSet() const override { return *controls; }
    void waitUntilSettled (std::span<const FocusEvent> notes) override { session().waitUntilSettled (notes); }

    template <typename Sample>
    void play (juce::AudioBuffer<Sample>& buffer, const juce::MidiBuffer& midi, bool isBypassed)
    {
        const juce::ScopedNoDenormals noDenormals;

        if (WiredBlock<Sample> wired; wire (buffer, midi, wired))
        {
            auto now = controls->controls();
            complete (now);
            now.isArmed = now.isArmed && ! isBypassed;
            session().process (wired.block, now);

            for (auto i = static_cast<int> (wired.block.outputs.size() + wired.block.monitor.size());
                 i < buffer.getNumChannels(); ++i)
                buffer.clear (i, 0, wired.block.count); // Inputs that are no outputs.
        }
    }

    std::unique_ptr<ParametersType> controls;
    std::unique_ptr<SessionThread<SessionType>> player;
};
} // namespace antinode
