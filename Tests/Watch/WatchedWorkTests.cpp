#include "LongWorks.h"
#include "Support/IdentificationScore.h"
#include "Support/WatchedWork.h"

#include <antinode_base/InputError.h>
#include <antinode_focus/Tolerance.h>
#include <antinode_focus/Tradeoff.h>
#include <antinode_identification/Identification.h>
#include <antinode_render/RenderedFocus.h>
#include <antinode_structure/Placing.h>

#include <catch2/catch.hpp>

#include <cstdio>

using namespace antinode;
using namespace antinode::test;

namespace
{
const Playback playback { Reconstruction::bandLimited, 192000 };

/** Runs some work and prints how long its looks are apart. */
void watched (const std::string& name, const std::function<void()>& run)
{
    std::string failure;
    const WatchedWork work (
        [&]
        {
            try
            {
                run();
            }
            catch (const InputError& error)
            {
                failure = error.what();
            }
        });
    std::printf ("%-44s %9.1f ms  median %8.3f ms  worst %8.2f ms  %zu looks %s\n", name.c_str(), work.duration(),
                 work.medianWait(), work.worstWait(), work.looks(), failure.substr (0, 60).c_str());
    std::fflush (stdout);
    CHECK (work.worstWait() < 250);
}

void watchDesigns (const std::string& device, const ModalModel& model, const FocusDescription& focus)
{
    for (const auto method : allMethods)
        watched (device + " " + nameOf (method), [&] { designFocus (model, by (method, focus), playback); });
}
} // namespace

TEST_CASE ("Solving and designing on every embedded device looks at the watch", "[.][watch]")
{
    for (const auto& [device, focus] : embeddedCases)
    {
        const auto description = loadDevice (device, {});
        ModalModel model;
        watched (std::string (device) + " solve", [&] { model = solveStructure (description); });
        watchDesigns (device, model, loadFocus (focus, {}));
    }
}

TEST_CASE ("Work of other kinds looks at the watch", "[.][watch-other]")
{
    const auto model = solveStructure (loadDevice ("staple", {}));
    const auto focus = loadFocus ("demonstrator", {});
    const auto design = designFocus (model, focus, playback);
    watched ("render", [&] { renderFocus (model, design, {}); });
    auto braked = focus;
    braked.transients.brakeDuration = 0.02;
    watched ("brake", [&] { designFocus (model, braked, playback); });
    auto robust = focus;
    robust.allocation.robust = Robustness {};
    watched ("robust", [&] { designFocus (model, robust, playback); });
    watched ("tolerance", [&] { evaluateTolerance (model, design, {}, [] (double) {}); });
    watched ("trade-off", [&] { sweepTradeoff (model, focus, playback); });
    PlacingOptions placing;
    placing.count = 6;
    placing.grid.modes = 20;
    const auto plate = loadDevice ("aluminium-200x120", {});
    watched ("place",
             [&]
             {
                 auto bare = plate;
                 auto& common = std::get<PlateDescription> (bare.body).common;
                 const auto like = common.ceramics.front();
                 common.ceramics.clear();
                 placeCeramics (bare, like, placing);
             });
    const auto truth = knownPlate (2);
    auto responses = idealResponses (truth, lines (200, 30500, 4));
    addNoise (responses, 40, 2);
    IdentificationOptions options;
    options.complexModes = true;
    watched ("identify", [&] { identify (responses, options); });
}

TEST_CASE ("A plate with 64 ceramics and 500 modes looks at the watch", "[.][watch-large]")
{
    ModalModel model;
    watched ("largest plate solve", [&] { model = solveStructure (largestPlate()); });
    for (const auto method : allMethods)
        watched ("largest plate " + nameOf (method),
                 [&] { designFocus (model, largeFocus (method), playback, DesignExtent::playable); });
}
