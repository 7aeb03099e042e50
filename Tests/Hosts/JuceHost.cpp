#include "JuceHost.h"

#include "Support/Environment.h"
#include "Support/JuceMessages.h"

#include <Processor/HostChannels.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <stdexcept>
#include <thread>

namespace antinode::test
{
namespace
{
juce::PluginDescription describe (juce::AudioPluginFormat& format, const juce::String& fileOrIdentifier)
{
    juce::OwnedArray<juce::PluginDescription> found;
    format.findAllTypesForFile (found, fileOrIdentifier);

    if (found.size() != 1)
        throw std::runtime_error ("not one plug-in in " + fileOrIdentifier.toStdString());

    return *found[0];
}

/** One world of LV2 bundles for the whole program, as in a host. */
juce::AudioPluginFormat& lv2Format()
{
    static juce::LV2PluginFormat format;
    static const auto found = format.searchPathsForPlugins (
        juce::FileSearchPath (juce::String (ANTINODE_LV2_PATH).replaceCharacter (':', ';')), true, false);
    return format;
}

std::unique_ptr<juce::AudioPluginInstance> createInstance (const BuiltPlugin& plugin, double rate, int block,
                                                           juce::String& error)
{
    if (plugin.kind == PluginKind::lv2)
    {
        const auto identifier = "https://antinode.example/plugins/antinode-" + juce::String (plugin.ceramics);
        return lv2Format().createInstanceFromDescription (describe (lv2Format(), identifier), rate, block, error);
    }

    juce::VST3PluginFormat format;
    setVariable ("ANTINODE_CERAMICS", std::to_string (plugin.ceramics));
    auto instance = format.createInstanceFromDescription (describe (format, ANTINODE_VST3_BUNDLE), rate, block, error);
    removeVariable ("ANTINODE_CERAMICS");
    return instance;
}

std::vector<int> wireOrder (const juce::AudioPluginInstance& instance, const BuiltPlugin& plugin)
{
    const auto layout = instance.getBus (false, 0)->getCurrentLayout();

    if (plugin.kind == PluginKind::vst3)
        return vst3ChannelOrder (layout);

    std::vector<int> order (static_cast<std::size_t> (layout.size()));
    std::iota (order.begin(), order.end(), 0);
    return order;
}

template <typename Sample>
void playBlock (juce::AudioPluginInstance& instance, const std::vector<int>& wires, juce::MidiBuffer& midi, int start,
                int count, Eigen::MatrixXd& played)
{
    juce::AudioBuffer<Sample> buffer (instance.getTotalNumOutputChannels(), count);

    for (int i = 0; i < buffer.getNumChannels(); ++i)
        std::fill_n (buffer.getWritePointer (i), count, Sample (7)); // So that what is not written is seen.

    instance.processBlock (buffer, midi);

    for (int i = 0; i < buffer.getNumChannels(); ++i)
    {
        const auto isCeramic = i < static_cast<int> (wires.size());
        const auto* const samples = buffer.getReadPointer (isCeramic ? wires[static_cast<std::size_t> (i)] : i);

        for (int n = 0; n < count; ++n)
            played (i, start + n) = static_cast<double> (samples[n]);
    }
}
/** Whether the host reads a step of each parameter that has steps. */
bool readsSteps (const juce::AudioPluginInstance& instance)
{
    return std::all_of (instance.getParameters().begin(), instance.getParameters().end(),
                        [] (const auto* parameter)
                        {
                            const auto steps =
                                parameter->getValue() * static_cast<float> (parameter->getNumSteps() - 1);
                            return ! parameter->isDiscrete() || std::abs (steps - std::round (steps)) < 1e-3F;
                        });
}
} // namespace

std::string pluginName (const BuiltPlugin& plugin)
{
    return (plugin.kind == PluginKind::vst3 ? "VST3 " : "LV2 ") + std::to_string (plugin.ceramics);
}

std::vector<BuiltPlugin> builtPlugins()
{
    std::vector<BuiltPlugin> built;

    for (const auto ceramics : { 2, 8, 16, 32, 64 })
        built.push_back ({ PluginKind::vst3, ceramics });

    for (const auto ceramics : { ANTINODE_LV2_BUILT })
        built.push_back ({ PluginKind::lv2, ceramics });

    return built;
}

std::vector<BuiltPlugin> builtPair()
{
    const auto lv2 = builtPlugins().back();
    return { { PluginKind::vst3, lv2.ceramics }, lv2 };
}

std::unique_ptr<juce::AudioPluginInstance> hosted (const BuiltPlugin& plugin, double rate, int block)
{
    juce::String error;
    auto instance = createInstance (plugin, rate, block, error);

    if (instance == nullptr)
        throw std::runtime_error (pluginName (plugin) + ": " + error.toStdString());

    return instance;
}

std::unique_ptr<juce::AudioPluginInstance> hostedOffline (const BuiltPlugin& plugin, double rate, int block)
{
    auto instance = hosted (plugin, rate, block);
    instance->setNonRealtime (true);
    instance->prepareToPlay (rate, block);
    return instance;
}

Eigen::MatrixXd play (juce::AudioPluginInstance& instance, const BuiltPlugin& plugin, int samples, int block,
                      const std::function<void (int, juce::MidiBuffer&)>& beforeBlock)
{
    Eigen::MatrixXd played (instance.getTotalNumOutputChannels(), samples);
    const auto wires = wireOrder (instance, plugin);

    for (int start = 0; start < samples; start += block)
    {
        const auto count = std::min (block, samples - start);
        juce::MidiBuffer midi;
        beforeBlock (start, midi);

        if (instance.isUsingDoublePrecision())
            playBlock<double> (instance, wires, midi, start, count, played);
        else
            playBlock<float> (instance, wires, midi, start, count, played);
    }

    return played;
}

Eigen::MatrixXd play (juce::AudioPluginInstance& instance, const BuiltPlugin& plugin, int samples, int block,
                      int noteAt, int note)
{
    return play (instance, plugin, samples, block,
                 [&] (int start, juce::MidiBuffer& midi)
                 {
                     if (noteAt >= start && noteAt < start + block)
                         midi.addEvent (juce::MidiMessage::noteOn (1, note, juce::uint8 (127)), noteAt - start);
                 });
}

juce::MemoryBlock savedState (juce::AudioPluginInstance& instance)
{
    juce::MemoryBlock state;
    instance.getStateInformation (state);
    return state;
}

void setState (juce::AudioPluginInstance& instance, const juce::MemoryBlock& state)
{
    instance.setStateInformation (state.getData(), static_cast<int> (state.getSize()));
}

void waitForSteps (juce::AudioPluginInstance& instance, const BuiltPlugin& plugin)
{
    using Clock = std::chrono::steady_clock;

    for (const auto end = Clock::now() + std::chrono::seconds (10); ! readsSteps (instance);)
    {
        if (Clock::now() > end)
            throw std::runtime_error (pluginName (plugin) + ": the host was not told of its steps within 10 s");

        play (instance, plugin, 64, 64, -1);

        if (! answerNextMessage())
            std::this_thread::sleep_for (std::chrono::milliseconds (1));
    }

    play (instance, plugin, 64, 64, -1);
}

void runInBackground (const std::function<void()>& work)
{
    std::atomic<bool> isDone { false };
    std::thread background (
        [&]
        {
            work();
            isDone = true;
        });

    while (! isDone)
        if (! answerNextMessage())
            std::this_thread::sleep_for (std::chrono::milliseconds (1));

    background.join();
}
} // namespace antinode::test
