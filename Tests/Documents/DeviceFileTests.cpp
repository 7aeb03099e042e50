#include "Support/ErrorText.h"
#include "Support/GoodFiles.h"

#include <antinode_documents/DeviceFile.h>
#include <antinode_text/JsonText.h>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
nlohmann::json goodDocument (std::string_view name)
{
    const auto& files = goodFiles();
    const auto found = std::find_if (files.begin(), files.end(), [&] (const auto& file) { return file.name == name; });
    return parseJson (found->text, std::string (name));
}

template <typename Body>
Body readBody (std::string_view name)
{
    return std::get<Body> (readDevice (goodDocument (name), "my.json").body);
}

/** The error of a good document in which one value is set to another. */
std::string errorWith (std::string_view name, std::string_view assignment)
{
    auto document = goodDocument (name);
    applyAssignment (document, assignment);
    return errorText ([&] { readDevice (document, "my.json"); });
}
} // namespace

TEST_CASE ("A plate is read with all its keys, in SI units", "[files]")
{
    const auto device = readDevice (goodDocument ("plate"), "my.json");
    const auto plate = std::get<PlateDescription> (device.body);
    CHECK (device.name == "pane");
    CHECK (device.description == "two\nlines");
    CHECK (plate.lengthX == 0.2);
    CHECK (plate.lengthY == 0.12);
    CHECK (plate.common.thickness == 0.001);
    CHECK (plate.common.material.youngsModulus2 == 10e9);
    CHECK (plate.common.material.shearModulus == 4e9);
    CHECK (plate.left == EdgeCondition::clamped);
    CHECK (plate.right == EdgeCondition::simplySupported);
    CHECK (plate.top == EdgeCondition::free);
    CHECK (plate.common.dampingRatios == std::vector<double> { 1 / 380.0, 1 / 120.0 });
    CHECK (plate.common.voltageLimit == 150);
    CHECK (plate.common.fullScaleVoltage == 200);
    CHECK (plate.common.maximumFrequency == 30000.0);
    CHECK (plate.common.modeCount == 50);
}

TEST_CASE ("The ceramics of a plate are given by their lower left corner", "[files]")
{
    const auto ceramics = readBody<PlateDescription> ("plate").common.ceramics;
    REQUIRE (ceramics.size() == 2);
    CHECK (ceramics[0].x == 0.01);
    CHECK (ceramics[0].y == 0.015);
    CHECK (ceramics[0].sizeY == 0.02);
    CHECK (ceramics[0].polarity == -1);
    CHECK (ceramics[0].capacitance == 21.5e-9);
    CHECK (ceramics[0].lossFactor == 0.015);
    CHECK (ceramics[1].capacitance == 0);
    CHECK (ceramics[1].lossFactor == 0.02);
    CHECK (ceramics[0].material.d31 == -195e-12);
    CHECK (ceramics[1].mounting == CeramicMounting::oneSide);
    CHECK (ceramics[1].wiring == CeramicWiring::series);
    CHECK (ceramics[1].material.permittivityRelative == 1850);
    CHECK (ceramics[1].name.empty());
}

TEST_CASE ("The ceramics of a beam are given by their centre", "[files]")
{
    const auto beam = readBody<BeamDescription> ("beam");
    REQUIRE (beam.common.ceramics.size() == 1);
    CHECK (beam.common.ceramics[0].x == Approx (-0.0245).epsilon (1e-15));
    CHECK (beam.common.ceramics[0].y == -0.0025);
    CHECK (beam.common.ceramics[0].sizeX == 0.009);
    CHECK (beam.left == EdgeCondition::guided);
    CHECK (beam.common.dampingRatios == std::vector<double> { 0.005, 0.01 });
    CHECK (beam.common.fullScaleVoltage == 150);
    CHECK_FALSE (beam.common.maximumFrequency.has_value());
}

TEST_CASE ("An isotropic material has the shear modulus E / (2 (1 + nu))", "[files]")
{
    const auto material = readBody<BeamDescription> ("beam").common.material;
    CHECK (material.youngsModulus1 == 70e9);
    CHECK (material.youngsModulus2 == 70e9);
    CHECK (material.shearModulus == Approx (70e9 / 2.66).epsilon (1e-15));
}

