#include "Support/RunProgram.h"

#include <antinode_documents/FocusFile.h>
#include <antinode_text/OutputFolder.h>
#include <antinode_text/WaveFile.h>

#include <nlohmann/json.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <sstream>
#include <tuple>

using namespace antinode;
using test::linesIn;
using test::ProgramArguments;
using test::readContent;
using test::runProgram;

TEST_CASE ("Help ends with 0, wrong usage with 2, bad input with 1 and one line", "[command line]")
{
    CHECK (runProgram ({ "--help" }).exitCode == 0);

    for (const auto* command : { "devices", "modes", "design", "render", "version" })
        CHECK (runProgram ({ command, "--help" }).exitCode == 0);

    CHECK (runProgram ({}).exitCode == 2);
    CHECK (runProgram ({ "rendr" }).exitCode == 2);
    CHECK (runProgram ({ "render", "--no-such-option" }).exitCode == 2);

    for (const auto& [option, value] : { std::pair { "--format", "mp3" }, { "--rate", "7999" }, { "--rate", "nan" } })
    {
        const auto run = runProgram ({ "render", option, value });
        CHECK (run.exitCode == 2);
        CHECK (run.errors.starts_with ("antinode: " + std::string (option) + ": is "));
        CHECK (std::count (run.errors.begin(), run.errors.end(), '\n') == 1);
    }

    for (const auto& arguments :
         std::vector<ProgramArguments> { { "render", "no-such-focus" },
                                         { "render", "missing.json" },
                                         { "render", "--device", "no-such-device" },
                                         { "render", "--probe", "24,0,0" },
                                         { "render", "--probe", "200" },
                                         { "render", "--set", "x=1" },
                                         { "render", "--set", "focus.targets.7.x_mm=1" },
                                         { "render", "--set", "focus.target.0.x_mm=1" },
                                         { "render", "--duration-ms", "1" },
                                         { "render", "--out", "/dev/null" },
                                         { "modes", "/" },
                                         { "design", "--set", "focus.allocation.voltage_limit_V=1" } })
    {
        const auto run = runProgram (arguments);
        INFO (arguments.back().text << ": " << run.errors);
        CHECK (run.exitCode == 1);
        CHECK (linesIn (run.errors) == 1);
        CHECK (run.output.empty());
    }
}

TEST_CASE ("Misspelt commands and options are told what is meant", "[command line]")
{
    const auto answer = [] (const ProgramArguments& arguments)
    {
        const auto run = runProgram (arguments);
        CHECK (run.exitCode == 2);
        return run.errors;
    };
    CHECK (answer ({ "rendr" }) == "antinode: 'rendr' is unknown (did you mean 'render'?)\n");
    CHECK (answer ({ "render", "--rates", "48000" }) == "antinode: '--rates' is unknown (did you mean '--rate'?)\n");
    CHECK (answer ({ "render", "--rates=48000" }) == "antinode: '--rates' is unknown (did you mean '--rate'?)\n");
    CHECK_THAT (answer ({ "xyzzy" }), Catch::Contains ("subcommand"));
    CHECK_THAT (answer ({ "render", "--no-such-thing-at-all" }), Catch::Contains ("--no-such-thing-at-all"));
}

TEST_CASE ("The table of several focuses has felt level, energy and current, and ranks by them", "[command line]")
{
    const TemporaryFolder folder;
    writeWholeFile (folder.path() / "places.csv", "x_mm,y_mm\n-24,0\n10,0\n");
    const auto run = runProgram ({ "render", "demonstrator", "--places", folder.path() / "places.csv", "--rate",
                                   "48000", "--rank-by", "energy_J", "--quiet", "--out", folder.path() / "out" });
    INFO (run.errors);
    REQUIRE (run.exitCode == 0);
    std::istringstream table (readContent (folder.path() / "out" / "scores.csv"));
    std::string headings;
    std::getline (table, headings);

    for (const auto* const column : { ",felt_level_dB,", ",felt_contrast_dB,", ",energy_J,", ",peak_current_A,",
                                      ",peak_power_W,", ",power_repeated_real_power_mW,", ",spill_over_share," })
        CHECK_THAT (headings, Catch::Contains (column));

    std::vector<double> energies;

    for (std::string line; std::getline (table, line);)
    {
        const auto name = line.substr (0, line.find (','));
        const auto summary = nlohmann::json::parse (readContent (folder.path() / "out" / name / "summary.json"));
        energies.push_back (summary["power"]["per_focus"]["electrical_in_uJ"].get<double>());
    }

    REQUIRE (energies.size() == 2);
    CHECK (energies[0] < energies[1]);
}

