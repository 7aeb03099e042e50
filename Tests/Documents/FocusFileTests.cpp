#include "Support/ErrorText.h"
#include "Support/GoodFiles.h"

#include <antinode_documents/FocusFile.h>
#include <antinode_text/JsonText.h>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
nlohmann::json goodFocus (std::string_view name = "focus")
{
    for (const auto& file : goodFiles())
        if (file.name == name)
            return parseJson (file.text, "focus");

    throw InputError ("focus", "is not among the good files");
}

FocusDescription focusWith (std::string_view assignment)
{
    auto document = goodFocus();
    applyAssignment (document, assignment);
    return readFocus (document, "my.json");
}

std::string errorWith (std::string_view assignment)
{
    return errorText ([&] { focusWith (assignment); });
}
} // namespace

TEST_CASE ("A focus is read with all its keys, in SI units", "[files]")
{
    const auto focus = readFocus (goodFocus(), "my.json");
    CHECK (focus.name == "two places");
    REQUIRE (focus.targets.size() == 2);
    CHECK (focus.targets[0].shape == TargetShape::sinc);
    CHECK (focus.targets[0].x == -0.024);
    CHECK (focus.targets[0].y == 0.003);
    CHECK (focus.targets[0].width == 0.025);
    CHECK (focus.targets[0].peakVelocity == 0.04);
    CHECK (focus.targets[0].phase == -1);
    CHECK (focus.targets[0].profile == TargetProfile::separable);
    CHECK (focus.targets[0].widthY == 0.015);
    CHECK (focus.targets[1].profile == TargetProfile::radial);
    CHECK_FALSE (focus.targets[1].widthY.has_value());
    CHECK (focus.targets[1].shape == TargetShape::gaussian);
    CHECK (focus.targets[1].phase == 1);
    CHECK (focus.focusTime == 0.025);
    CHECK (focus.modes.count == 6);
    CHECK (focus.modes.order == ModeOrder::frequency);
    CHECK (focus.transients.drive == DriveKind::paper);
    CHECK (focus.transients.growth == std::vector<double> { 10, 4 });
    CHECK (focus.transients.cycles == std::vector<int> { 3, 5 });
    CHECK (focus.transients.maximumDuration == 0.02);
    CHECK (focus.transients.brake == 20.0);
    CHECK (focus.transients.brakeDuration == 0.03);
    CHECK_FALSE (focus.targets[0].time.has_value());
    CHECK (focusWith ("targets.0.time_ms=35").targets[0].time == 0.035);
    CHECK (errorWith ("transients.brake_duration_ms=2000").find ("/transients/brake_duration_ms: is 2000")
           != std::string::npos);
    CHECK (focus.allocation.method == AllocationMethod::paper);
    CHECK (focus.allocation.voltageLimit == 50.0);
    CHECK (focus.allocation.guardModes == 10);
    CHECK (focus.allocation.guardWeight == 30);
    CHECK (focus.allocation.window == 0.005);
    CHECK (focus.edgeWindow == 0.1);
    CHECK (focus.probes == std::vector<std::pair<double, double>> { { 0, 0 }, { 0.024, 0.001 } });
}

TEST_CASE ("What a focus leaves out is left to choice", "[files]")
{
    const auto focus = readFocus (goodFocus ("minimal focus"), "my.json");
    CHECK (focus.targets[0].shape == TargetShape::bump);
    CHECK_FALSE (focus.modes.count.has_value());
    CHECK_FALSE (focus.modes.captured.has_value());
    CHECK (focus.transients.drive == DriveKind::offsetFree);
    CHECK (focus.transients.growth.empty());
    CHECK (focus.transients.cycles.empty());
    CHECK (focus.allocation.method == AllocationMethod::exact);
    CHECK_FALSE (focus.allocation.guardModes.has_value());
    CHECK (focus.allocation.guardWeight == 100);
    CHECK (focus.probes.empty());
}

TEST_CASE ("What a focus is robust against is read in per cent, what it leaves out is as usual", "[files]")
{
    const auto robust = readFocus (goodFocus ("robust focus"), "my.json").allocation.robust;
    REQUIRE (robust.has_value());
    CHECK (robust->spread.frequency == 0.003);
    CHECK (robust->spread.damping == 0.2);
    CHECK (robust->spread.participation == 0.1);
    CHECK (robust->spread.drift == 0.002);
    CHECK (robust->weight == 500);

    auto document = goodFocus ("robust focus");
    document["allocation"]["robust"] = nlohmann::json::object();
    const auto usual = readFocus (document, "my.json").allocation.robust;
    REQUIRE (usual.has_value());
    CHECK (usual->spread.frequency == usualSpread.frequency);
    CHECK (usual->spread.damping == usualSpread.damping);
    CHECK (usual->spread.participation == usualSpread.participation);
    CHECK (usual->spread.drift == 0);
    CHECK_FALSE (readFocus (goodFocus(), "my.json").allocation.robust.has_value());
}

