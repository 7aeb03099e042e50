#include "ReferenceLoop.h"

#include <antinode_documents/DeviceFile.h>
#include <antinode_documents/FocusFile.h>
#include <antinode_engine/OfflineRender.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_resources.h>
#include <antinode_text/JsonText.h>

#include <stdexcept>
#include <string>

namespace antinode
{
namespace
{
nlohmann::json resource (const std::string& name)
{
    for (const auto& file : resources::files())
        if (file.name == name)
            return parseJson (file.text(), name);

    throw std::runtime_error ("no resource " + name);
}

DeviceDescription staple()
{
    return readDevice (resource ("Devices/staple.json"), "staple");
}

void structureOfDemonstrator (benchmark::State& state)
{
    const auto device = staple();
    const bench::ReferenceRatio ratio (state);

    for (auto run : state)
        benchmark::DoNotOptimize (solveStructure (device));
}
BENCHMARK (structureOfDemonstrator)->Unit (benchmark::kMillisecond);

/** What the window asks for again and again while a device is dragged. */
void coarseStructure (benchmark::State& state, const std::string& name)
{
    const auto device = readDevice (resource ("Devices/" + name + ".json"), name);
    constexpr int modes = 30;
    const bench::ReferenceRatio ratio (state);

    for (auto run : state)
        benchmark::DoNotOptimize (solveCoarsely (device, modes));
}
BENCHMARK_CAPTURE (coarseStructure, phone, "phone")->Unit (benchmark::kMillisecond);
BENCHMARK_CAPTURE (coarseStructure, woodBox, "wood-box")->Unit (benchmark::kMillisecond);
BENCHMARK_CAPTURE (coarseStructure, acrylicBuzzers, "acrylic-buzzers")->Unit (benchmark::kMillisecond);

void designOfDemonstrator (benchmark::State& state)
{
    const auto model = solveStructure (staple());
    const auto focus = readFocus (resource ("Focuses/demonstrator.json"), "demonstrator");
    const bench::ReferenceRatio ratio (state);

    for (auto run : state)
        benchmark::DoNotOptimize (designFocus (model, focus, {}));
}
BENCHMARK (designOfDemonstrator)->Unit (benchmark::kMillisecond);

/** Argument: sample rate, Hz. */
void renderOfDemonstrator (benchmark::State& state)
{
    const auto model = solveStructure (staple());
    const auto focus = readFocus (resource ("Focuses/demonstrator.json"), "demonstrator");
    const auto design = designFocus (model, focus, {});
    RenderSettings settings;
    settings.playback = { Reconstruction::bandLimited, static_cast<double> (state.range (0)) };
    settings.duration = 0.05;
    settings.probeShapes.resize (0, model.modes());
    const bench::ReferenceRatio ratio (state);

    for (auto run : state)
        benchmark::DoNotOptimize (renderOffline (model, design.program, settings));
}
BENCHMARK (renderOfDemonstrator)
    ->Arg (48000)
    ->Arg (192000)
    ->Arg (1300000)
    ->ArgName ("rate_Hz")
    ->Unit (benchmark::kMillisecond);
} // namespace
} // namespace antinode