TEST_CASE ("A limit that cannot be met is answered with the reachable velocity", "[command line]")
{
    const TemporaryFolder folder;
    const auto run =
        runProgram ({ "render", "--out", folder.path() / "out", "--set", "focus.allocation.voltage_limit_V=5" });
    CHECK (run.exitCode == 1);
    CHECK_THAT (run.errors, Catch::Contains ("focus: /allocation/voltage_limit_V: is ")
                                && Catch::Contains ("these drives need at least")
                                && Catch::Contains ("this limit allows "));
    CHECK_FALSE (std::filesystem::exists (folder.path() / "out" / "summary.json"));
}

TEST_CASE ("A full scale of 2 V below a voltage limit of 10 V limits what is rendered", "[command line]")
{
    const TemporaryFolder folder;
    const auto run =
        runProgram ({ "render", "--no-report", "--out", folder.path(), "--set", "device.limits.voltage_V=10", "--set",
                      "device.limits.full_scale_V=2", "--set", "focus.targets.0.peak_velocity_mm_s=3" });
    REQUIRE (run.exitCode == 0);
    CHECK_THAT (run.output, Catch::Contains ("the full scale of the device: ceramic "));
    const auto summary = nlohmann::json::parse (readContent (folder.path() / "summary.json"));
    CHECK (summary.at ("voltage_limit_V") == 2);
    CHECK (summary.at ("limit").at ("kind") == "full_scale");
    const auto voltages = decodeWave (readContent (folder.path() / "voltages.wav"), "voltages.wav").samples;
    CHECK (voltages.cwiseAbs().maxCoeff() <= 1);

    const auto refused = runProgram ({ "render", "--no-report", "--out", folder.path(), "--set",
                                       "device.limits.voltage_V=10", "--set", "device.limits.full_scale_V=2" });
    CHECK (refused.exitCode == 1);
    CHECK_THAT (refused.errors, Catch::Contains ("device: /limits/full_scale_V: is 2 V, too low for 40 mm/s: "));
}

TEST_CASE ("render writes what the contract names, and the numbers keep what is promised of the demonstrator",
           "[command line]")
{
    const TemporaryFolder folder;
    const auto run = runProgram ({ "render", "--out", folder.path() });
    REQUIRE (run.exitCode == 0);
    CHECK (run.errors.empty());

    for (const auto* name : { "voltages.wav", "probe.wav", "probe.csv", "design.json", "summary.json", "report.html" })
        CHECK (std::filesystem::file_size (folder.path() / name) > 0);

    const auto summary = nlohmann::json::parse (readContent (folder.path() / "summary.json"));

    for (const auto* key : { "device",
                             "sample_rate_Hz",
                             "ceramics",
                             "modes_controlled",
                             "modes_simulated",
                             "captured",
                             "residue",
                             "v_score",
                             "field_error",
                             "peak_ratio",
                             "v_score_truncated",
                             "field_error_truncated",
                             "peak_ratio_truncated",
                             "contrast",
                             "focus_time_ms",
                             "peak_velocity_mm_s",
                             "peak_voltage_V",
                             "voltage_limit_V",
                             "full_scale_V",
                             "limit",
                             "lower_bound_voltage_V",
                             "lower_bound_gap",
                             "allocation",
                             "probes",
                             "targets",
                             "peak_place_mm",
                             "side_lobe",
                             "side_lobe_wanted",
                             "elsewhere_velocity_mm_s",
                             "event_contrast",
                             "limit" })
        CHECK (summary.contains (key));

    // What the user asked for stands first, then what limits it, then the internal scores.
    const auto place = run.output.find ("  place "), limit = run.output.find (" limit the field"),
               score = run.output.find ("  v-score ");
    CHECK (place < limit);
    CHECK (limit < score);
    CHECK (score < run.output.size());

    for (const auto* key : { "status", "iterations", "gap", "time_ms" })
        CHECK (summary.at ("solver").contains (key));

    CHECK (summary.at ("v_score_truncated") >= 0.9999);
    CHECK (summary.at ("field_error_truncated") <= 0.005);
    CHECK (summary.at ("peak_voltage_V") <= summary.at ("voltage_limit_V"));
    CHECK (summary.at ("lower_bound_voltage_V") < summary.at ("peak_voltage_V"));
    CHECK (summary.at ("lower_bound_gap") <= 0.005);
    CHECK (summary.at ("solver").at ("gap") <= 1e-6);

    for (const auto& samples : summary.at ("limited_samples"))
        CHECK (samples == 0);
}

