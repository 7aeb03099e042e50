#include <antinode_reports/TradeoffReport.h>

#include <nlohmann/json.hpp>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
FeltTradeoff threeWeights()
{
    FeltTradeoff tradeoff { {}, "my table", 4 };
    tradeoff.points = { { 0, 4, 0.001, 20, 19.0, 18.0, {} },
                        { 1, 5, 0.002, 20, 18.5, {}, {} },
                        { 3, 0, 0, 0, {}, {}, "cannot be met" } };
    return tradeoff;
}
} // namespace

TEST_CASE ("The felt contrast is that to bystanders, or to the largest elsewhere", "[reports][felt]")
{
    const auto json = feltTradeoffToJson (threeWeights(), "f", "d");
    CHECK (json["schema"] == "antinode.felt_tradeoff/1");
    CHECK (json["planned_points"] == 4);
    CHECK (json["points"][0]["contrast_dB"] == 2.0);
    CHECK (json["points"][1]["contrast_dB"] == 1.5);
    CHECK (json["points"][1]["bystanders_level_dB"].is_null());
    CHECK (json["points"][2]["failure"] == "cannot be met");
    CHECK_FALSE (json["points"][2].contains ("contrast_dB"));
}

TEST_CASE ("Tables of weights have what there is, and say what is missing", "[reports][felt]")
{
    const auto csv = feltTradeoffToCsv (threeWeights());
    CHECK_THAT (csv,
                Catch::Contains ("\r\n0,4,0.001,20,19,18,2\r\n") && Catch::Contains ("\r\n1,5,0.002,20,18.5,,1.5\r\n"));
    const auto text = feltTradeoffToText (threeWeights());
    CHECK_THAT (text, Catch::Contains ("cannot be met") && Catch::Contains ("3 of 4 designs"));
    const auto page = feltTradeoffReport (threeWeights(), "f", "d");
    CHECK (page.warnings.size() == 1);
    CHECK (page.sections.front().tables.front().rows.size() == 3);
}
