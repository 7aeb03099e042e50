#include <antinode_reports/IdentificationReport.h>

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
    const auto chart = responseChart (measured, measured, 0, 0, 0);
    REQUIRE (chart.panels.size() == 2);
    CHECK (std::get<LineChart> (chart.panels[0]).series[0].y[0] == 2);
    CHECK (std::get<LineChart> (chart.panels[1]).series[1].y[4] == Approx (90));
}

TEST_CASE ("The phase of a response is that without the delay, with gaps where it leaps and where noise hides it",
           "[views]")
{
    constexpr double delay = 2e-3;
    auto measured = someResponses();
    measured.frequencies = Eigen::VectorXd::LinSpaced (400, 1, 400);
    measured.values = { Eigen::MatrixXcd (400, 1) };

    for (Eigen::Index n = 0; n < 400; ++n)
    {
        // From 100.4 to 259.6 degrees, then noise: signs that change from line to line.
        const auto line = static_cast<double> (n);
        const auto turned = std::polar (1.0, (100.4 + 0.8 * line) * std::numbers::pi / 180);
        measured.values[0](n, 0) = n < 200 ? turned * std::polar (1.0, -2 * std::numbers::pi * (line + 1) * delay)
                                           : std::complex<double> (n % 2 == 0 ? 1 : -1);
    }

    const auto chart = responseChart (measured, measured, 0, 0, delay);
    const auto& phase = std::get<LineChart> (chart.panels[1]).series[0];
    CHECK (phase.y[50] == Approx (140.4));
    CHECK (std::isnan (phase.y[100])); // The gap at 180 degrees.
    CHECK (phase.y[150] == Approx (-140.4));
    CHECK (phase.x.size() == 401);
    CHECK (phase.y.tail (180).array().isNaN().all());
}

TEST_CASE ("A stabilisation diagram shows all that was measured, also what no mode was fitted to", "[views]")
{
    IdentifiedModes modes;
    modes.minimumFrequency = 200;
    modes.maximumFrequency = 400;
    modes.stabilisation = { { 3, 250, 0.01, true } };
    const auto chart = stabilisationChart (modes, someResponses());
    CHECK (chart.series[0].x == someResponses().frequencies);
    REQUIRE (chart.xRange);
    CHECK (chart.xRange->minimum == 100);
    CHECK (chart.xRange->maximum == 500);
}
