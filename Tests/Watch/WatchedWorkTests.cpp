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

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <random>
#include <thread>

using namespace antinode;
using namespace antinode::test;

namespace
{
using Model = std::shared_ptr<const ModalModel>;
const Playback playback { Reconstruction::bandLimited, 192000 };

/** ms of the processor: far more than the 20 ms that are promised, so that only work that does not look is found. */
constexpr auto maximumWait = 250.0;

Model makeModel (const DeviceDescription& device)
{
    return std::make_shared<const ModalModel> (solveStructure (device));
}

LongWork solving (const std::string& name, const DeviceDescription& device)
{
    return { name + " solve", [device] { solveStructure (device); } };
}

/** A design that may be refused: that is an answer, too. */
LongWork designing (const std::string& name, const Model& model, const FocusDescription& focus, DesignExtent extent)
{
    return { name, [=]
             {
                 try
                 {
                     designFocus (*model, focus, playback, extent);
                 }
                 catch (const InputError&)
                 {
                 }
             } };
}

void addMethods (std::vector<LongWork>& works, const std::string& name, const Model& model, FocusDescription focus,
                 DesignExtent extent)
{
    for (const auto& [word, method] : allocationMethodWords)
    {
        focus.allocation.method = method;
        const auto isPlayed = method == AllocationMethod::leastVoltage ? DesignExtent::complete : extent;
        works.push_back (designing (name + " " + std::string (word), model, focus, isPlayed));
    }

    focus.allocation.timesBound = upToLimits;
    focus.allocation.method = AllocationMethod::leastVoltage;
    works.push_back (designing (name + " up to the limits", model, focus, DesignExtent::complete));
}

std::vector<LongWork> worksOnEmbeddedDevices()
{
    std::vector<LongWork> works;

    for (const auto& [device, focus] : embeddedCases)
    {
        const auto description = loadDevice (device, {});
        works.push_back (solving (device, description));
        addMethods (works, device, makeModel (description), loadFocus (focus, {}), DesignExtent::complete);
    }

    return works;
}

LongWork placing()
{
    auto bare = loadDevice ("aluminium-200x120", {});
    auto& common = std::get<PlateDescription> (bare.body).common;
    const auto like = common.ceramics.front();
    common.ceramics.clear();
    PlacingOptions options;
    options.count = 6;
    options.grid.modes = 20;
    options.grid.step = 5e-3;
    return { "place", [=] { placeCeramics (bare, like, options); } };
}

LongWork identifying()
{
    const auto truth = knownPlate (2);
    auto responses = idealResponses (truth, lines (200, 30500, 4));
    addNoise (responses, 40, 2);
    IdentificationOptions options;
    options.complexModes = true;
    return { "identify", [=] { identify (responses, options); } };
}

std::vector<LongWork> otherWorks()
{
    const auto model = makeModel (loadDevice ("staple", {}));
    const auto focus = loadFocus ("demonstrator", {});
    const auto design = designFocus (*model, focus, playback);
    auto braked = focus, robust = focus;
    braked.transients.brakeDuration = 0.02;
    robust.allocation.robust = Robustness {};
    return { { "render", [=] { renderFocus (*model, design, {}); } },
             designing ("brake", model, braked, DesignExtent::complete),
             designing ("robust", model, robust, DesignExtent::complete),
             designing ("train", model, loadFocus ("staple-train", {}), DesignExtent::complete),
             { "tolerance", [=] { evaluateTolerance (*model, design, {}, [] (double) {}); } },
             { "trade-off", [=] { sweepTradeoff (*model, focus, playback); } },
             placing(),
             identifying() };
}

/** @param model  of the largest plate */
std::vector<LongWork> worksOnLargestPlate (const Model& model)
{
    std::vector<LongWork> works;
    addMethods (works, "largest plate", model, largeFocus (AllocationMethod::exact), DesignExtent::playable);
    works.push_back (
        designing ("largest plate with bound", model, largeFocus (AllocationMethod::paper), DesignExtent::complete));
    const auto design = designFocus (*model, largeFocus (AllocationMethod::paper), playback, DesignExtent::playable);
    works.push_back ({ "largest plate render", [=] { renderFocus (*model, design, {}); } });
    return works;
}

/** Runs some work, at most so long, and prints how long its looks are apart. */
void checkLooks (const LongWork& work, double maximum = std::numeric_limits<double>::infinity())
{
    const WatchedWork watched (work.run, maximum);
    std::printf ("%-36s %9.1f ms%s  median %8.3f ms  worst %8.2f ms  %9zu looks\n", work.name.c_str(),
                 watched.duration(), watched.isCancelled() ? " (cancelled)" : "", watched.medianWait(),
                 watched.worstWait(), watched.looks());
    std::fflush (stdout);
    INFO (work.name);
    CHECK (watched.worstWait() < maximumWait);
}

/** ms from a moment of the work at which it is cancelled to its end on the clock; 0 if it had ended. */
double timeToCancel (const LongWork& work, double moment)
{
    using Clock = std::chrono::steady_clock;
    std::atomic<bool> goesOn { true }, isDone { false };
    std::thread thread (
        [&]
        {
            try
            {
                const WatchScope scope ([&] { return goesOn.load(); });
                work.run();
            }
            catch (const Cancelled&)
            {
            }

            isDone = true;
        });
    const auto end = Clock::now() + std::chrono::duration<double, std::milli> (moment);

    while (! isDone && Clock::now() < end)
        std::this_thread::sleep_for (std::chrono::microseconds (200));

    const auto asked = Clock::now();
    const auto hasEnded = isDone.load();
    goesOn = false;
    thread.join();
    return hasEnded ? 0 : std::chrono::duration<double, std::milli> (Clock::now() - asked).count();
}

/** Cancels each work many times, at moments that are as often within the first millisecond as within the tenth second.
 */
void cancelAtRandom (const std::vector<LongWork>& works, int times)
{
    std::mt19937 random (1);
    std::uniform_real_distribution<double> exponent (-1, 3.3);

    for (const auto& work : works)
    {
        std::vector<double> waits;

        for (int i = 0; i < times; ++i)
            if (const auto wait = timeToCancel (work, std::pow (10, exponent (random))); wait > 0)
                waits.push_back (wait);

        std::sort (waits.begin(), waits.end());

        if (! waits.empty())
            std::printf ("%-36s cancelled %4zu times: median %8.3f ms, worst %8.2f ms\n", work.name.c_str(),
                         waits.size(), waits[waits.size() / 2], waits.back());

        std::fflush (stdout);
    }
}
} // namespace

