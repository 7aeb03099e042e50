#pragma once

#include <juce_audio_processors/juce_audio_processors.h>

#include <memory>

namespace antinode
{
/** What our VST3s do beyond JUCE's wrapper. That one writes past its buffers where a host hands over more samples than
   it has announced: here a longer block is played in parts. VST3 has no MIDI controllers, only parameters that hosts
   send them to: here those that stop have one. Docs/Design/plugins.md */
class VST3Extensions : public juce::VST3ClientExtensions
{
public:
    /** @param processor  what the host hands its blocks to; outlives this [message thread] */
    explicit VST3Extensions (juce::AudioProcessor& processor);
    ~VST3Extensions() override;

    int32_t queryIAudioProcessor (const Steinberg::TUID, void** object) override;
    int32_t queryIEditController (const Steinberg::TUID, void** object) override;

protected:
    /** Adds the parameter "Stop" of a VST3 that plays notes: whatever a host sends to it stops them, and so do all
       sound off and all notes off. [message thread] before the host knows of parameters */
    juce::RangedAudioParameter& addStop();

private:
    class Parts;

    std::unique_ptr<Parts> parts;
};
} // namespace antinode