TEST_CASE ("A staple is read with built-in materials", "[files]")
{
    const auto staple = readBody<StapleDescription> ("minimal staple");
    CHECK (staple.topLength == 0.15);
    CHECK (staple.legLength == 0.017);
    CHECK (staple.width == 0.01);
    CHECK (staple.common.material.density == 2700);
    CHECK (staple.common.dampingRatios == std::vector<double> { 1 / 120.0 });
}

TEST_CASE ("Errors for typical mistakes in devices give their position and what is allowed", "[files]")
{
    CHECK (errorWith ("plate", "ceramics.0.x_mm=-7") == "my.json: /ceramics/0/x_mm: is -7; allowed: 0 to 175");
    CHECK (errorWith ("beam", "ceramics.0.x_mm=48") == "my.json: /ceramics/0/x_mm: is 48; allowed: -45.5 to 45.5");
    CHECK (errorWith ("beam", "ceramics.0.width_mm=13")
           == "my.json: /ceramics/0/width_mm: is 13; allowed: 0.0001 to 12");
    CHECK (errorWith ("plate", "ceramics.1.x_mm=30")
           == "my.json: /ceramics/1: overlaps /ceramics/0; ceramics may only touch");
    CHECK (errorWith ("beam", "thickness_mm=0") == "my.json: /thickness_mm: is 0; allowed: 0.0001 to 100000");
    CHECK (errorWith ("beam", "thickness_mm=two")
           == "my.json: /thickness_mm: is the text 'two'; allowed: a number, 0.0001 to 100000");
    CHECK (errorWith ("beam", "lenght_mm=7")
           == "my.json: /lenght_mm: is an unknown key (did you mean 'length_mm'?); allowed: 'schema', 'name', "
              "'description', 'kind', "
              "'thickness_mm', 'material', 'damping_ratio', 'quality_factor', 'ceramics', 'limits', 'modes', "
              "'theory', 'length_mm', 'width_mm', 'ends'");
    CHECK (errorWith ("beam", "quality_factor=60")
           == "my.json: has both 'damping_ratio' and 'quality_factor'; allowed: exactly one of the two");
    CHECK (errorWith ("plate", "quality_factor=0.5")
           == "my.json: /quality_factor: is 0.5; allowed: above 0.5 to 1000000000");
    CHECK (errorWith ("beam", "damping_ratio.1=1") == "my.json: /damping_ratio/1: is 1; allowed: above 0 to below 1");
    CHECK (errorWith ("beam", "kind=disc")
           == "my.json: /kind: is the text 'disc'; allowed: one of 'plate', 'beam', 'staple', 'modal'");
    CHECK (errorWith ("beam", "schema=antinode.focus/1")
           == "my.json: /schema: is the text 'antinode.focus/1'; allowed: 'antinode.device/1'");
    CHECK (errorWith ("beam", "ends.left=clampd")
           == "my.json: /ends/left: is the text 'clampd' (did you mean 'clamped'?); allowed: one of 'clamped', "
              "'simply_supported', "
              "'free', 'guided'");
    CHECK (errorWith ("beam", "material=alumimium")
               .find ("my.json: /material: is the text 'alumimium' (did you mean 'aluminium'?); allowed: ")
           == 0);
    CHECK (errorWith ("plate", "material.nu12=2.1") == "my.json: /material/nu12: is 2.1; allowed: above -2 to below 2");
    CHECK (errorWith ("plate", "modes.count=2.5")
           == "my.json: /modes/count: is 2.5; allowed: a whole number from 1 to 5000");
    CHECK (errorWith ("plate", "ceramics.0.polarity=2") == "my.json: /ceramics/0/polarity: is 2; allowed: 1 or -1");
    CHECK (errorWith ("plate", "name=\"a\\nb\"")
           == "my.json: /name: has control characters; allowed: plain text in UTF-8");
    CHECK (errorWith ("plate", "description=\"a\\u2028b\"")
           == "my.json: /description: has control characters; allowed: plain text in UTF-8");
    CHECK (errorWith ("minimal staple", "name=[]") == "my.json: /name: is a list; allowed: text");
}

TEST_CASE ("Ceramics may touch each other and the edges, within rounding", "[files]")
{
    CHECK (errorWith ("plate", "ceramics.1.x_mm=175").empty());
    CHECK (errorWith ("plate", "ceramics.1.x_mm=34.9999999").empty());
    CHECK_FALSE (errorWith ("plate", "ceramics.1.x_mm=34.9999").empty());
    CHECK (errorWith ("beam", "ceramics.0.x_mm=45.5").empty());
    CHECK (errorWith ("beam", "ceramics=[]").empty());
}