TEST_CASE ("Any key can be overridden with --set, --quiet says nothing, formats are as asked for", "[command line]")
{
    const TemporaryFolder folder;
    const auto run = runProgram ({ "render", "--quiet", "--no-report", "--format", "tfw", "--out", folder.path(),
                                   "--set", "focus.targets.0.x_mm=-24", "--set", "focus.name=moved", "--set",
                                   "device.quality_factor=80", "--probe", "-24", "--probe", "0,0" });
    REQUIRE (run.exitCode == 0);
    CHECK (run.output.empty());
    CHECK (run.errors.empty());
    CHECK_FALSE (std::filesystem::exists (folder.path() / "report.html"));
    CHECK (readContent (folder.path() / "voltages-08.tfw").substr (0, 10) == "TEKAFG3000");
    CHECK_FALSE (std::filesystem::exists (folder.path() / "voltages.wav"));
    const auto summary = nlohmann::json::parse (readContent (folder.path() / "summary.json"));
    CHECK (summary.at ("focus") == "moved");
    REQUIRE (summary.at ("probes").size() == 2);
    CHECK (summary.at ("probes").at (0).at ("x_mm") == -24);
    CHECK (summary.at ("probes").at (0).at ("velocity_at_focus_mm_s") == Approx (40).epsilon (0.1));
}

TEST_CASE ("devices lists what is embedded, and what it shows can be used as a file", "[command line]")
{
    const auto list = runProgram ({ "devices" });
    CHECK_THAT (list.output, Catch::Contains ("staple") && Catch::Contains ("beam"));
    CHECK_THAT (runProgram ({ "devices", "--materials" }).output,
                Catch::Contains ("NCE51") && Catch::Contains ("aluminium"));
    const auto focuses = runProgram ({ "devices", "--focuses" }).output;
    CHECK_THAT (focuses, Catch::Contains ("paper-bump25-p5"));
    CHECK (focuses.find ("demonstrator") == focuses.rfind ("demonstrator"));
    CHECK_THAT (focuses, Catch::Contains ("sinc of 25 mm at 24 mm, 40 mm/s, after 25 ms"));
    const TemporaryFolder folder;
    std::ofstream (folder.path() / "own.json") << runProgram ({ "devices", "--show", "beam" }).output;
    const auto modes = runProgram ({ "modes", folder.path() / "own.json", "--json" });
    REQUIRE (modes.exitCode == 0);
    CHECK (nlohmann::json::parse (modes.output).at ("kind") == "beam");
    CHECK (readFocus (nlohmann::json::parse (runProgram ({ "devices", "--show", "phone-thumb" }).output), "shown").name
           == "phone-thumb");
    CHECK (nlohmann::json::parse (runProgram ({ "devices", "--show", "three-fingers" }).output).at ("schema")
           == "antinode.waveforms/1");
}

