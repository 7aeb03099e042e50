#include <Hosts/HostReference.h>
#include <Hosts/HostState.h>
#include <Hosts/HostedEffect.h>
#include <TouchPlugin/PlayedTouch.h>

#include <catch2/catch.hpp>

// Antinode Touch in a host of JUCE's.

using namespace antinode;
using namespace antinode::test;

namespace
{
constexpr double rate = 48000;
constexpr int length = 4800, block = 256, fingers = 8;

HostedEffect hosted (const BuiltEffect& effect, int longestBlock = block)
{
    return { { ANTINODE_TOUCH_VST3_BUNDLE, ANTINODE_TOUCH_LV2_PATH,
               "https://antinode.example/plugins/antinode-touch-" },
             effect,
             rate,
             longestBlock };
}

/** Fingers on a beam with 64 ceramics: each wire up to the last carries another voltage. */
std::unique_ptr<TouchProcessor> combProcessor (int ceramics)
{
    auto processor = offlineTouch (ceramics, rate, block, threeFingers());
    processor->load (std::make_shared<const DeviceDocument> (combDevice()));
    processor->prepareToPlay (rate, block);
    processor->session().waitUntilSettled();
    return processor;
}

/** What a host kept of it, and the voltages of tones. */
struct CombReference
{
    juce::MemoryBlock state;
    Eigen::MatrixXd inputs = fingerTones (fingers, length, rate), voltages;

    CombReference()
    {
        const auto processor = combProcessor (64);
        processor->getStateInformation (state);
        voltages = antinode::test::voltagesOf<float> (*processor, inputs, block);
    }
};

const CombReference& combReference()
{
    static const CombReference reference;
    return reference;
}

/** What a host keeps of an instance. */
juce::MemoryBlock kept (juce::AudioPluginInstance& instance)
{
    juce::MemoryBlock state;
    instance.getStateInformation (state);
    return state;
}

void restore (juce::AudioPluginInstance& instance, const juce::MemoryBlock& state)
{
    instance.setStateInformation (state.getData(), static_cast<int> (state.getSize()));
    instance.releaseResources();
    instance.prepareToPlay (rate, block);
}

/** The comb, as this kind of host would have kept it. */
void restoreComb (juce::AudioPluginInstance& instance, const BuiltEffect& plugin)
{
    restore (instance, hostState (plugin.isLv2 ? PluginKind::lv2 : PluginKind::vst3, kept (instance),
                                  combReference().state.toString().toStdString()));
}
} // namespace

TEST_CASE ("Wire k of a hosted touch plug-in is ceramic k, input k finger k", "[hosted][touch-plugin]")
{
    const auto plugin = GENERATE (from_range (builtEffects()));
    CAPTURE (plugin.isLv2, plugin.ceramics);
    auto instance = hosted (plugin);
    REQUIRE (instance->getTotalNumInputChannels() == fingers + (plugin.isLv2 ? 1 : 0)); // and the sensor
    REQUIRE (instance->getTotalNumOutputChannels() == plugin.ceramics);
    const auto& reference = combReference();
    const auto largest = reference.voltages.cwiseAbs().maxCoeff();
    REQUIRE (reference.voltages.rows() == 64);
    CHECK (leastDifference (reference.voltages) > 1e-3 * largest); // No wire can be taken for another one.
    restoreComb (*instance, plugin);
    const auto played = instance.play (reference.inputs);
    CHECK ((played - reference.voltages.topRows (plugin.ceramics)).cwiseAbs().maxCoeff() <= 1e-6 * largest);
    CHECK (instance->getLatencySamples() == 960);
}

TEST_CASE ("A hosted touch plug-in keeps its fingers, and a broken state changes nothing", "[hosted][touch-plugin]")
{
    const auto plugin = GENERATE (from_range (builtPair()));
    CAPTURE (plugin.isLv2);
    auto first = hosted (plugin), second = hosted (plugin);
    const auto& reference = combReference();
    restoreComb (*first, plugin);
    const Eigen::MatrixXd unmoved = first.play (reference.inputs);

    for (auto* const parameter : first->getParameters())
        if (parameter->getName (100) == "Finger 2 x")
            parameter->setValue (0.83F);

    first.play (reference.inputs); // Values reach the plug-in with a block.
    const auto state = kept (*first);
    restore (*first, state);
    restore (*second, state);
    second->setStateInformation ("nothing", 7);
    const Eigen::MatrixXd silence = Eigen::MatrixXd::Zero (fingers, length);
    first.play (silence); // Filters fade in.
    second.play (silence);
    const Eigen::MatrixXd one = first.play (reference.inputs), other = second.play (reference.inputs);
    CHECK ((one - unmoved).cwiseAbs().maxCoeff() > 0.01 * unmoved.cwiseAbs().maxCoeff());
    CHECK ((one - other).isZero (0));
}

TEST_CASE ("A hosted touch plug-in plays blocks longer than it was prepared for", "[hosted][touch-plugin]")
{
    const auto plugin = GENERATE (from_range (builtEffects()));
    CAPTURE (plugin.isLv2);
    auto whole = hosted (plugin, length), parts = hosted (plugin, 64);
    const auto inputs = fingerTones (fingers, length, rate);
    const Eigen::MatrixXd expected = whole.play (inputs);
    CHECK (expected.cwiseAbs().maxCoeff() > 1e-5);
    CHECK (parts.play (inputs, length) == expected);
}

TEST_CASE ("Ten hosted touch plug-ins play beside each other", "[hosted][touch-plugin]")
{
    const auto plugin = GENERATE (from_range (builtPair()));
    CAPTURE (plugin.isLv2);
    std::vector<HostedEffect> all;

    for (int i = 0; i < 10; ++i)
        all.push_back (hosted (plugin));

    for (auto& instance : all)
        CHECK (instance.play (fingerTones (fingers, length, rate)).cwiseAbs().maxCoeff() > 1e-5);
}