TEST_CASE ("Growth and cycles are one number for all modes, or one a mode", "[files]")
{
    CHECK (focusWith ("transients.growth=4").transients.growth == std::vector<double> { 4 });
    CHECK (focusWith ("transients.cycles=25").transients.cycles == std::vector<int> { 25 });
    CHECK (focusWith ("allocation.guard_modes=all").allocation.guardModes == std::nullopt);
    CHECK (focusWith ("allocation.guard_modes=0").allocation.guardModes == 0);
    CHECK (focusWith ("modes={\"captured\": 0.99}").modes.captured == 0.99);
    CHECK (focusWith ("modes={\"maximum_frequency_Hz\": 30000}").modes.maximumFrequency == 30000.0);
}

TEST_CASE ("Errors for typical mistakes in focuses give their position and what is allowed", "[files]")
{
    CHECK (errorWith ("focus_time_ms=-25") == "my.json: /focus_time_ms: is -25; allowed: 0.001 to 60000");
    CHECK (errorWith ("targets.0.shape=sync")
           == "my.json: /targets/0/shape: is the text 'sync' (did you mean 'sinc'?); allowed: one of 'sinc', 'bump', "
              "'gaussian'");
    CHECK (errorWith ("targets=[]") == "my.json: /targets: has 0 entries; allowed: a list of 1 to 64");
    CHECK (errorWith ("targets.0.phase=0.5") == "my.json: /targets/0/phase: is 0.5; allowed: 1 or -1");
    CHECK (errorWith ("targets.1={\"shape\": \"sinc\", \"x_mm\": 0, \"peak_velocity_mm_s\": 40}")
           == "my.json: /targets/1/width_mm: is missing");
    CHECK (errorWith ("targets.0.peak_velocity=40")
           == "my.json: /targets/0/peak_velocity: is an unknown key (did you mean 'peak_velocity_mm_s'?); allowed: "
              "'shape', 'profile', 'x_mm', 'y_mm', 'width_mm', 'width_y_mm', 'peak_velocity_mm_s', 'peak_level_dB_SL', "
              "'phase', 'time_ms'");
    CHECK (errorWith ("targets.0.profile=radial")
           == "my.json: /targets/0/width_y_mm: is given for a radial target, which has one width; allowed only with "
              "\"profile\": \"separable\"");
    CHECK (errorWith ("targets.1.width_y_mm=20").find ("my.json: /targets/1/width_y_mm: is given for a radial") == 0);
    CHECK (errorWith ("targets.0.profile=circular").find ("allowed: one of 'radial', 'separable'")
           != std::string::npos);
    CHECK (errorWith ("modes.captured=0.9")
           == "my.json: /modes: has more than one of 'count', 'captured' and 'maximum_frequency_Hz'; allowed: at "
              "most one");
    CHECK (errorWith ("modes={\"choose\": \"energy\"}")
           == "my.json: /modes/choose: is given without 'count'; allowed only together");
    CHECK (errorWith ("modes={\"captured\": 0}") == "my.json: /modes/captured: is 0; allowed: above 0 to 1");
    CHECK (errorWith ("transients.brake=1") == "my.json: /transients/brake: is 1; allowed: above 1 to 1000");
    CHECK (errorWith ("transients.cycles=2.5")
           == "my.json: /transients/cycles: is 2.5; allowed: a whole number from 0 to 1000000");
    CHECK (errorWith ("allocation.method=least_volt")
           == "my.json: /allocation/method: is the text 'least_volt' (did you mean 'least_voltage'?); allowed: one of "
              "'exact', 'least_voltage', 'paper'");
    CHECK (errorWith ("allocation.guard_modes=some")
           == "my.json: /allocation/guard_modes: is the text 'some'; allowed: 'all'");
    CHECK (
        errorWith ("allocation.robust={}")
        == "my.json: /allocation/robust: is given with a method other than exact or least_voltage, or up to the limit; "
           "allowed only with exact, and with least_voltage near its bound");
    CHECK (errorWith ("allocation={\"method\": \"paper\", \"displacement\": \"zero\"}")
           == "my.json: /allocation/displacement: is 'zero' with a method other than exact; allowed only with exact");
    CHECK (errorWith ("allocation={\"displacement\": \"zero\", \"robust\": {}}")
           == "my.json: /allocation/displacement: is 'zero' together with 'robust'; allowed: one of the two");
    CHECK (errorWith ("allocation={\"robust\": {\"frequency_percent\": 11}}")
           == "my.json: /allocation/robust/frequency_percent: is 11; allowed: 0 to 10");
    CHECK (errorWith ("edge_window={\"tukey\": 1.5}") == "my.json: /edge_window/tukey: is 1.5; allowed: 0 to 1");
    CHECK (errorWith ("probes_mm.0=[1]") == "my.json: /probes_mm/0: has 1 entries; allowed: a list of 2");
    CHECK (errorWith ("plate=staple").find ("my.json: /plate: is an unknown key; allowed: 'schema', 'name', 'device', ")
           == 0);
}

