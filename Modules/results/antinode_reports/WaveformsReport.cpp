#include "WaveformsReport.h"

#include "FieldFigures.h"
#include "FocusReport.h"

#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_numerics/Fourier.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace antinode
{
namespace
{
constexpr double shownBeyondBand = 2; // times the band's upper frequency in spectra
constexpr double shownDecibels = 100; // below the strongest line
constexpr double leastLine = 1e-12;   // of the strongest: what is drawn lowest
constexpr double shownRinging = 0.1;  // s of what is shown after the last track
constexpr double shownPart = 0.12;    // s, of a long event
constexpr double longEvent = 0.4;     // s

/** The wanted motion of a finger beside what was played, which may have ended too early. */
Eigen::VectorXd wantedOf (const PerformedWaveforms& performed, Eigen::Index finger)
{
    Eigen::VectorXd wanted = Eigen::VectorXd::Zero (performed.played.displacements.cols());
    const auto count =
        std::min<Eigen::Index> (performed.design.wanted.rows(), wanted.size() - performed.played.trigger);
    wanted.segment (performed.played.trigger, count) = performed.design.wanted.col (finger).head (count);
    return wanted;
}

/** Samples that a chart shows. */
struct ShownSamples
{
    Eigen::Index first = 0, count = 0;
};

/** From the first voltage to the last one, or until the tracks have long ended: voltages from elsewhere may go on. */
ShownSamples wholeEvent (const PerformedWaveforms& performed)
{
    const auto ringing = std::llround (shownRinging * performed.played.sampleRate);
    return { 0, std::min<Eigen::Index> (performed.design.voltages.values.cols(),
                                        performed.played.trigger + performed.design.wanted.rows() + ringing) };
}

/** What can be seen of waveforms where the whole event is long: some of it from shortly before the largest motion on.
 */
ShownSamples loudestPart (const PerformedWaveforms& performed)
{
    const auto whole = wholeEvent (performed);
    const auto count = std::min<Eigen::Index> (whole.count, std::llround (shownPart * performed.played.sampleRate));
    Eigen::Index finger = 0, loudest = 0;
    performed.played.displacements.leftCols (whole.count).cwiseAbs().maxCoeff (&finger, &loudest);
    return { std::clamp<Eigen::Index> (loudest - count / 6, 0, whole.count - count), count };
}

LineChart waveformChart (const PerformedWaveforms& performed, Eigen::Index finger, ShownSamples shown)
{
    const auto& played = performed.played;
    const auto first = static_cast<double> (shown.first - played.trigger) / played.sampleRate * milli;
    const Eigen::VectorXd times = Eigen::VectorXd::LinSpaced (
        shown.count, first, first + static_cast<double> (shown.count - 1) / played.sampleRate * milli);
    LineChart chart;
    chart.series = {
        { "reached", times, played.displacements.row (finger).segment (shown.first, shown.count).transpose() * micro },
        { "wanted", times, wantedOf (performed, finger).segment (shown.first, shown.count) * micro, LineStyle::dashed }
    };
    chart.series.back().colour = series_colour::neutral;
    return chart;
}

/** Lines of a motion's spectrum in dB over the strongest wanted one. */
Series spectrumOf (const std::string& name, const Eigen::VectorXd& motion, double sampleRate, double upper, double zero)
{
    const auto length = quickLength (static_cast<double> (motion.size()));
    const Eigen::VectorXd lines = forwardFourier (motion, length).cwiseAbs();
    const auto step = sampleRate / static_cast<double> (length);
    const auto shown = std::min (lines.size() - 1, static_cast<Eigen::Index> (upper / step));
    Series series;
    series.name = name;
    series.x = Eigen::VectorXd::LinSpaced (shown, step, step * static_cast<double> (shown));
    series.y = 20 * (lines.segment (1, shown) / zero).array().max (leastLine).log10();
    return series;
}

double strongestLine (const PerformedWaveforms& performed)
{
    double strongest = 0;

    for (Eigen::Index p = 0; p < performed.design.wanted.cols(); ++p)
    {
        const auto wanted = wantedOf (performed, p);
        const auto length = quickLength (static_cast<double> (wanted.size()));
        strongest = std::max (strongest, forwardFourier (wanted, length).cwiseAbs().maxCoeff());
    }

    return strongest;
}

LineChart spectrumChart (const PerformedWaveforms& performed, Eigen::Index finger, double strongest)
{
    const auto& played = performed.played;
    const auto& band = performed.design.description.band;
    const auto wanted = wantedOf (performed, finger);
    const Eigen::VectorXd reached = played.displacements.row (finger).transpose();
    const auto upper = shownBeyondBand * band.upper;
    LineChart chart;
    chart.xRange = AxisRange { 0, upper };
    chart.yRange = AxisRange { -shownDecibels, 5 };
    chart.series.push_back (spectrumOf ("reached", reached, played.sampleRate, upper, strongest));

    if (wanted.cwiseAbs().maxCoeff() > 0)
        chart.series.push_back (spectrumOf ("wanted", wanted, played.sampleRate, upper, strongest));

    chart.series.push_back (spectrumOf ("difference", reached - wanted, played.sampleRate, upper, strongest));
    chart.series.back().style = LineStyle::dotted;
    return chart;
}

ChartGrid fingerGrid (const PerformedWaveforms& performed)
{
    const auto fingers = performed.scores.fingers.size();
    ChartGrid grid;
    grid.columns = static_cast<int> (std::min<std::size_t> (fingers, 4));

    for (std::size_t p = 0; fingers <= 4 && p < fingers; ++p)
        grid.columnTitles.push_back (fingerName (performed.design.description, p));

    return grid;
}

int gridHeight (const ChartGrid& grid)
{
    constexpr int rowHeight = 240;
    const auto rows = (static_cast<int> (grid.panels.size()) + grid.columns - 1) / grid.columns;
    return rowHeight * rows + 60;
}

ChartGrid waveformGrid (const PerformedWaveforms& performed, ShownSamples shown)
{
    auto grid = fingerGrid (performed);
    grid.xLabel = "time (ms)";
    grid.yLabel = "displacement (um)";

    for (Eigen::Index p = 0; p < performed.design.wanted.cols(); ++p)
        grid.panels.emplace_back (waveformChart (performed, p, shown));

    return grid;
}

ReportSection waveformSection (const PerformedWaveforms& performed)
{
    ReportSection section;
    section.heading = "What each finger gets";
    section.paragraphs = { "Displacement beneath each finger over the whole event, ringing included, on the surface "
                           "with the fingers on it." };
    auto waveforms = fingerWaveformsChart (performed);
    const auto height = gridHeight (waveforms);
    section.figures.push_back (
        { "Wanted (dashed) and reached waveforms.", {}, std::move (waveforms), reportFigureWidth, height });

    if (static_cast<double> (wholeEvent (performed).count) > longEvent * performed.played.sampleRate)
        section.figures.push_back ({ "The same around the largest motion.",
                                     {},
                                     waveformGrid (performed, loudestPart (performed)),
                                     reportFigureWidth,
                                     height });

    auto spectra = fingerGrid (performed);
    spectra.xLabel = "frequency (Hz)";
    spectra.yLabel = "displacement (dB)";
    const auto strongest = strongestLine (performed);

    for (Eigen::Index p = 0; p < performed.design.wanted.cols(); ++p)
        spectra.panels.emplace_back (spectrumChart (performed, p, strongest));

    section.figures.push_back ({ "Spectra; 0 dB is the strongest line of all wanted waveforms.",
                                 {},
                                 std::move (spectra),
                                 reportFigureWidth,
                                 height });
    return section;
}

/** One coordinate of a point; of one that moves where it begins and ends. */
std::string coordinateInWords (const TouchedPoint& point, double PathPoint::*coordinate, double still)
{
    if (point.path.empty() || point.path.front().*coordinate == point.path.back().*coordinate)
        return inWords (still * milli);

    return inWords (point.path.front().*coordinate * milli) + " to " + inWords (point.path.back().*coordinate * milli);
}

ReportTable fingerTable (const PerformedWaveforms& performed)
{
    ReportTable table {
        "Fingers: unwanted motion is compared with the strongest track, within the band and with all frequencies",
        { "finger", "x (mm)", "y (mm)", "wanted (um)", "reached (um)", "error (dB)", "all frequencies (dB)",
          "felt (dB SL)" },
        {}
    };
    const auto points = touchedPoints (performed.design.description);

    for (std::size_t p = 0; p < points.size(); ++p)
    {
        const auto& score = performed.scores.fingers[p];
        table.rows.push_back (
            { fingerName (performed.design.description, p), coordinateInWords (points[p], &PathPoint::x, points[p].x),
              coordinateInWords (points[p], &PathPoint::y, points[p].y), inWords (score.wantedPeak * micro),
              inWords (score.reachedPeak * micro), fixedText (performed.scores.suppression (p), 1),
              fixedText (performed.scores.wideSuppression (p), 1), fixedText (performed.felt.targets[p].level, 1) });
    }

    return table;
}

ReportSection elsewhereSection (const PerformedWaveforms& performed)
{
    ReportSection section;
    section.heading = "Felt level elsewhere";
    section.paragraphs = {
        fixedText (100 * performed.felt.feltShare, 0)
            + " % of the surface is felt. Below 1 kHz a plate has few modes: no area can be quiet, only the points "
              "that "
              "are touched. Every further finger that should feel nothing has to be named.",
        "The levels are a model: displacement, weighted by the threshold at each frequency (" + performed.felt.threshold
            + "), the larger of its peak and root 2 times its RMS within 100 ms. Persons differ by 10 to 20 dB."
    };
    section.figures.push_back (feltFigure (performed.judge, performed.felt));
    return section;
}

ReportSection trackVoltageSection (const PerformedWaveforms& performed)
{
    const auto& voltages = performed.design.voltages;
    StackedTraces traces;
    traces.xLabel = "time (ms)";
    traces.unit = "V";
    traces.start = voltages.firstTime * milli;
    traces.step = milli / voltages.playback.sampleRate;
    traces.values = voltages.values;
    traces.limits = voltageLimits (performed.judge);

    for (const auto& ceramic : performed.judge.ceramics)
        traces.names.push_back (ceramic.name);

    const auto height = comfortableHeight (traces);
    ReportSection section;
    section.heading = "Voltages";
    section.paragraphs = { "Largest voltage: " + trackVoltsInWords (performed) + "." };
    section.figures.push_back (
        { "Voltage of each ceramic with its limits (dashed); the number at the right is its peak.",
          {},
          std::move (traces),
          reportFigureWidth,
          height });
    section.tables.push_back (fingerTable (performed));
    return section;
}

ReportSection toleranceSection (const WaveformsDescription& description, const WaveformsTolerance& tolerance)
{
    ReportTable table {
        "Percentiles over the devices: felt levels (dB SL) and unwanted motion over the strongest track "
        "(dB)",
        { "finger", "result" },
        {}
    };

    for (const auto percent : tolerancePercents)
        table.header.push_back (fixedText (percent, 0) + " %");

    for (Eigen::Index p = 0; p < tolerance.levels.cols(); ++p)
        for (const auto& [result, draws] :
             { std::pair ("felt", &tolerance.levels), { "error", &tolerance.suppression } })
        {
            table.rows.push_back ({ fingerName (description, static_cast<std::size_t> (p)), result });
            const auto column = draws->col (p);

            for (const auto value : computePercentiles ({ column.begin(), column.end() }))
                table.rows.back().push_back (fixedText (value, 1));
        }

    ReportSection section;
    section.heading = "On devices that deviate";
    section.paragraphs = { "The same voltages on " + std::to_string (tolerance.options.draws)
                           + " random devices around the model; tolerance.csv has all of them." };
    section.tables.push_back (std::move (table));
    return section;
}

std::vector<ReportScore> waveformScores (const PerformedWaveforms& performed)
{
    const auto& description = performed.design.description;
    std::vector<ReportScore> scores;
    double worst = -200, error = 0;

    for (std::size_t p = 0; p < performed.scores.fingers.size(); ++p)
    {
        worst = std::max (worst, performed.scores.suppression (p));

        if (p < description.tracks.size())
            error = std::max (error, performed.scores.normalisedError (p));
    }

    scores.push_back ({ "Suppression", fixedText (worst, 1) + " dB",
                        "Unwanted motion over the strongest track, at the worst finger." });
    scores.push_back ({ "Error of a track", formatted ("%.1e", error),
                        "Energy of reached minus wanted over that of the wanted waveform, the worst track." });
    scores.push_back ({ "Peak voltage", inWords (performed.design.peaks.maxCoeff()) + " V", "Of all ceramics." });

    if (performed.power.obstacle.empty())
        scores.push_back ({ "Energy", inWords (performed.power.once.electricalIn() * milli) + " mJ",
                            "Taken by the ceramics in one play." });

    return scores;
}
} // namespace

ChartGrid fingerWaveformsChart (const PerformedWaveforms& performed)
{
    return waveformGrid (performed, wholeEvent (performed));
}

ReportPage waveformsReport (const PerformedWaveforms& performed)
{
    const auto& description = performed.design.description;
    ReportPage page;
    page.title = description.name;
    page.subtitle = performed.judge.name + ": " + std::to_string (performed.judge.actuators()) + " ceramics, "
                    + std::to_string (performed.judge.modes()) + " modes simulated, "
                    + std::to_string (description.tracks.size()) + " tracks, "
                    + std::to_string (description.silent.size()) + " silent fingers, "
                    + inWords (performed.played.sampleRate) + " Hz";
    page.scores = waveformScores (performed);
    page.warnings = performed.design.warnings;
    page.sections = { waveformSection (performed), elsewhereSection (performed), trackVoltageSection (performed),
                      powerSection (performed.judge, performed.power) };

    if (performed.tolerance)
        page.sections.push_back (toleranceSection (description, *performed.tolerance));

    page.links = { { "summary.json", "summary.json" } };
    page.footer = "Antinode " ANTINODE_VERSION
                  ". The waveforms are computed in time by a model of more modes than the design knows.";
    return page;
}
} // namespace antinode
