#include <antinode_sweep/SweepCases.h>
#include <antinode_text/JsonText.h>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
SweepPlan planOf (const std::string& more)
{
    return readSweepPlan (
        parseJson (R"({"schema": "antinode.sweep/1", "focus": "demonstrator", "record": ["v_score"], )" + more + "}",
                   "plan"),
        "plan");
}

constexpr auto twoUniform = R"("vary": [{"key": "focus.a", "uniform": {"minimum": 0, "maximum": 1}},
                                        {"key": "focus.b", "uniform": {"minimum": 0, "maximum": 1}}])";
} // namespace

TEST_CASE ("A grid has all combinations, the first keys varying slowest, coupled keys together", "[sweep]")
{
    const auto plan = planOf (R"("vary": [{"keys": ["focus.a", "focus.b"], "values": [[1, "x"], [2, "y"]]},
                                          {"key": "focus.c", "from": 10, "to": 30, "count": 3}])");
    REQUIRE (plan.cases == 6);
    std::string all;

    for (std::uint64_t i = 0; i < plan.cases; ++i)
        all += nlohmann::json (caseValues (plan, i)).dump();

    CHECK (all == R"([1,"x",10.0][1,"x",20.0][1,"x",30.0][2,"y",10.0][2,"y",20.0][2,"y",30.0])");
    CHECK (sweptKeys (plan) == std::vector<std::string> { "focus.a", "focus.b", "focus.c" });
}

TEST_CASE ("Ranges end where they are told, with even ratios where they are logarithmic", "[sweep]")
{
    const auto plan =
        planOf (R"("vary": [{"key": "focus.a", "from": 0.1, "to": 100, "count": 4, "spacing": "logarithmic"}])");
    CHECK (caseValues (plan, 0)[0] == 0.1);
    CHECK (caseValues (plan, 1)[0].get<double>() == Approx (1).epsilon (1e-14));
    CHECK (caseValues (plan, 3)[0] == 100.0);
}

TEST_CASE ("Drawn keys that are coupled follow one number", "[sweep]")
{
    const auto plan = planOf (R"("scheme": "random", "cases": 50, "vary": [{"keys": ["focus.a", "device.b"],
        "normal": {"mean": 3, "standard_deviation": 1}, "times": [1, -2], "plus": [0, 7]}])");

    for (std::uint64_t i = 0; i < plan.cases; ++i)
    {
        const auto values = caseValues (plan, i);
        CHECK (values[1].get<double>() == Approx (7 - 2 * values[0].get<double>()));
    }
}

TEST_CASE ("A case depends on the seed and its number, and on nothing else", "[sweep]")
{
    const auto five = planOf (std::string (R"("scheme": "random", "cases": 5, )") + twoUniform);
    const auto many = planOf (std::string (R"("scheme": "random", "cases": 5000000, )") + twoUniform);
    const auto other = planOf (std::string (R"("scheme": "random", "seed": 2, "cases": 5, )") + twoUniform);

    for (std::uint64_t i = 0; i < 5; ++i)
    {
        CHECK (caseValues (five, i) == caseValues (many, i));
        CHECK (caseValues (five, i) != caseValues (other, i));
    }
}
