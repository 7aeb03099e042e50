#include <Hosts/HostReference.h>
#include <Hosts/HostState.h>
#include <Processor/VST3Channels.h>
#include <TouchPlugin/PlayedTouch.h>

#include <catch2/catch.hpp>

#include <cstdlib>
#include <numeric>
#include <stdexcept>

// Antinode Touch in a host of JUCE's.

using namespace antinode;
using namespace antinode::test;

namespace
{
constexpr double rate = 48000;
constexpr int length = 4800, block = 256, fingers = 8;

/** A built plug-in. */
struct Built
{
    bool isLv2 = false;
    int ceramics = 8;
};

std::vector<Built> builtTouches()
{
    return { { false, 2 }, { false, 8 }, { false, 29 }, { false, 64 },
             { true, 8 },  { true, 16 }, { true, 32 },  { true, 64 } };
}

juce::AudioPluginFormat& lv2Format()
{
    static juce::LV2PluginFormat format;
    static const auto found = format.searchPathsForPlugins (
        juce::FileSearchPath (juce::String (ANTINODE_TOUCH_LV2_PATH).replaceCharacter (':', ';')), true, false);
    return format;
}

std::unique_ptr<juce::AudioPluginInstance> hosted (const Built& plugin)
{
    static juce::VST3PluginFormat vst3;
    auto& format = plugin.isLv2 ? lv2Format() : vst3;
    const auto identifier = plugin.isLv2
                                ? "https://antinode.example/plugins/antinode-touch-" + juce::String (plugin.ceramics)
                                : juce::String (ANTINODE_TOUCH_VST3_BUNDLE);
    setenv ("ANTINODE_CERAMICS", std::to_string (plugin.ceramics).c_str(), 1);
    juce::OwnedArray<juce::PluginDescription> found;
    format.findAllTypesForFile (found, identifier);

    if (found.size() != 1)
        throw std::runtime_error ("not one plug-in in " + identifier.toStdString());

    juce::String error;
    auto instance = format.createInstanceFromDescription (*found[0], rate, block, error);
    unsetenv ("ANTINODE_CERAMICS");

    if (instance == nullptr)
        throw std::runtime_error (error.toStdString());

    instance->setNonRealtime (true);
    instance->prepareToPlay (rate, block);
    return instance;
}

std::vector<int> pluginWires (const juce::AudioPluginInstance& instance, bool isInput, const Built& plugin)
{
    const auto layout = instance.getBus (isInput, 0)->getCurrentLayout();

    if (! plugin.isLv2)
        return vst3ChannelOrder (layout);

    std::vector<int> order (static_cast<std::size_t> (layout.size()));
    std::iota (order.begin(), order.end(), 0);
    return order;
}

/** Inputs on the wires. @return  ceramics x samples */
Eigen::MatrixXd voltagesOf (juce::AudioPluginInstance& instance, const Built& plugin, const Eigen::MatrixXd& inputs)
{
    const auto in = pluginWires (instance, true, plugin), out = pluginWires (instance, false, plugin);
    Eigen::MatrixXd played (static_cast<Eigen::Index> (out.size()), inputs.cols());
    juce::MidiBuffer midi;

    for (int start = 0; start < inputs.cols(); start += block)
    {
        const auto count = std::min (block, static_cast<int> (inputs.cols()) - start);
        juce::AudioBuffer<float> buffer (static_cast<int> (std::max (in.size(), out.size())), count);
        buffer.clear();

        for (std::size_t k = 0; k < in.size(); ++k)
            for (int n = 0; n < count; ++n)
                buffer.setSample (in[k], n, static_cast<float> (inputs (static_cast<Eigen::Index> (k), start + n)));

        instance.processBlock (buffer, midi);

        for (std::size_t k = 0; k < out.size(); ++k)
            for (int n = 0; n < count; ++n)
                played (static_cast<Eigen::Index> (k), start + n) = static_cast<double> (buffer.getSample (out[k], n));
    }

    return played;
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
void restoreComb (juce::AudioPluginInstance& instance, const Built& plugin)
{
    restore (instance, hostState (plugin.isLv2 ? PluginKind::lv2 : PluginKind::vst3, kept (instance),
                                  combReference().state.toString().toStdString()));
}
} // namespace

TEST_CASE ("Each of the 64 ceramics of the comb has a voltage of its own under fingers", "[hosted][touch-plugin]")
{
    const auto& voltages = combReference().voltages;
    REQUIRE (voltages.rows() == 64);
    const auto largest = voltages.cwiseAbs().maxCoeff();

    for (int i = 0; i < 64; ++i)
        for (int j = 0; j < i; ++j)
            CHECK ((voltages.row (i) - voltages.row (j)).cwiseAbs().maxCoeff() > 1e-3 * largest);
}

TEST_CASE ("Wire k of a hosted touch plug-in is ceramic k, input k finger k", "[hosted][touch-plugin]")
{
    const auto plugin = GENERATE (from_range (builtTouches()));
    CAPTURE (plugin.isLv2, plugin.ceramics);
    const auto instance = hosted (plugin);
    REQUIRE (instance->getTotalNumInputChannels() == fingers);
    REQUIRE (instance->getTotalNumOutputChannels() == plugin.ceramics);
    const auto& reference = combReference();
    restoreComb (*instance, plugin);
    const auto played = voltagesOf (*instance, plugin, reference.inputs);
    CHECK ((played - reference.voltages.topRows (plugin.ceramics)).cwiseAbs().maxCoeff()
           <= 1e-6 * reference.voltages.cwiseAbs().maxCoeff());
    CHECK (instance->getLatencySamples() == 960);
}

TEST_CASE ("A hosted touch plug-in keeps its fingers, and a broken state changes nothing", "[hosted][touch-plugin]")
{
    const auto plugin = GENERATE (Built { false, 8 }, Built { true, 8 });
    CAPTURE (plugin.isLv2);
    const auto first = hosted (plugin), second = hosted (plugin);
    const auto& reference = combReference();
    restoreComb (*first, plugin);
    const Eigen::MatrixXd unmoved = voltagesOf (*first, plugin, reference.inputs);

    for (auto* const parameter : first->getParameters())
        if (parameter->getName (100) == "Finger 2 x")
            parameter->setValue (0.83F);

    voltagesOf (*first, plugin, reference.inputs); // Values reach the plug-in with a block.
    const auto state = kept (*first);
    restore (*first, state);
    restore (*second, state);
    second->setStateInformation ("nothing", 7);
    const Eigen::MatrixXd silence = Eigen::MatrixXd::Zero (fingers, length);
    voltagesOf (*first, plugin, silence); // Filters fade in.
    voltagesOf (*second, plugin, silence);
    const Eigen::MatrixXd one = voltagesOf (*first, plugin, reference.inputs),
                          other = voltagesOf (*second, plugin, reference.inputs);
    CHECK ((one - unmoved).cwiseAbs().maxCoeff() > 0.01 * unmoved.cwiseAbs().maxCoeff());
    CHECK ((one - other).isZero (0));
}

TEST_CASE ("Ten hosted touch plug-ins play beside each other", "[hosted][touch-plugin]")
{
    const auto plugin = GENERATE (Built { false, 16 }, Built { true, 16 });
    CAPTURE (plugin.isLv2);
    std::vector<std::unique_ptr<juce::AudioPluginInstance>> all;

    for (int i = 0; i < 10; ++i)
        all.push_back (hosted (plugin));

    for (const auto& instance : all)
        CHECK (voltagesOf (*instance, plugin, fingerTones (fingers, length, rate)).cwiseAbs().maxCoeff() > 1e-5);
}
