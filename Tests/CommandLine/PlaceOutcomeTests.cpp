#include <antinode_tasks/PlacementOutcomes.h>

#include <antinode_documents/Inputs.h>

#include <catch2/catch.hpp>

#include <numeric>

using namespace antinode;

TEST_CASE ("What focuses need does not depend on what limits the device", "[place]")
{
    const auto device = solveStructure (loadDevice ("staple", {}));
    auto limited = device;
    limited.fullScaleVoltage = 2;

    for (auto& ceramic : limited.ceramics)
        ceramic.slewLimit = 1e4;

    const std::vector focuses { loadFocus ("demonstrator", {}) };
    const auto free = placementOutcomes (device, focuses), bound = placementOutcomes (limited, focuses);
    REQUIRE (free.size() == 1);
    CHECK (free[0].peakVoltage > 2);
    CHECK (bound[0].peakVoltage == free[0].peakVoltage);
    CHECK (bound[0].limit == 2);
}

TEST_CASE ("The cost of ceramics is the highest voltage that a focus needs of them", "[place]")
{
    const auto device = loadDevice ("staple", {});
    PlacementCandidates candidates;
    candidates.ceramics = std::get<StapleDescription> (device.body).common.ceramics;
    const std::vector focuses { loadFocus ("demonstrator", {}) };
    const auto played = placementOutcomes (solveStructure (device), focuses);
    const auto costOf = peakVoltageCost (device, focuses) (candidates);
    std::vector<Eigen::Index> all (candidates.ceramics.size());
    std::iota (all.begin(), all.end(), 0);
    const auto cost = costOf (all);

    // Rendered samples may miss the peak of the designed waveform.
    CHECK (cost == Approx (played[0].peakVoltage).epsilon (1e-3));
    CHECK (costOf ({ 0, 1, 2 }) > 1.5 * cost);
}
