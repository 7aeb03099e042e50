#pragma once

#include <Support/Environment.h>

#include <Processor/HostChannels.h>

#include <Eigen/Core>
#include <juce_audio_processors/juce_audio_processors.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace antinode::test
{
/** Where an effect of ours is built. */
struct EffectPlaces
{
    const char* vst3Bundle;
    const char* lv2Paths;
    const char* lv2Uri; ///< Without the number of ceramics.
};

/** An effect as it is built: of LV2 there is one for each number of ceramics. */
struct BuiltEffect
{
    bool isLv2 = false;
    int ceramics = 8;
};

/** VST3 of several numbers of ceramics, and every LV2: none on Windows. */
inline std::vector<BuiltEffect> builtEffects()
{
    std::vector<BuiltEffect> built { { false, 2 }, { false, 8 }, { false, 29 }, { false, 64 } };

    for (const auto ceramics : std::initializer_list<int> { ANTINODE_LV2_BUILT })
        built.push_back ({ true, ceramics });

    return built;
}

/** An LV2, and the VST3 with as many ceramics; without LV2 a VST3. */
inline std::vector<BuiltEffect> builtPair()
{
    const auto last = builtEffects().back();
    return last.isLv2 ? std::vector<BuiltEffect> { { false, last.ceramics }, last } : std::vector<BuiltEffect> { last };
}

/** An effect in a host of JUCE's, which has prepared it. */
struct HostedEffect
{
    HostedEffect (const EffectPlaces& places, const BuiltEffect& effect, double sampleRate, int longestBlock)
        : built (effect), block (longestBlock)
    {
        static juce::VST3PluginFormat vst3;
        static juce::LV2PluginFormat lv2;
        static const auto found = lv2.searchPathsForPlugins (
            juce::FileSearchPath (juce::String (places.lv2Paths).replaceCharacter (':', ';')), true, false);
        auto& format = built.isLv2 ? static_cast<juce::AudioPluginFormat&> (lv2) : vst3;
        const auto identifier =
            built.isLv2 ? places.lv2Uri + juce::String (built.ceramics) : juce::String (places.vst3Bundle);
        setVariable ("ANTINODE_CERAMICS", std::to_string (built.ceramics));
        juce::OwnedArray<juce::PluginDescription> descriptions;
        format.findAllTypesForFile (descriptions, identifier);

        if (descriptions.size() != 1)
            throw std::runtime_error ("not one plug-in in " + identifier.toStdString());

        juce::String error;
        instance = format.createInstanceFromDescription (*descriptions[0], sampleRate, block, error);
        removeVariable ("ANTINODE_CERAMICS");

        if (instance == nullptr)
            throw std::runtime_error (error.toStdString());

        instance->setNonRealtime (true);
        instance->prepareToPlay (sampleRate, block);
    }

    juce::AudioPluginInstance* operator->() const { return instance.get(); }
    juce::AudioPluginInstance& operator*() const { return *instance; }

    /** Inputs on the wires, one a row. @return  outputs, one a row, as many samples */
    Eigen::MatrixXd play (const Eigen::MatrixXd& inputs) { return play (inputs, block); }

    /** The same in blocks of a length, also of one that it was not prepared for. */
    Eigen::MatrixXd play (const Eigen::MatrixXd& inputs, int length)
    {
        const auto in = wires (true), out = wires (false);
        Eigen::MatrixXd played (static_cast<Eigen::Index> (out.size()), inputs.cols());
        juce::MidiBuffer midi;

        for (int start = 0; start < inputs.cols(); start += length)
        {
            const auto count = std::min (length, static_cast<int> (inputs.cols()) - start);
            juce::AudioBuffer<float> buffer (
                std::max (instance->getTotalNumInputChannels(), instance->getTotalNumOutputChannels()), count);
            buffer.clear();

            for (std::size_t k = 0; k < in.size(); ++k)
                for (int n = 0; n < count; ++n)
                    buffer.setSample (in[k], n, static_cast<float> (inputs (static_cast<Eigen::Index> (k), start + n)));

            instance->processBlock (buffer, midi);

            for (std::size_t k = 0; k < out.size(); ++k)
                for (int n = 0; n < count; ++n)
                    played (static_cast<Eigen::Index> (k), start + n) =
                        static_cast<double> (buffer.getSample (out[k], n));
        }

        return played;
    }

private:
    std::vector<int> wires (bool isInput) const
    {
        const auto layout = instance->getBus (isInput, 0)->getCurrentLayout();

        if (! built.isLv2)
            return vst3ChannelOrder (layout);

        std::vector<int> order (static_cast<std::size_t> (layout.size()));
        std::iota (order.begin(), order.end(), 0);
        return order;
    }

    BuiltEffect built;
    int block;
    std::unique_ptr<juce::AudioPluginInstance> instance;
};
} // namespace antinode::test
