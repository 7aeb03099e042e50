#include <antinode_charts/IdentificationCharts.h>

#include <catch2/catch.hpp>

#include <numbers>

using namespace antinode;

namespace
{
FrequencyResponses someResponses()
{
    FrequencyResponses responses;
    responses.frequencies = Eigen::VectorXd::LinSpaced (5, 100, 500);
    responses.points = Eigen::MatrixX2d::Zero (1, 2);
    responses.references = { { "C1", {} } };
    responses.values = { Eigen::MatrixXcd::Constant (5, 1, { 0, 2 }) };
    return responses;
}
} // namespace

TEST_CASE ("A stabilisation diagram tells poles of modes from others and names the modes", "[views]")
{
    IdentifiedModes modes;
    modes.angularFrequencies = Eigen::VectorXd::Constant (1, 2 * std::numbers::pi * 250);
    modes.minimumFrequency = 100;
    modes.maximumFrequency = 500;
    modes.stabilisation = { { 3, 250, 0.01, true }, { 4, 250.1, 0.01, true }, { 4, 420, 0.2, false } };
    const auto chart = stabilisationChart (modes, someResponses());
    REQUIRE (chart.series.size() == 3);
    CHECK (chart.series[2].x[0] == 250);
    CHECK (chart.series[2].y[0] == 3);
    CHECK (std::isnan (chart.series[2].y[1])); // A gap, so that no line joins the dots.
    CHECK (chart.series[1].x.size() == 2);
    REQUIRE (chart.markers.size() == 1);
    CHECK (chart.markers[0].position == Approx (250));
    CHECK (chart.markers[0].label == "1");
}

TEST_CASE ("A response is shown as magnitude and phase in degrees", "[views]")
{
    const auto measured = someResponses();
    const auto chart = responseChart (measured, measured, 0, 0);
    REQUIRE (chart.panels.size() == 2);
    CHECK (std::get<LineChart> (chart.panels[0]).series[0].y[0] == 2);
    CHECK (std::get<LineChart> (chart.panels[1]).series[1].y[4] == Approx (90));
}
