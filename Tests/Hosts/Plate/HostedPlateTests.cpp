#include <Hosts/HostedEffect.h>
#include <Plate/PlayedPlate.h>

#include <catch2/catch.hpp>

// Antinode Plate in a host of JUCE's.

using namespace antinode;
using namespace antinode::test;

namespace
{
constexpr double rate = 48000;
constexpr int length = 1600, block = 256, probes = 8;

HostedEffect hosted (const BuiltEffect& effect, int longestBlock = block)
{
    return { { ANTINODE_PLATE_VST3_BUNDLE, ANTINODE_PLATE_LV2_PATH,
               "https://antinode.example/plugins/antinode-plate-" },
             effect,
             rate,
             longestBlock };
}
} // namespace

TEST_CASE ("Wire k of a hosted plate is ceramic k, and its outputs are the probes", "[hosted][plate]")
{
    const auto plugin = GENERATE (from_range (builtEffects()));
    CAPTURE (plugin.isLv2, plugin.ceramics);
    auto instance = hosted (plugin);
    REQUIRE (instance->getTotalNumInputChannels() == plugin.ceramics);
    REQUIRE (instance->getTotalNumOutputChannels() == probes);
    const auto voltages = sines (plugin.ceramics, length);
    const auto reference = offlinePlate (plugin.ceramics, rate, block);
    const Eigen::MatrixXd expected = moved<float> (*reference, voltages, block);
    const auto played = instance.play (voltages);
    CHECK (expected.rowwise().lpNorm<Eigen::Infinity>().minCoeff() > 0);
    CHECK ((played - expected).cwiseAbs().maxCoeff() <= 1e-6 * expected.cwiseAbs().maxCoeff());
    CHECK (instance->getLatencySamples() == 15);
}

TEST_CASE ("A hosted plate keeps its device and its probes, and a broken state changes nothing", "[hosted][plate]")
{
    const auto plugin = GENERATE (from_range (builtPair()));
    CAPTURE (plugin.isLv2);
    auto first = hosted (plugin), second = hosted (plugin);
    const auto voltages = sines (plugin.ceramics, length);
    const Eigen::MatrixXd unmoved = first.play (voltages);

    for (auto* const parameter : first->getParameters())
        if (parameter->getName (100) == "Probe 2 x")
            parameter->setValue (0.83F);

    first.play (voltages); // Values reach the plug-in with a block.
    // Released first: a host of JUCE's leaves out a preparation like the one before, and the surface would go on
    // moving.
    first->releaseResources();
    first->prepareToPlay (rate, block);
    juce::MemoryBlock state;
    first->getStateInformation (state);
    second->setStateInformation (state.getData(), static_cast<int> (state.getSize()));
    second->setStateInformation ("nothing", 7);
    second->prepareToPlay (rate, block);
    const Eigen::MatrixXd one = first.play (voltages), other = second.play (voltages);
    CHECK ((one.row (1) - unmoved.row (1)).cwiseAbs().maxCoeff() > 0.01 * unmoved.row (1).cwiseAbs().maxCoeff());
    CHECK ((one - other).isZero (0));
}

TEST_CASE ("A hosted plate plays blocks longer than it was prepared for", "[hosted][plate]")
{
    const auto plugin = GENERATE (from_range (builtEffects()));
    CAPTURE (plugin.isLv2);
    auto whole = hosted (plugin, length), parts = hosted (plugin, 64);
    const auto voltages = sines (plugin.ceramics, length);
    const Eigen::MatrixXd expected = whole.play (voltages);
    CHECK (expected.cwiseAbs().maxCoeff() > 1e-5);
    CHECK (parts.play (voltages, length) == expected);
}

TEST_CASE ("Ten hosted plates move beside each other", "[hosted][plate]")
{
    const auto plugin = GENERATE (from_range (builtPair()));
    CAPTURE (plugin.isLv2);
    std::vector<HostedEffect> all;

    for (int i = 0; i < 10; ++i)
        all.push_back (hosted (plugin));

    for (auto& instance : all)
        CHECK (instance.play (sines (plugin.ceramics, length)).cwiseAbs().maxCoeff() > 1e-5);
}
