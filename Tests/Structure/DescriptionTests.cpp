#include "StructureExamples.h"

#include <antinode_base/InputError.h>

#include <catch2/catch.hpp>

#include <functional>
#include <limits>

using namespace antinode;
using namespace antinode::examples;

namespace
{
BeamDescription twoCeramics()
{
    auto beam = uniformBeam (EdgeCondition::clamped, EdgeCondition::free);
    beam.common.ceramics = { ceramicPair (-0.05, 0.03, 0.008, 0.5e-3), ceramicPair (0.05, 0.03, 0.008, 0.5e-3) };
    return beam;
}

struct BrokenBeam
{
    std::string complaint;
    std::function<void (BeamDescription&)> breakIt;
};

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

const std::vector<BrokenBeam> brokenBeams {
    { "length is 0", [] (auto& beam) { beam.length = 0; } },
    { "length is nan", [] (auto& beam) { beam.length = notANumber; } },
    { "length is inf", [] (auto& beam) { beam.length = infinite; } },
    { "width is -1", [] (auto& beam) { beam.width = -1; } },
    { "thickness is 0", [] (auto& beam) { beam.common.thickness = 0; } },
    { "Young's modulus of the substrate", [] (auto& beam) { beam.common.material.youngsModulus1 = -7; } },
    { "density of the substrate", [] (auto& beam) { beam.common.material.density = 0; } },
    { "full-scale voltage", [] (auto& beam) { beam.common.fullScaleVoltage = 0; } },
    { "voltage limit is -1", [] (auto& beam) { beam.common.voltageLimit = -1; } },
    { "no damping ratio", [] (auto& beam) { beam.common.dampingRatios.clear(); } },
    { "damping ratio is 0",
      [] (auto& beam) {
          beam.common.dampingRatios = { 0.1, 0 };
      } },
    { "damping ratio is 1", [] (auto& beam) { beam.common.dampingRatios = { 1 }; } },
    { "damping ratio is nan", [] (auto& beam) { beam.common.dampingRatios = { notANumber }; } },
    { "ceramic 2 (right): overlaps ceramic 1 by",
      [] (auto& beam)
      {
          beam.common.ceramics[1].name = "right";
          beam.common.ceramics[1].x = -0.036;
      } },
    { "ceramic 1: extends from -101 mm", [] (auto& beam) { beam.common.ceramics[0].x = -0.101; } },
    { "ceramic 2: extends from 71 mm to 101 mm; allowed: -100 mm to 100 mm",
      [] (auto& beam) { beam.common.ceramics[1].x = 0.071; } },
    { "ceramic 1: extends from nan", [] (auto& beam) { beam.common.ceramics[0].x = notANumber; } },
    { "ceramic 1: width is 11 mm; allowed: up to", [] (auto& beam) { beam.common.ceramics[0].sizeY = 0.011; } },
    { "ceramic 1: length is 0 mm", [] (auto& beam) { beam.common.ceramics[0].sizeX = 0; } },
    { "ceramic 1: width is 0", [] (auto& beam) { beam.common.ceramics[0].sizeY = 0; } },
    { "ceramic 1: thickness is -1", [] (auto& beam) { beam.common.ceramics[0].thickness = -1; } },
    { "ceramic 1: Young's modulus", [] (auto& beam) { beam.common.ceramics[0].material.youngsModulus = 0; } },
    { "ceramic 1: density", [] (auto& beam) { beam.common.ceramics[0].material.density = 0; } },
    { "ceramic 1: d31", [] (auto& beam) { beam.common.ceramics[0].material.d31 = infinite; } },
    { "ceramic 1: polarity is 0", [] (auto& beam) { beam.common.ceramics[0].polarity = 0; } },
    { "number of modes is 0", [] (auto& beam) { beam.common.modeCount = 0; } },
    { "number of modes is 201", [] (auto& beam) { beam.common.modeCount = 201; } },
    { "no mode up to its maximum frequency", [] (auto& beam) { beam.common.maximumFrequency = 1; } },
    { "maximum frequency is", [] (auto& beam) { beam.common.maximumFrequency = 1e12; } },
    { "maximum frequency is", [] (auto& beam) { beam.common.maximumFrequency = notANumber; } },
    { "of such different size", [] (auto& beam) { beam.common.thickness = 1e200; } },
    { "of such different size", [] (auto& beam) { beam.common.thickness = 1e-200; } },
    { "of such different size", [] (auto& beam) { beam.common.ceramics[0].thickness = 1e200; } },
    { "of such different size", [] (auto& beam) { beam.width = beam.common.ceramics[0].sizeY = 1e308; } },
};
} // namespace