TEST_CASE ("Fingers of a focus are read and written, and what is not given is that of their kind", "[files][fingers]")
{
    auto document = goodFocus();
    document["fingers"] = nlohmann::json::parse (R"([ { "x_mm": 12, "kind": "firm" },
        { "x_mm": -30, "y_mm": 2, "radius_mm": 3, "mass_g": 0.07, "damping_N_s_per_m": 2.5,
          "stiffness_N_per_mm": 0.45, "known": false } ])");
    const auto focus = readFocus (document, "my.json");

    for (const auto& fingers : { focus.fingers, readFocus (focusToJson (focus), "my.json").fingers })
    {
        REQUIRE (fingers.size() == 2);
        CHECK (fingers[0].x == 0.012);
        CHECK (fingers[0].name == "firm");
        CHECK (fingers[0].damping == 5);
        CHECK (fingers[0].isKnown);
        CHECK (fingers[1].y == 0.002);
        CHECK (fingers[1].radius == 0.003);
        CHECK (fingers[1].mass == 0.07 / 1000);
        CHECK (fingers[1].damping == 2.5);
        CHECK (fingers[1].stiffness == 450);
        CHECK_FALSE (fingers[1].isKnown);
    }

    CHECK (errorWith ("fingers=[{\"x_mm\": 3, \"kind\": \"thumb\"}]")
           == "my.json: /fingers/0/kind: is the text 'thumb'; allowed: one of 'light', 'medium', 'firm'");
    CHECK (errorWith ("fingers=[{\"x_mm\": 3, \"mass_g\": -1}]")
           == "my.json: /fingers/0/mass_g: is -1; allowed: 0 to 10");
}

TEST_CASE ("Where less is to be felt is read and written, with samples up to the limit without a brake only",
           "[files][felt]")
{
    const std::string focus = R"({ "schema": "antinode.focus/1", "focus_time_ms": 25,
        "targets": [{ "shape": "sinc", "x_mm": 1, "width_mm": 25, "peak_velocity_mm_s": 40 }],
        "allocation": { "method": "least_voltage", "times_bound": "limit" }, "felt": { "at": [[-24, 3], [7, 0]], "weight": 4 } })";
    const auto read = [&] (std::string_view assignment)
    {
        auto document = parseJson (focus, "focus");

        if (! assignment.empty())
            applyAssignment (document, assignment);

        return readFocus (document, "my.json");
    };
    const auto felt = read ("").felt.value();
    CHECK (felt.at == FeltAt::places);
    CHECK (felt.places == std::vector<std::pair<double, double>> { { -0.024, 0.003 }, { 0.007, 0 } });
    CHECK (felt.weight == 4);
    CHECK (felt.after == 0.02);
    const auto written = focusToJson (read (""))["felt"];
    CHECK (written["at"].dump() == "[[-24.0,3.0],[7.0,0.0]]");
    CHECK (written["weight"] == 4);
    CHECK (written["after_ms"] == 20);
    CHECK (read ("felt.at=everywhere").felt->at == FeltAt::everywhere);
    CHECK (focusToJson (read ("felt.at=fingers"))["felt"]["at"] == "fingers");
    CHECK_THAT (errorText ([&] { read ("felt.at=near"); }),
                Catch::Contains ("/felt/at") && Catch::Contains ("everywhere"));
    CHECK_THAT (errorText ([&] { read ("felt.weight=-1"); }), Catch::Contains ("/felt/weight"));
    CHECK_THAT (errorText ([&] { read ("felt.after_ms=1000"); }), Catch::Contains ("/felt/after_ms"));
    CHECK (read ("allocation={\"method\": \"free_waveform\"}").felt); // As it was written before.
    CHECK_THAT (errorText ([&] { read ("allocation={\"method\": \"exact\"}"); }),
                Catch::Contains ("/felt: is given without samples up to the limit"));
    CHECK_THAT (errorText ([&] { read ("allocation.times_bound=1.3"); }),
                Catch::Contains ("\"times_bound\": \"limit\""));
    CHECK_THAT (errorText ([&] { read ("transients={\"brake\": 20}"); }), Catch::Contains ("brake"));
}