TEST_CASE ("All long work on the embedded devices looks at its watch", "[watch]")
{
    constexpr auto atMost = 700.0; // ms each: what comes later is looked at by the hidden test below
    std::vector<LongWork> works;

    for (const auto& [device, focus] : { embeddedCases[0], embeddedCases[1] })
        addMethods (works, device, makeModel (loadDevice (device, {})), loadFocus (focus, {}), DesignExtent::complete);

    for (const auto& [device, focus] : embeddedCases)
        works.push_back (solving (device, loadDevice (device, {})));

    for (const auto& work : works)
        checkLooks (work, atMost);

    for (const auto& work : otherWorks())
        checkLooks (work, atMost);
}

TEST_CASE ("Solving a plate with 64 ceramics and 500 modes looks at its watch", "[watch]")
{
    checkLooks (solving ("largest plate", largestPlate()), 3000);
}

TEST_CASE ("All work on the embedded devices looks at its watch to its end", "[.][watch-embedded]")
{
    for (const auto& work : worksOnEmbeddedDevices())
        checkLooks (work, 20000);
}

TEST_CASE ("All other work looks at its watch to its end", "[.][watch-other]")
{
    for (const auto& work : otherWorks())
        checkLooks (work);
}

TEST_CASE ("All work on a plate with 64 ceramics and 500 modes looks at its watch", "[.][watch-largest]")
{
    ModalModel model;
    checkLooks ({ "largest plate solve", [&] { model = solveStructure (largestPlate()); } });

    for (const auto& work : worksOnLargestPlate (std::make_shared<const ModalModel> (model)))
        checkLooks (work, 20000);
}

TEST_CASE ("All long work is cancelled a thousand times at random moments", "[.][watch-1000]")
{
    cancelAtRandom (worksOnEmbeddedDevices(), 1000);
    cancelAtRandom (otherWorks(), 1000);
    cancelAtRandom ({ solving ("largest plate", largestPlate()) }, 1000);
    cancelAtRandom (worksOnLargestPlate (makeModel (largestPlate())), 1000);
}

TEST_CASE ("All long work is cancelled twenty times at random moments", "[.][watch-20]")
{
    cancelAtRandom (worksOnEmbeddedDevices(), 20);
    cancelAtRandom (otherWorks(), 20);
}
