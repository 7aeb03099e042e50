#include "MeasurementReport.h"

#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_measurement/HammerResponses.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace antinode
{
namespace
{
constexpr int curveHeight = 360;
constexpr int rowHeight = 16, aroundRows = 110, lowestTable = 200, highestTable = 900;

/** The mean of the finite values, or NaN. */
double meanOfKnown (const Eigen::MatrixXd& values)
{
    const auto known = values.array().isFinite();
    return known.select (values.array(), 0.0).sum() / static_cast<double> (known.count());
}

std::string coherenceText (const SurfaceMeasurement& measurement)
{
    const auto mean = meanOfKnown (meanCoherence (measurement));
    return std::isfinite (mean) ? fixedText (mean, 5) : "unknown";
}

std::vector<ReportScore> measurementScores (const SurfaceMeasurement& measurement, const ExcitationSheet& sheet)
{
    const auto& responses = measurement.responses;
    std::vector<ReportScore> scores {
        { "points", std::to_string (responses.points.rows()),
          "Positions at which the velocity of the surface was measured." },
        { "ceramics", std::to_string (responses.references.size()), "Each played alone, one after the other." },
        { "lines", std::to_string (responses.frequencies.size()),
          "From " + inWords (responses.frequencies[0]) + " to "
              + inWords (responses.frequencies[responses.frequencies.size() - 1]) + " Hz." },
        { "coherence", coherenceText (measurement),
          "Mean fraction of the velocity's power that is due to the voltage; 1 is best." }
    };

    if (const auto latency = meanOfKnown (measurement.latencies); std::isfinite (latency))
        scores.push_back ({ "latency", fixedText (latency / sheet.excitation.settings.sampleRate * 1000, 4) + " ms",
                            "From outputs to inputs, removed from the responses." });

    return scores;
}

bool isOfHammer (const SurfaceMeasurement& measurement)
{
    return measurement.responses.drive == DriveQuantity::force;
}

ReportFigure responseFigure (const SurfaceMeasurement& measurement)
{
    return { isOfHammer (measurement)
                 ? "RMS velocity of all points per newton, one curve per hit point. Peaks are modes; a mode whose peak "
                   "is missing has a node at the hit point."
                 : "RMS velocity of all points per volt, one curve per ceramic. Peaks are modes; a ceramic without "
                   "peaks does not excite the surface.",
             {},
             responseChart (measurement),
             reportFigureWidth,
             curveHeight };
}

ReportSection responseSection (const SurfaceMeasurement& measurement)
{
    ReportSection section;
    section.heading = "Responses";
    section.figures.push_back (responseFigure (measurement));
    section.figures.push_back ({ "Mean coherence over the points. It is low where the surface hardly moves, between "
                                 "modes, and where there is noise or distortion.",
                                 {},
                                 coherenceChart (measurement),
                                 reportFigureWidth,
                                 curveHeight });
    return section;
}

ReportSection pointSection (const SurfaceMeasurement& measurement)
{
    const auto rows = static_cast<int> (measurement.responses.references.size());
    ReportSection section;
    section.heading = "Point by point";
    section.figures.push_back (
        { std::string ("Signal-to-noise ratio of each point and ")
              + (isOfHammer (measurement) ? "hit point" : "ceramic")
              + ", from the coherence. Points near held edges and nodal lines move less. A dark column is a point to "
                "measure again, a dark row is a "
              + (isOfHammer (measurement) ? "hit point" : "ceramic") + " to check.",
          {},
          signalToNoiseChart (measurement),
          reportFigureWidth,
          std::clamp (aroundRows + rowHeight * rows, lowestTable, highestTable) });
    return section;
}

std::string percentText (double share)
{
    return fixedText (100 * share, 3);
}

ReportTable distortionTable (const SurfaceMeasurement& measurement)
{
    ReportTable table { "Distortion relative to the linear response at the worst point, %",
                        { "ceramic", "even", "odd", "2nd", "3rd", "4th", "5th" },
                        {} };

    for (std::size_t i = 0; i < measurement.distortion.size(); ++i)
    {
        std::array<double, 6> maximum {};

        for (const auto& distortion : measurement.distortion[i])
        {
            maximum[0] = std::max (maximum[0], distortion.even);
            maximum[1] = std::max (maximum[1], distortion.odd);

            for (std::size_t m = 0; m < std::min<std::size_t> (4, distortion.harmonics.size()); ++m)
                maximum[2 + m] = std::max (maximum[2 + m], distortion.harmonics[m]);
        }

        std::vector<std::string> row { measurement.responses.references[i].name };
        std::transform (maximum.begin(), maximum.end(), std::back_inserter (row), percentText);
        table.rows.push_back (std::move (row));
    }

    return table;
}

std::vector<ReportScore> hammerScores (const HammerTest& test, const SurfaceMeasurement& measured)
{
    const auto& frequencies = measured.responses.frequencies;
    std::size_t all = 0;

    for (const auto& hits : test.hits)
        all += hits.size();

    return { { "hits", std::to_string (test.usedHits()) + " of " + std::to_string (all),
               "Those that are used; the table says why others are not." },
             { "lines", std::to_string (frequencies.size()),
               "From " + inWords (frequencies[0]) + " to " + inWords (frequencies[frequencies.size() - 1]) + " Hz." },
             { "coherence", coherenceText (measured),
               "Mean fraction of the velocity's power that is due to the force; 1 is best." } };
}

ReportSection forceSection (const std::vector<HammerRecording>& recordings, const HammerTest& test,
                            const Eigen::VectorXd& frequencies)
{
    const auto spacing = recordings.front().sampleRate / static_cast<double> (test.block);
    ReportSection section;
    section.heading = "Force";
    section.figures.push_back ({ "Spectrum of the force, effective value over the hits. It has to reach as far as the "
                                 "highest mode: a harder tip and a lighter hammer reach further.",
                                 {},
                                 forceChart (forceMagnitude (recordings, test), spacing, frequencies),
                                 reportFigureWidth,
                                 curveHeight });
    return section;
}

ReportTable hitTable (const std::vector<HammerRecording>& recordings, const HammerTest& test)
{
    ReportTable table { "Hits", { "recording", "hit", "time (s)", "peak (N)", "" }, {} };

    for (std::size_t i = 0; i < recordings.size(); ++i)
        for (std::size_t h = 0; h < test.hits[i].size(); ++h)
        {
            const auto& hit = test.hits[i][h];
            table.rows.push_back ({ recordings[i].source, std::to_string (h + 1),
                                    fixedText (static_cast<double> (hit.trigger) / recordings[i].sampleRate, 3),
                                    formatted ("%.4g", hit.peak),
                                    hit.fault.empty() ? "used" : "left out: " + hit.fault });
        }

    return table;
}

bool showsDistortion (const ExcitationSettings& settings)
{
    return settings.hasOddGrid || settings.signal == ExcitationSignal::sweep;
}
} // namespace

ReportPage measurementReport (const SurfaceMeasurement& measurement, const ExcitationSheet& sheet)
{
    ReportPage page;
    page.title = "Measurement of " + sheet.device;
    page.subtitle = "Velocity of the surface per volt at each ceramic";
    page.scores = measurementScores (measurement, sheet);
    page.warnings = collectWarnings (measurement);
    page.sections = { responseSection (measurement), pointSection (measurement) };

    if (showsDistortion (sheet.excitation.settings))
        page.sections.push_back (
            { "Linearity",
              { "Modes describe the linear response only. If distortion is large, measure at a lower level." },
              {},
              { distortionTable (measurement) } });

    return page;
}

ReportPage hammerReport (const std::vector<HammerRecording>& recordings, const HammerTest& test,
                         const SurfaceMeasurement& measured)
{
    ReportPage page;
    page.title = "Test with a hammer";
    page.subtitle = "Velocity of the surface per newton";
    page.scores = hammerScores (test, measured);
    page.sections = { forceSection (recordings, test, measured.responses.frequencies) };

    if (! measured.coherence.empty() && std::isfinite (meanOfKnown (meanCoherence (measured))))
    {
        page.sections.push_back (responseSection (measured));
        page.sections.push_back (pointSection (measured));
    }
    else
        page.sections.push_back ({ "Responses",
                                   { "One hit each: there is no coherence. Three to five hits of a point show noise." },
                                   { responseFigure (measured) },
                                   {} });

    page.sections.push_back ({ "Hits", {}, {}, { hitTable (recordings, test) } });
    return page;
}

void printMeasurement (const SurfaceMeasurement& measurement, const ExcitationSheet& sheet)
{
    const auto& responses = measurement.responses;
    std::printf ("%s: %td points, %zu ceramics, %td lines from %.6g to %.6g Hz\n", sheet.device.c_str(),
                 responses.points.rows(), responses.references.size(), responses.frequencies.size(),
                 responses.frequencies[0], responses.frequencies[responses.frequencies.size() - 1]);
    std::printf ("  coherence      %s (mean)\n", coherenceText (measurement).c_str());

    if (const auto latency = meanOfKnown (measurement.latencies); std::isfinite (latency))
        std::printf ("  latency        %.3f samples, %.4f ms\n", latency,
                     latency / sheet.excitation.settings.sampleRate * 1000);

    for (const auto& warning : collectWarnings (measurement))
        std::printf ("  warning: %s\n", warning.c_str());
}

namespace
{
constexpr std::size_t maximumCurves = 6;

/** Rows' means of what is known. */
Eigen::VectorXd meansOfKnown (const Eigen::ArrayXXd& values)
{
    const auto known = values.isFinite();
    const Eigen::ArrayXd sums = known.select (values, 0.0).rowwise().sum();
    return sums / known.cast<double>().rowwise().sum();
}

Eigen::VectorXd effectiveVelocity (const SurfaceMeasurement& measurement, std::size_t ceramic)
{
    return meansOfKnown (measurement.responses.values[ceramic].cwiseAbs2().array()).cwiseSqrt() * milli;
}

/** The ceramics that are shown, the strongest first; in the order of the ceramics where all are. */
std::vector<std::size_t> shownCeramics (const SurfaceMeasurement& measurement)
{
    std::vector<std::size_t> ceramics (measurement.responses.values.size());
    std::vector<double> strengths (ceramics.size());
    std::iota (ceramics.begin(), ceramics.end(), 0);
    std::transform (ceramics.begin(), ceramics.end(), strengths.begin(),
                    [&] (auto ceramic) { return effectiveVelocity (measurement, ceramic).norm(); });

    if (ceramics.size() > maximumCurves)
        std::stable_sort (ceramics.begin(), ceramics.end(),
                          [&] (auto one, auto other) { return strengths[one] > strengths[other]; });

    ceramics.resize (std::min (maximumCurves, ceramics.size()));
    return ceramics;
}

template <typename Values>
LineChart curves (const SurfaceMeasurement& measurement, const Values& values)
{
    LineChart chart;
    chart.xLabel = "frequency (Hz)";
    chart.logarithmicX = true;

    for (const auto ceramic : shownCeramics (measurement))
    {
        Series series;
        series.name = measurement.responses.references[ceramic].name;
        series.x = measurement.responses.frequencies;
        series.y = values (ceramic);
        chart.series.push_back (std::move (series));
    }

    return chart;
}
} // namespace

LineChart responseChart (const SurfaceMeasurement& measurement)
{
    auto chart = curves (measurement, [&] (auto ceramic) { return effectiveVelocity (measurement, ceramic); });
    chart.yLabel =
        measurement.responses.drive == DriveQuantity::force ? "RMS velocity (mm/s per N)" : "RMS velocity (mm/s per V)";
    chart.logarithmicY = true;
    return chart;
}

LineChart coherenceChart (const SurfaceMeasurement& measurement)
{
    auto chart =
        curves (measurement, [&] (auto ceramic) { return meansOfKnown (measurement.coherence[ceramic].array()); });
    chart.yLabel = "coherence";
    chart.yRange = AxisRange { 0, 1 };
    return chart;
}

HeatMap signalToNoiseChart (const SurfaceMeasurement& measurement)
{
    HeatMap chart;
    const auto coherence = meanCoherence (measurement);
    chart.xLabel = "point";
    chart.yLabel = measurement.responses.drive == DriveQuantity::force ? "hit point" : "ceramic";
    chart.valueLabel = "signal to noise (dB)";
    constexpr double best = 1 - 1e-12;
    const Eigen::ArrayXXd known = coherence.transpose().array().min (best).max (1e-12);
    chart.values = coherence.transpose().array().isFinite().select (10 * (known / (1 - known)).log10(),
                                                                    coherence.transpose().array());

    constexpr double usual = 40; // dB: less of a range would make a picture of differences that do not matter
    const auto largest = chart.values.array().isFinite().select (chart.values.array(), 0.0).maxCoeff();
    chart.valueRange = AxisRange { 0, std::max (usual, largest) };

    for (Eigen::Index p = 0; p < coherence.rows(); ++p)
        chart.columnNames.push_back (std::to_string (p + 1));

    for (const auto& reference : measurement.responses.references)
        chart.rowNames.push_back (reference.name);

    return chart;
}

LineChart forceChart (const Eigen::VectorXd& magnitude, double spacing, const Eigen::VectorXd& usedFrequencies)
{
    constexpr double lowest = 1e-4;          // of the largest line
    const auto lines = magnitude.size() - 1; // Without the first: a logarithmic axis has no 0.
    LineChart chart;
    chart.xLabel = "frequency (Hz)";
    chart.yLabel = "force (dB of the largest)";
    chart.logarithmicX = true;
    chart.series = { { {},
                       spacing * Eigen::VectorXd::LinSpaced (lines, 1, static_cast<double> (lines)),
                       20 * (magnitude.tail (lines) / magnitude.maxCoeff()).array().max (lowest).log10() } };
    chart.yRange = AxisRange { 20 * std::log10 (lowest), 0 };
    chart.spans = { { usedFrequencies[0], usedFrequencies[usedFrequencies.size() - 1], "used" } };
    return chart;
}
} // namespace antinode