TEST_CASE ("Methods that are no longer offered are read as what is nearest, with a sentence that says what to write",
           "[files]")
{
    const auto document = goodFocus ("minimal focus");
    const auto read = [&] (const std::string& allocation)
    {
        auto changed = document;
        changed["allocation"] = nlohmann::json::parse (allocation);
        return readFocus (changed, "my.json").allocation;
    };
    const auto [word, now, sentence] = GENERATE (table<std::string, std::string, std::string> (
        { { "one_to_one", R"({ "method": "paper" })",
            "'paper' is used, which shares each mode among all ceramics and keeps the voltage limit; write 'paper'." },
          { "minimum_norm", R"({ "method": "paper" })",
            "'paper' is used, which gives the same voltages where they keep the limit; write 'paper'." },
          { "minimum_peak", R"({ "method": "exact" })",
            "'exact' is used, which gives the same velocities at the focus, with more voltage within the limit; write "
            "'exact'." },
          { "dictionary", R"({ "method": "least_voltage" })",
            "'least_voltage' is used, which gives the same velocities at the focus, at about the same voltage; write "
            "'least_voltage'." },
          { "free_waveform", R"({ "method": "least_voltage", "times_bound": "limit" })",
            "'least_voltage' with 'times_bound' at 'limit' is used, which gives the same voltages; write "
            "'least_voltage' with 'times_bound' at 'limit'." } }));
    CAPTURE (word);
    const auto choice = read (R"({ "method": ")" + word + "\" }");
    CHECK (retirementInWords (choice) == "The allocation method '" + word + "' is no longer offered: " + sentence);

    // Written again it is what would be written today, and has nothing to say.
    auto focus = readFocus (document, "my.json");
    focus.allocation = choice;
    const auto written = focusToJson (focus)["allocation"].dump();
    focus.allocation = read (now);
    CHECK (written == focusToJson (focus)["allocation"].dump());
    CHECK (retirementInWords (read (written)).empty());
}

TEST_CASE ("Where displacements are to be 0, exact rows stand for a method that is no longer offered", "[files]")
{
    const auto focus = focusWith (R"(allocation={ "method": "dictionary", "displacement": "zero" })");
    CHECK (focus.allocation.method == AllocationMethod::exact);
    CHECK_THAT (retirementInWords (focus.allocation), Catch::EndsWith ("write 'exact'."));
}

TEST_CASE ("How near least voltage goes to its bound is a multiple, or the limit", "[files]")
{
    const auto with = [] (const std::string& times)
    { return R"(allocation={ "method": "least_voltage", "times_bound": )" + times + " }"; };
    CHECK (focusWith (with ("1.4")).allocation.timesBound == 1.4);
    CHECK (focusWith (with ("\"limit\"")).allocation.timesBound == upToLimits);
    CHECK (errorWith (with ("\"limits\""))
           == "my.json: /allocation/times_bound: is the text 'limits' (did you mean 'limit'?); allowed: 'limit'");
    CHECK (errorWith (with ("1")) == "my.json: /allocation/times_bound: is 1; allowed: 1.02 to 100");
    CHECK (errorWith (R"(allocation={ "method": "free_waveform", "times_bound": 2 })")
           == "my.json: /allocation/times_bound: is given with a method other than least_voltage; allowed only with "
              "least_voltage");
    CHECK (errorWith (R"(allocation={ "method": "least_voltage", "times_bound": "limit", "robust": {} })")
               .find ("/allocation/robust: is given")
           != std::string::npos);
}

TEST_CASE ("A focus that is to pass undisplaced says so, and still does when it is written", "[files]")
{
    auto document = goodFocus ("minimal focus");
    CHECK_FALSE (readFocus (document, "my.json").allocation.isUndisplaced);
    document["allocation"] = { { "displacement", "zero" } };
    const auto focus = readFocus (document, "my.json");
    CHECK (focus.allocation.isUndisplaced);
    CHECK (readFocus (focusToJson (focus), "my.json").allocation.isUndisplaced);
}

TEST_CASE ("A focus written and read again says the same", "[files]")
{
    for (const auto* const name : { "focus", "minimal focus", "robust focus" })
    {
        const auto once = focusToJson (readFocus (goodFocus (name), "my.json")).dump();
        const auto twice = focusToJson (readFocus (parseJson (once, "my.json"), "my.json")).dump();
        CHECK (once == twice);
    }

    const auto original = goodFocus();
    const nlohmann::json written = focusToJson (readFocus (original, "my.json"));
    CHECK (written["targets"][0] == original["targets"][0]);

    for (const auto& [key, value] : original.items())
        if (key != "targets")
            CHECK (written[key] == value);
}
