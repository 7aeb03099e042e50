#include <antinode_reports/TradeoffReport.h>

#include <nlohmann/json.hpp>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
TradeoffPoint pointOf (AllocationMethod method, double volts, double seconds, bool isOnFront)
{
    TradeoffPoint point;
    point.method = method;
    point.envelopeFolds = 1;
    point.peakVoltage = volts;
    point.timeInMotion = seconds;
    point.isOnFront = isOnFront;
    return point;
}

Tradeoff threePoints()
{
    Tradeoff tradeoff;
    tradeoff.planned = 3;
    tradeoff.lowerBoundVoltage = 2;
    tradeoff.points = { pointOf (AllocationMethod::exact, 35, 0.001, true),
                        pointOf (AllocationMethod::paper, 20, 0.009, false),
                        pointOf (AllocationMethod::leastVoltage, 4, 0.008, true) };
    tradeoff.points[0].feltContrast = 12.5;
    return tradeoff;
}
} // namespace

TEST_CASE ("A trade-off says what more voltage buys along its front, with the felt contrast", "[tradeoff][reports]")
{
    const auto tradeoff = threePoints();
    const std::string sentence =
        "More voltage buys less motion before the focus: from 4 V and 8 ms (least_voltage) to 35 V "
        "and 1 ms (exact, felt contrast 12.5 dB).";
    CHECK (tradeoffToText (tradeoff).find (sentence) != std::string::npos);
    CHECK (tradeoffReport (tradeoff, "focus", "device").sections.front().paragraphs.back() == sentence);
}

TEST_CASE ("A front of one design says that more voltage buys nothing", "[tradeoff][reports]")
{
    auto tradeoff = threePoints();
    tradeoff.points[0].isOnFront = false;
    CHECK (tradeoffToText (tradeoff).find ("More voltage buys no less motion than 4 V and 8 ms (least_voltage).")
           != std::string::npos);
}

TEST_CASE ("Felt contrasts of a trade-off stand in its files where there are some", "[tradeoff][reports]")
{
    const auto tradeoff = threePoints();
    const auto json = tradeoffToJson (tradeoff, "focus", "device");
    CHECK (json["points"][0]["felt_contrast_dB"] == 12.5);
    CHECK_FALSE (json["points"][1].contains ("felt_contrast_dB"));
    const auto csv = tradeoffToCsv (tradeoff);
    CHECK (csv.find (",on_front,felt_contrast_dB\r\n") != std::string::npos);
    CHECK (csv.find (",1,12.5\r\n") != std::string::npos);
    CHECK (csv.find (",0,\r\n") != std::string::npos);
}
