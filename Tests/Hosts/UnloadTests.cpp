#include "JuceHost.h"

#include <Processor/AntinodeProcessor.h>

#include <Support/LargestDevice.h>

#include <catch2/catch.hpp>

#include <chrono>
#include <fstream>
#include <thread>

// A host that removes a plug-in unloads its library, whatever a thread of it is doing.

using namespace antinode;
using namespace antinode::test;

namespace
{
/** A state whose device takes many seconds to solve and is in no cache. */
std::string stateOfLongWork (double quality)
{
    AntinodeProcessor processor (64, juce::AudioProcessor::wrapperType_Undefined);
    processor.load (std::make_shared<const DeviceDocument> (readDeviceDocument (largestDevice (quality), "device")),
                    nullptr);
    juce::MemoryBlock state;
    processor.getStateInformation (state);
    return { static_cast<const char*> (state.getData()), state.getSize() };
}

bool isLoaded (const std::string& library)
{
    std::ifstream maps ("/proc/self/maps");

    for (std::string line; std::getline (maps, line);)
        if (line.find (library) != std::string::npos)
            return true;

    return false;
}
} // namespace

TEST_CASE ("A host unloads the library while a thread of it solves a device", "[hosted]")
{
    const auto plugin = GENERATE (from_range (builtPair()));
    const std::string library = plugin.kind == PluginKind::vst3
                                    ? std::string ("Antinode.so")
                                    : "libAntinode " + std::to_string (plugin.ceramics) + ".so";
    CAPTURE (pluginName (plugin));

    for (int i = 0; i < 5; ++i)
    {
        auto instance = hosted (plugin);
        REQUIRE (isLoaded (library));
        setState (*instance, hostState (plugin.kind, savedState (*instance), stateOfLongWork (60 + i)));
        instance->prepareToPlay (48000, 512);
        std::this_thread::sleep_for (std::chrono::milliseconds (30 + 60 * i));
        instance.reset();
    }

    // Threads that were left run code of the library until their work has ended.
    std::this_thread::sleep_for (std::chrono::milliseconds (500));
    CHECK (hosted (plugin) != nullptr);
}
