#include <antinode_documents/DeviceFile.h>
#include <antinode_documents/Inputs.h>
#include <antinode_text/JsonText.h>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
std::vector<std::string> warningsAfter (const std::string& name, const std::string& assignment)
{
    auto document = loadDocument (LibraryKind::device, name);
    applyAssignment (document, assignment);
    return unlikelyValues (document);
}
} // namespace

TEST_CASE ("No embedded device has a number that hardly any has", "[files]")
{
    for (const auto& name : factoryNames (LibraryKind::device))
    {
        INFO (name);
        CHECK (unlikelyValues (loadDocument (LibraryKind::device, name)).empty());
    }
}

TEST_CASE ("A number in another unit than its key says is told, with the unit that is likely", "[files]")
{
    const auto sentence = [] (const std::string& assignment, const std::string& name = "beam")
    {
        const auto warnings = warningsAfter (name, assignment);
        REQUIRE (warnings.size() == 1);
        return warnings.front();
    };
    CHECK (sentence ("thickness_mm=0.0011")
           == "/thickness_mm is 0.0011, which hardly any device has: if it was meant in m, write 1.1.");
    CHECK (sentence ("thickness_mm=2000")
           == "/thickness_mm is 2000, which hardly any device has: if it was meant in um, write 2.");
    CHECK_THAT (sentence ("length_mm=0.2"), Catch::EndsWith ("in m, write 200."));
    CHECK_THAT (sentence ("ceramics.1.thickness_mm=0.0005"), Catch::StartsWith ("/ceramics/1/thickness_mm is 0.0005"));
    CHECK_THAT (sentence ("material={\"youngs_modulus_GPa\": 70000, \"poisson_ratio\": 0.33, \"density_kg_m3\": 2700}"),
                Catch::EndsWith ("in MPa, write 70."));
    CHECK_THAT (sentence ("material={\"youngs_modulus_GPa\": 70, \"poisson_ratio\": 0.33, \"density_kg_m3\": 2.7}"),
                Catch::EndsWith ("in g/cm^3, write 2700."));
    CHECK_THAT (sentence ("limits.voltage_V=0.15"), Catch::EndsWith ("in kV, write 150."));
    CHECK_THAT (sentence ("ceramics.0.capacitance_nF=0.005"), Catch::EndsWith ("in uF, write 5."));
    CHECK_THAT (sentence ("damping_ratio=0.8"), Catch::EndsWith ("in %, write 0.008."));

    CHECK (warningsAfter ("beam", "thickness_mm=1.1").empty());
}

TEST_CASE ("What is unlikely in a device is said beside its modes", "[files]")
{
    const auto device = loadDevice ("beam", { "device.thickness_mm=0.011" });
    REQUIRE (device.warnings.size() == 1);
    CHECK (solveDevice (device, 5, false).warnings.at (0) == device.warnings.at (0));
}
