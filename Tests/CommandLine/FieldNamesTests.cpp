#include "Support/RunProgram.h"

#include <antinode_tasks/Field.h>

#include <catch2/catch.hpp>

using namespace antinode;

TEST_CASE ("Fields of lower modules become keys and options", "[command line]")
{
    CHECK (withKeysAndOptions ("focus: target 12 y: is 200 mm") == "focus: /targets/11/y_mm: is 200 mm");
    CHECK (withKeysAndOptions ("focus: targets: have 2 different times") == "focus: /targets: have 2 different times");
    CHECK (withKeysAndOptions ("sample rate: is 8 Hz, or only lower modes (focus: maximum frequency)")
           == "sample rate: is 8 Hz, or only lower modes (focus: /modes/maximum_frequency_Hz)");
    CHECK (withKeysAndOptions ("placement: step: is 0") == "--step-mm: is 0");
    CHECK (withKeysAndOptions ("measurement: point positions: lack 'P1'") == "--points: lack 'P1'");
    CHECK (withKeysAndOptions ("focus: target x") == "focus: target x");
    CHECK (withKeysAndOptions ("focus: target 3") == "focus: target 3");
    CHECK (withKeysAndOptions ("my.json: /targets/0/x_mm: is 1") == "my.json: /targets/0/x_mm: is 1");
    CHECK (withKeysAndOptions ("").empty());
}

TEST_CASE ("Errors of a focus name the key that the user wrote", "[command line]")
{
    const std::vector<std::pair<std::string, std::string>> cases {
        { "focus.targets.0.x_mm=200", "focus: /targets/0/x_mm: is 200 mm, which is outside the surface; allowed: " },
        { "focus.focus_time_ms=0.1", "focus: /focus_time_ms: leaves 0.1 ms to drive mode " },
        { "focus.modes={\"count\": 4000}", "focus: /modes/count: is 4000; allowed: 1 to " },
        { "focus.modes={\"maximum_frequency_Hz\": 1}",
          "focus: /modes/maximum_frequency_Hz: is 1 Hz; allowed: at least " },
        { "focus.transients.growth=[1, 2]", "focus: /transients/growth: has 2 values, but " },
        { "focus.transients.cycles=100000", "focus: /transients/cycles: is 100000 for mode " },
        { "focus.transients.brake_duration_ms=1.5", "focus: /transients/brake_duration_ms: is 1.5 ms, too short" },
        { "focus.allocation.voltage_limit_V=0.001", "focus: /allocation/voltage_limit_V: is 0.001 V, too low for " }
    };

    for (const auto& [assignment, error] : cases)
    {
        const auto run = test::runProgram ({ "design", "--set", assignment });
        CAPTURE (assignment, run.errors);
        CHECK (run.exitCode == 1);
        CHECK_THAT (run.errors, Catch::StartsWith ("antinode: " + error));
    }
}