TEST_CASE ("design and render agree on design.json", "[command line]")
{
    const TemporaryFolder first, second;
    REQUIRE (runProgram ({ "design", "--out", first.path() }).exitCode == 0);
    REQUIRE (runProgram ({ "render", "--out", second.path(), "--no-report" }).exitCode == 0);
    auto designed = nlohmann::json::parse (readContent (first.path() / "design.json"));
    auto rendered = nlohmann::json::parse (readContent (second.path() / "design.json"));
    CHECK (designed.at ("oscillations") == rendered.at ("oscillations"));
    CHECK (designed.at ("allocation") == rendered.at ("allocation"));
}

TEST_CASE ("A design that was written plays the same voltages again, without its focus or device", "[command line]")
{
    const TemporaryFolder folder;
    const auto first = folder.path() / "first", again = folder.path() / "again";
    const ProgramArguments common { "--no-report", "--quiet", "--rate", "48000", "--device", "beam" };
    auto render = ProgramArguments { "render", "--set", "focus.allocation.method=least_voltage", "--out", first };
    render.insert (render.end(), common.begin(), common.end());
    REQUIRE (runProgram (render).exitCode == 0);
    const auto design = (first / "design.json").string();
    const auto run = runProgram ({ "render", "--no-report", "--design", design, "--out", again });
    REQUIRE (run.exitCode == 0);
    CHECK (readContent (first / "voltages.wav") == readContent (again / "voltages.wav"));
    const auto summary = nlohmann::json::parse (readContent (again / "summary.json"));
    CHECK (summary.at ("device") == "beam");
    CHECK (summary.at ("sample_rate_Hz") == 48000);

    for (const auto& [option, value, sentence] :
         { std::tuple { "--rate", "96000", "has samples of 48000 Hz" },
           { "--device", "staple", "is 'beam'" },
           { "--set", "focus.targets.0.x_mm=3", "changes a focus that is designed already" } })
    {
        const auto refused = runProgram ({ "render", "--design", design, "--out", again, option, value });
        CHECK (refused.exitCode == 1);
        CHECK (linesIn (refused.errors) == 1);
        CHECK_THAT (refused.errors, Catch::Contains (sentence));
    }

    CHECK (runProgram ({ "render", "demonstrator", "--design", design }).exitCode == 2);
}

TEST_CASE ("A focus plays on the device that it names, and several must name one", "[command line]")
{
    const TemporaryFolder folder;
    const auto named = runProgram ({ "design", "--set", "focus.device=beam", "--out", folder.path() });
    REQUIRE (named.exitCode == 0);
    CHECK_THAT (named.output, Catch::Contains ("demonstrator on beam"));
    const auto given =
        runProgram ({ "design", "--device", "staple", "--set", "focus.device=beam", "--out", folder.path() });
    CHECK_THAT (given.output, Catch::Contains ("demonstrator on staple"));
    const auto mixed = runProgram ({ "render", "demonstrator", "phone-thumb", "--out", folder.path() });
    CHECK (mixed.exitCode == 1);
    CHECK (mixed.errors
           == "antinode: focus 'phone-thumb': is for the device 'phone', and focus 'demonstrator' for 'staple'; "
              "allowed: one device for all, or --device\n");
}

TEST_CASE ("A design is played on the device that it names, with keys of that one changed", "[command line]")
{
    const TemporaryFolder folder;
    const auto path = [&] (const std::string& name) { return (folder.path() / name).string(); };
    REQUIRE (runProgram ({ "design", "aluminium-centre", "--out", path ("design"), "--quiet" }).exitCode == 0);
    const auto run = runProgram ({ "render", "--design", path ("design/design.json"), "--set",
                                   "device.limits.voltage_V=149", "--out", path ("played"), "--no-report" });
    INFO (run.errors);
    CHECK (run.exitCode == 0);
}

TEST_CASE ("An empty name of a device is none that there is", "[command line]")
{
    CHECK (runProgram ({ "modes", "" }).exitCode == 1);
}
