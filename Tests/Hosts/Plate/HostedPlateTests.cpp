#include <Plate/PlayedPlate.h>
#include <Processor/VST3Channels.h>

#include <catch2/catch.hpp>

#include <cstdlib>
#include <numeric>
#include <stdexcept>

// Antinode Plate in a host of JUCE's.

using namespace antinode;
using namespace antinode::test;

namespace
{
constexpr double rate = 48000;
constexpr int length = 1600, block = 256, probes = 8;

/** A built plug-in. */
struct Built
{
    bool isLv2 = false;
    int ceramics = 8;
};

std::vector<Built> builtPlates()
{
    return { { false, 2 }, { false, 8 }, { false, 29 }, { false, 64 },
             { true, 8 },  { true, 16 }, { true, 32 },  { true, 64 } };
}

juce::AudioPluginFormat& lv2Format()
{
    static juce::LV2PluginFormat format;
    static const auto found = format.searchPathsForPlugins (
        juce::FileSearchPath (juce::String (ANTINODE_PLATE_LV2_PATH).replaceCharacter (':', ';')), true, false);
    return format;
}

std::unique_ptr<juce::AudioPluginInstance> hosted (const Built& plugin)
{
    static juce::VST3PluginFormat vst3;
    auto& format = plugin.isLv2 ? lv2Format() : vst3;
    const auto identifier = plugin.isLv2
                                ? "https://antinode.example/plugins/antinode-plate-" + juce::String (plugin.ceramics)
                                : juce::String (ANTINODE_PLATE_VST3_BUNDLE);
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

/** Voltages on the wires. @return  probes x samples */
Eigen::MatrixXd moved (juce::AudioPluginInstance& instance, const Built& plugin, const Eigen::MatrixXd& voltages)
{
    const auto in = pluginWires (instance, true, plugin), out = pluginWires (instance, false, plugin);
    Eigen::MatrixXd played (static_cast<Eigen::Index> (out.size()), voltages.cols());
    juce::MidiBuffer midi;

    for (int start = 0; start < voltages.cols(); start += block)
    {
        const auto count = std::min (block, static_cast<int> (voltages.cols()) - start);
        juce::AudioBuffer<float> buffer (static_cast<int> (std::max (in.size(), out.size())), count);
        buffer.clear();

        for (std::size_t k = 0; k < in.size(); ++k)
            for (int n = 0; n < count; ++n)
                buffer.setSample (in[k], n, static_cast<float> (voltages (static_cast<Eigen::Index> (k), start + n)));

        instance.processBlock (buffer, midi);

        for (std::size_t k = 0; k < out.size(); ++k)
            for (int n = 0; n < count; ++n)
                played (static_cast<Eigen::Index> (k), start + n) = static_cast<double> (buffer.getSample (out[k], n));
    }

    return played;
}
} // namespace

TEST_CASE ("Wire k of a hosted plate is ceramic k, and its outputs are the probes", "[hosted][plate]")
{
    const auto plugin = GENERATE (from_range (builtPlates()));
    CAPTURE (plugin.isLv2, plugin.ceramics);
    const auto instance = hosted (plugin);
    REQUIRE (instance->getTotalNumInputChannels() == plugin.ceramics);
    REQUIRE (instance->getTotalNumOutputChannels() == probes);
    const auto voltages = sines (plugin.ceramics, length);
    const auto reference = offlinePlate (plugin.ceramics, rate, block);
    const Eigen::MatrixXd expected = moved<float> (*reference, voltages, block);
    const auto played = moved (*instance, plugin, voltages);
    CHECK (expected.rowwise().lpNorm<Eigen::Infinity>().minCoeff() > 0);
    CHECK ((played - expected).cwiseAbs().maxCoeff() <= 1e-6 * expected.cwiseAbs().maxCoeff());
    CHECK (instance->getLatencySamples() == 15);
}

TEST_CASE ("A hosted plate keeps its device and its probes, and a broken state changes nothing", "[hosted][plate]")
{
    const auto plugin = GENERATE (Built { false, 8 }, Built { true, 8 });
    CAPTURE (plugin.isLv2);
    const auto first = hosted (plugin), second = hosted (plugin);
    const auto voltages = sines (8, length);
    const Eigen::MatrixXd unmoved = moved (*first, plugin, voltages);

    for (auto* const parameter : first->getParameters())
        if (parameter->getName (100) == "Probe 2 x")
            parameter->setValue (0.83F);

    moved (*first, plugin, voltages); // Values reach the plug-in with a block.
    // Released first: a host of JUCE's leaves out a preparation like the one before, and the surface would go on
    // moving.
    first->releaseResources();
    first->prepareToPlay (rate, block);
    juce::MemoryBlock state;
    first->getStateInformation (state);
    second->setStateInformation (state.getData(), static_cast<int> (state.getSize()));
    second->setStateInformation ("nothing", 7);
    second->prepareToPlay (rate, block);
    const Eigen::MatrixXd one = moved (*first, plugin, voltages), other = moved (*second, plugin, voltages);
    CHECK ((one.row (1) - unmoved.row (1)).cwiseAbs().maxCoeff() > 0.01 * unmoved.row (1).cwiseAbs().maxCoeff());
    CHECK ((one - other).isZero (0));
}

TEST_CASE ("Ten hosted plates move beside each other", "[hosted][plate]")
{
    const auto plugin = GENERATE (Built { false, 16 }, Built { true, 16 });
    CAPTURE (plugin.isLv2);
    std::vector<std::unique_ptr<juce::AudioPluginInstance>> all;

    for (int i = 0; i < 10; ++i)
        all.push_back (hosted (plugin));

    for (const auto& instance : all)
        CHECK (moved (*instance, plugin, sines (16, length)).cwiseAbs().maxCoeff() > 1e-5);
}
