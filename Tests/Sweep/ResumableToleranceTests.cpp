#include "Support/TemporaryFolder.h"

#include <antinode_documents/Inputs.h>
#include <antinode_documents/Library.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/Detuning.h>
#include <antinode_sweep/Deviation.h>
#include <antinode_sweep/ResumableTolerance.h>
#include <antinode_sweep/SweepCases.h>

#include <catch2/catch.hpp>

#include <filesystem>

using namespace antinode;

namespace
{
struct Designed
{
    ModalModel model = solveDevice (loadDevice ("beam", {}), {}, false);
    FocusDesign design = designFocus (model, loadFocus ("demonstrator", {}), { Reconstruction::bandLimited, 192000 },
                                      DesignExtent::compared);
};

std::vector<std::filesystem::path> partsIn (const std::filesystem::path& folder)
{
    std::vector<std::filesystem::path> parts;

    for (const auto& entry : std::filesystem::recursive_directory_iterator (folder))
        if (entry.path().extension() == ".part")
            parts.push_back (entry.path());

    return parts;
}
} // namespace

TEST_CASE ("A tolerance study that resumes is the study itself, to the bit", "[sweep]")
{
    const TemporaryFolder folder;
    const Designed made;
    const ToleranceOptions options { { 0.001, 0.1, 0.05, 0.002 }, 60, 7 };
    const auto ignore = [] (double) {};
    const auto plain = evaluateTolerance (made.model, made.design, options, ignore);
    const auto isSame = [&] (const Tolerance& other)
    {
        REQUIRE (other.draws.size() == plain.draws.size());

        for (std::size_t i = 0; i < plain.draws.size(); ++i)
            if (other.draws[i].vScore != plain.draws[i].vScore || other.draws[i].fieldError != plain.draws[i].fieldError
                || other.draws[i].peakRatio != plain.draws[i].peakRatio)
                return false;

        return other.fieldError == plain.fieldError && other.known.vScore == plain.known.vScore;
    };
    CHECK (isSame (resumableTolerance (folder.path(), made.model, made.design, options, ignore)));
    const auto parts = partsIn (folder.path());
    REQUIRE (parts.size() == 60);

    // As after a kill: some parts are missing, one is cut off. The others are not computed again.
    std::filesystem::remove (parts[3]);
    std::filesystem::remove (parts[41]);
    std::filesystem::resize_file (parts[20], 30);
    const auto kept = std::filesystem::last_write_time (parts[10]);
    int shown = 0;
    CHECK (isSame (resumableTolerance (folder.path(), made.model, made.design, options, [&] (double) { ++shown; })));
    CHECK (shown == 3);
    CHECK (std::filesystem::last_write_time (parts[10]) == kept);

    // Other options, other devices.
    auto other = options;
    other.seed = 8;
    CHECK_FALSE (isSame (resumableTolerance (folder.path(), made.model, made.design, other, ignore)));
    CHECK (partsIn (folder.path()).size() == 120);
}

TEST_CASE ("A plan and a tolerance study with the same seed draw the same devices", "[sweep]")
{
    const auto model = withoutShapes (solveDevice (loadDevice ("beam", {}), {}, false));
    SweepPlan plan;
    plan.seed = 5;
    plan.cases = 100;
    Deviation deviation;
    deviation.spread = usualSpread;

    for (const std::uint64_t number : { 0, 1, 99 })
    {
        const auto here = deviated (model, deviation, deviationSeed (plan, number));
        const auto there = detuned (model, usualSpread, drawSeed (5, number));
        CHECK (here.angularFrequencies == there.angularFrequencies);
        CHECK (here.dampingRatios == there.dampingRatios);
        CHECK (here.participation == there.participation);
    }

    CHECK (deviationSeed (plan, 0) != deviationSeed (plan, 1));
}
