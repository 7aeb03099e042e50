#include "Support/ErrorText.h"

#include <antinode_sweep/SweepPlan.h>
#include <antinode_text/JsonText.h>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
std::string errorOf (const std::string& more)
{
    return errorText (
        [&]
        {
            readSweepPlan (
                parseJson (R"({"schema": "antinode.sweep/1", "focus": "demonstrator", "record": ["v_score"], )" + more
                               + "}",
                           "plan"),
                "plan");
        });
}
} // namespace

TEST_CASE ("A plan without anything wrong is read", "[sweep]")
{
    CHECK (errorOf (R"("seed": 3)").empty());
    CHECK (errorOf (R"("vary": [{"key": "focus.targets.0.x_mm", "from": 0, "to": 60, "count": 7}])").empty());
    const auto plan = readSweepPlan (parseJson (R"({"schema": "antinode.sweep/1", "focus": "demonstrator",
        "scheme": "random", "cases": 40, "points_mm": [[24, 0]], "evaluate": "closed_form",
        "vary": [{"keys": ["device.a", "device.b"], "uniform": {"minimum": 1, "maximum": 2}, "times": [1, -2]},
                 {"key": "focus.c", "values": ["exact", "paper", null, true, 2.5]}]})",
                                                "plan"),
                                     "plan");
    CHECK (plan.cases == 40);
    CHECK (plan.vary[0].times == std::vector<double> { 1, -2 });
    CHECK (plan.vary[1].rows.size() == 5);
    CHECK (plan.points.front().first == Approx (0.024));
}

TEST_CASE ("A plan that is wrong is refused with one sentence that says where and what is allowed", "[sweep]")
{
    const auto check = [] (const std::string& more, const std::string& part)
    {
        const auto error = errorOf (more);
        INFO (more);
        CHECK_THAT (error, Catch::StartsWith ("plan: "));
        CHECK_THAT (error, Catch::Contains (part));
        CHECK_THAT (error, Catch::Contains ("allowed"));
        CHECK (error.find ('\n') == std::string::npos);
    };
    const auto vary = [&] (const std::string& entry, const std::string& part)
    { check (R"("scheme": "random", "cases": 5, "vary": [{)" + entry + "}]", part); };
    check (R"("scheme": "random", "cases": 1e12)", "/cases: is");
    check (R"("scheme": "random", "cases": 0)", "/cases: is 0");
    check (R"("scheme": "sobol", "cases": 5)", "antinode.sampled of Python");
    check (R"("cases": 5)", "does not fit the scheme");
    check (R"("colour": 1)", "colour");
    check (R"("record": ["solver.time_ms"])", "record");
    vary (R"("key": "focus.x_mm", "from": 1, "to": 1, "count": 3)", "is empty");
    vary (R"("key": "focus.x_mm", "from": -1, "to": 1, "count": 3, "spacing": "logarithmic")", "goes through 0");
    vary (R"("key": "focus.x_mm", "values": [])", "entries");
    vary (R"("key": "focus.x_mm", "values": [[1]])", "is a list");
    vary (R"("key": "focus.x_mm", "normal": {"mean": 0, "standard_deviation": -1})", "standard_deviation: is -1");
    vary (R"("key": "focus.x_mm", "normal": {"mean": 0, "standard_deviation": 1, "minimum": 99})", "cut off");
    vary (R"("key": "focus.x_mm", "uniform": {"minimum": 2, "maximum": 1})", "is empty");
    vary (R"("key": "x_mm", "values": [1])", "is not a key");
    vary (R"("key": "deviation.colour_percent", "values": [1])", "is unknown");
    vary (R"("key": "device", "values": ["beam", 1])", "varies 'device' by numbers");
    vary (R"("key": "device", "uniform": {"minimum": 0, "maximum": 1})", "varies 'device' by numbers");
    check (R"("device": "beam", "vary": [{"key": "device", "values": ["beam"]}])", "gives 'device' twice");
    check (R"("set": {"device": "beam"})", "gives 'device'");
    vary (R"("key": "focus.device", "values": ["beam"])", "focus.device");
    vary (R"("keys": ["focus.a", "focus.a"], "values": [[1, 2]])", "twice");
    vary (R"("keys": ["focus.a", "focus.b"], "values": [[1, 2], [1]])", "entries");
    vary (R"("key": "focus.a")", "says not");
    vary (R"("key": "focus.a", "values": [1], "uniform": {"minimum": 0, "maximum": 1})", "several ways");
    check (R"("vary": [{"key": "focus.a", "uniform": {"minimum": 0, "maximum": 1}}])", "which a grid cannot");
    CHECK_THAT (
        errorText ([]
                   { readSweepPlan (parseJson ("{\"schema\": \"antinode.sweep/1\", \"focus\": \"a\"}", "p"), "p"); }),
        Catch::Contains ("records nothing"));
    CHECK_FALSE (errorOf (R"("seed": NaN)").empty());
    CHECK_FALSE (errorOf (R"("seed": 1e999)").empty());
}

TEST_CASE ("Grids that multiply beyond ten million cases are refused before they are made", "[sweep]")
{
    std::string entries;

    for (int i = 0; i < 12; ++i)
        entries += std::string (i > 0 ? "," : "") + R"({"key": "focus.k)" + std::to_string (i)
                   + R"(", "from": 0, "to": 1, "count": 10})";

    CHECK_THAT (errorOf ("\"vary\": [" + entries + "]"), Catch::Contains ("more cases than 10000000"));
}
