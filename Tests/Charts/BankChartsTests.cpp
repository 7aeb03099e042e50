#include "Support/SineBeam.h"
#include "Support/SinePlate.h"

#include <antinode_focus/FocusPlaces.h>
#include <antinode_reports/BankCharts.h>

#include <catch2/catch.hpp>

#include <cmath>

using namespace antinode;

TEST_CASE ("A bank on a plate is a map in the order of its places, one on a line a curve above its bounds", "[charts]")
{
    const auto plate = test::SinePlate().model (8);
    BankVolts volts { bankPlaces (plate.surface, 128, 0.01), {}, {}, 100 };

    for (std::size_t i = 0; i < volts.places.size(); ++i)
    {
        volts.peaks.push_back (i == 5 ? 0 : 1e3 * volts.places[i].first + 1e5 * volts.places[i].second);
        volts.bounds.push_back (0);
    }

    // The place of middle C is the focus's own, off the grid.
    volts.places[60] = { 0.1, 0.05 };
    const auto map = std::get<HeatMap> (bankVoltsChart (plate, volts));
    CHECK (map.values.size() >= 128);
    CHECK (std::isnan (map.values (0, 5)));
    CHECK (map.values (0, 4) == volts.peaks[4]);
    CHECK (map.values (1, 0) == volts.peaks[static_cast<std::size_t> (map.values.cols())]);
    CHECK (map.values (2, 3) > map.values (1, 3));
    CHECK (map.values (2, 4) > map.values (2, 3));

    const auto beam = test::sineBeam (8, 4);
    // The one in the middle was moved to the focus's own place, to the left of all.
    const BankVolts line { { { -0.05, 0 }, { -0.06, 0 }, { 0.05, 0 } }, { 3, 0, 4 }, { 2.5, 0, 3.2 }, 100 };
    const auto chart = std::get<LineChart> (bankVoltsChart (beam, line));
    REQUIRE (chart.series.size() == 2);
    CHECK (chart.series[0].x[2] == Approx (50));
    CHECK (std::isnan (chart.series[0].y[0]));
    CHECK (chart.series[0].y[1] == 3);
    CHECK (chart.series[1].y[2] == 3.2);
    CHECK (chart.limits.empty());
}

TEST_CASE ("Methods stand side by side, with the limit where it is not far away", "[charts]")
{
    const auto chart = methodVoltsChart ({ { "exact", 8 }, { "paper", 0 }, { "least_voltage", 2.5 } }, 2, 10);
    REQUIRE (chart.categories.size() == 3);
    CHECK (chart.series[0].values[0] == 8);
    CHECK (std::isnan (chart.series[0].values[1]));
    REQUIRE (chart.limits.size() == 2);
    CHECK (chart.limits[0].value == 2);
    CHECK (chart.limits[1].value == 10);
    CHECK (methodVoltsChart ({ { "exact", 8 } }, 0, 100).limits.empty());
}
