#include "Support/RunProgram.h"

#include <antinode_documents/Inputs.h>
#include <antinode_text/JsonText.h>
#include <antinode_text/OutputFolder.h>

#include <catch2/catch.hpp>

using namespace antinode;
using test::ProgramArguments;
using test::readContent;
using test::runProgram;

namespace
{
/** The embedded beam with all that a device says of its outputs. */
nlohmann::json armedBeam()
{
    auto beam = loadDocument (LibraryKind::device, "beam");
    beam["limits"] = {
        { "voltage_V", 120 }, { "full_scale_V", 150 }, { "slew_V_per_us", 20 }, { "requires_arming", true }
    };
    beam["ceramics"][2]["name"] = "third from the left";
    beam["modes"]["count"] = 12;
    return beam;
}

void runWell (const ProgramArguments& arguments)
{
    const auto done = runProgram (arguments);
    INFO (arguments.front().text << ": " << done.errors);
    REQUIRE (done.exitCode == 0);
}

/** What a written device must say as the one before did. */
void checkKept (const std::filesystem::path& file)
{
    INFO (file.string());
    const auto document = parseJson (readContent (file), file.string());
    const auto before = armedBeam();

    for (const auto& [key, value] : before["limits"].items())
        CHECK (document["limits"][key] == value);

    const auto device = loadDevice (file.string(), {});
    CHECK (device.requiresArming);
    CHECK (device.description.starts_with (before["description"].get<std::string>().substr (0, 20)));
    CHECK (std::filesystem::file_size (file) < 200000);

    if (const auto model = solveStructure (device); model.actuators() == 6)
        CHECK (model.ceramics[2].name == "third from the left");
}
} // namespace

TEST_CASE ("Every command that writes a device keeps limits, arming and names", "[command line][safety]")
{
    const TemporaryFolder temporary;
    const auto folder = temporary.path();
    const auto beam = folder / "beam.json", points = folder / "points.csv";
    writeWholeFile (beam, armedBeam().dump());
    writeWholeFile (points, "x_mm,y_mm\n-61,0\n-20,0\n33,0\n70,0\n");

    for (const auto* const level : { "5", "50" })
        runWell ({ "measure", "--device", beam, "--points", points, "--simulate", "--rate", "48000", "--level-v", level,
                   "--no-questions", "--out", folder / level });

    const auto low = folder / "5" / "responses.uff", high = folder / "50" / "responses.uff";
    runWell ({ "retune", beam, low, "--out", folder / "retuned.json" });
    runWell ({ "retune", folder / "retuned.json", low, "--out", folder / "again.json" });
    runWell ({ "identify", low, "--against", beam, "--transfer", folder / "transferred.json", "--out",
               folder / "identified.json" });
    runWell ({ "hysteresis", beam, "--low", low, "--high", high, "--low-level-v", "5", "--high-level-v", "50",
               "--played-level-v", "30", "--out", folder / "hysteresis" });
    runWell ({ "calibrate", "--device", beam, "--simulate", "--rate", "48000", "--resolution-hz", "50", "--out",
               folder / "calibrated" });
    runWell ({ "learn", "demonstrator", "--device", beam, "--sensors", points, "--simulate", "--passes", "1", "--rate",
               "48000", "--duration-ms", "60", "--out", folder / "learnt" });
    runWell ({ "place", beam, "--count", "2", "--modes", "5", "--frozen", "--out", folder / "placed.json" });

    for (const auto* const name : { "retuned.json", "again.json", "transferred.json", "hysteresis/device.json",
                                    "calibrated/device.json", "learnt/device.json", "placed.json" })
        checkKept (folder / name);

    // Its shapes are measured: it says itself how.
    const auto identified = loadDevice ((folder / "identified.json").string(), {});
    CHECK (identified.requiresArming);
    CHECK (solveStructure (identified).ceramics[2].name == "third from the left");
    CHECK (solveStructure (identified).ceramics[2].voltageLimit == 120);
}