TEST_CASE ("a broken description is refused in one sentence that names the place", "[structure]")
{
    for (const auto& broken : brokenBeams)
    {
        auto beam = twoCeramics();
        broken.breakIt (beam);
        CAPTURE (broken.complaint);
        CHECK_THROWS_AS (solved (beam), InputError);
        CHECK_THROWS_WITH (solved (beam), Catch::Contains (broken.complaint));
    }
}

TEST_CASE ("a staple needs a top and legs", "[structure]")
{
    auto staple = bareStaple();
    staple.legLength = 0;
    CHECK_THROWS_WITH (solved (staple), Catch::Contains ("length of the legs is 0"));
    staple = bareStaple();
    staple.topLength = -1;
    CHECK_THROWS_WITH (solved (staple), Catch::Contains ("length of the top is -1"));
}

TEST_CASE ("more ceramics than the solver has room for are refused before it works on them", "[structure]")
{
    auto beam = uniformBeam (EdgeCondition::clamped, EdgeCondition::free);

    for (int i = 0; i < 600; ++i)
        beam.common.ceramics.push_back (ceramicPair (-0.0999 + i * 0.0003, 0.0001, 0.01, 0.1e-3));

    CHECK_THROWS_WITH (solved (beam, 10), Catch::Contains ("unknowns; allowed: "));
}

TEST_CASE ("the model takes over names, places, limits and damping", "[structure]")
{
    auto beam = twoCeramics();
    beam.common.ceramics[1].name = "right";
    beam.common.dampingRatios = { 0.1, 0.2 };
    beam.common.fullScaleVoltage = 200;
    const auto model = solved (beam, 4);

    CHECK (model.name == "example");
    REQUIRE (model.ceramics.size() == 2);
    CHECK (model.ceramics[0].name == "C1");
    CHECK (model.ceramics[1].name == "right");
    CHECK (model.ceramics[1].xMinimum == Approx (0.035));
    CHECK (model.ceramics[1].xMaximum == Approx (0.065));
    CHECK (model.ceramics[1].voltageLimit == 150);
    CHECK (model.fullScaleVoltage == 200);
    CHECK (model.dampingRatios == Eigen::Vector4d (0.1, 0.2, 0.2, 0.2));
}

TEST_CASE ("ceramics may lie in any order and fill the beam to its ends", "[structure]")
{
    auto beam = uniformBeam (EdgeCondition::clamped, EdgeCondition::free);
    beam.common.ceramics = { ceramicPair (0.05, 0.1, 0.01, 0.5e-3), ceramicPair (-0.05, 0.1, 0.01, 0.5e-3) };
    const Eigen::MatrixXd participation = solved (beam, 3).participation;
    std::swap (beam.common.ceramics[0], beam.common.ceramics[1]);
    CHECK (solved (beam, 3).participation == participation.rowwise().reverse());
}

TEST_CASE ("a measured line is handed on with slopes, and a broken one is refused", "[structure]")
{
    auto measured = solved (uniformBeam (EdgeCondition::simplySupported, EdgeCondition::simplySupported), 3);
    const Eigen::MatrixXd slopes = measured.slopes;
    measured.slopes.resize (0, 0);
    const auto handedOn = solved (measured);
    CHECK (handedOn.shapes == measured.shapes);
    CHECK ((handedOn.slopes - slopes).cwiseAbs().maxCoeff() < 1e-4 * slopes.cwiseAbs().maxCoeff());

    measured.slopes = slopes;
    CHECK (solved (measured).slopes == slopes);

    measured.dampingRatios[1] = 2;
    CHECK_THROWS_AS (solved (measured), InputError);
}
