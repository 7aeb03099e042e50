#include "PaperFigures.h"

#include "PaperTables.h"

#include <antinode_base/NumberText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_charts/FocusCharts.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/Prediction.h>
#include <antinode_focus/Transients.h>
#include <antinode_library/Inputs.h>

#include <algorithm>
#include <string>

namespace antinode
{
namespace
{
constexpr double rate = 192000; // Hz

RenderedFocus renderWhole (const ModalModel& model, double focusTime)
{
    auto description = loadFocus ("paper-sinc25-p4", {});
    description.focusTime = focusTime;
    RenderOptions options;
    options.playback = { Reconstruction::bandLimited, rate };
    return renderFocus (model, designFocus (model, description, options.playback), options);
}

/** The velocity of one mode under the paper's drive, for one growth, over its own time. */
Series growthSeries (double a, double b, double growth, int cycles)
{
    constexpr double focus = 0.05;
    constexpr Eigen::Index points = 4000;
    const auto drive = driveMode ({ 0, a, b, growth, cycles }, DriveKind::paper, focus);
    const auto start = drive.oscillations.front().start;
    Series series;
    series.name = "growth " + inWords (growth);
    series.x = Eigen::VectorXd::LinSpaced (points, 0, (focus - start) * milli);
    series.y.resize (points);

    for (Eigen::Index i = 0; i < points; ++i)
    {
        std::complex<double> state = 0;

        for (const auto& oscillation : drive.oscillations)
            state += modalResponse ({ -a, b }, oscillation, start + series.x[i] / milli);

        series.y[i] = state.real() - a / b * state.imag();
    }

    return series;
}

PaperFigure growthFigure (const ModalModel& model)
{
    ChartGrid grid;
    grid.xLabel = "time from the start of the mode (ms)";
    grid.yLabel = "velocity / velocity at the focus";
    grid.columns = 2;
    const auto decay = decayRates (model);
    const auto frequency = dampedFrequencies (model);

    for (const auto& [mode, cycles] : { std::pair { 0, 10 }, std::pair { 3, 25 } })
    {
        LineChart chart;

        for (const auto growth : { 10.0, 4.0, 1.0 })
            chart.series.push_back (growthSeries (decay[mode], frequency[mode], growth, cycles));

        std::swap (chart.series.front(), chart.series.back()); // the largest envelope is drawn first
        grid.columnTitles.push_back (inWords (model.frequencyHz (mode)) + " Hz, Q "
                                     + inWords (0.5 / model.dampingRatios[mode]));
        grid.panels.emplace_back (chart);
    }

    return { "figure-03", "Fig. 3: how two modes grow to their velocity at the focus, for three growths", grid };
}

std::string caseTitle (const TwoModeCase& study)
{
    return std::string (study.drive == DriveKind::paper ? "paper's drive, " : "offset-free, ") + inWords (study.limit)
           + " V, " + (study.isAllocated ? "allocated" : "one ceramic per mode");
}

PaperFigure twoModeVoltages (const TwoModeStudy& study)
{
    ChartGrid grid;
    grid.columns = 2;

    for (const auto& one : study.cases)
    {
        auto traces = one.result ? voltagesChart (one.result->model, one.result->design.program, one.result->render)
                                 : StackedTraces {};
        traces.title = caseTitle (one) + (one.result ? "" : ": infeasible");
        grid.panels.emplace_back (traces);
    }

    return { "figure-09", "Fig. 4, 9 and 10: the voltages of two ceramics for two modes, within 20 V and 50 V", grid,
             960, 1000 };
}

PaperFigure twoModeSpectra (const TwoModeStudy& study)
{
    ChartGrid grid;
    grid.columns = 2;
    grid.xLabel = "mode";
    grid.yLabel = "modal velocity (mm/s \xE2\x88\x9Akg)";

    for (const auto& one : study.cases)
    {
        auto chart = one.result
                         ? spectrumChart (one.result->model, one.result->design, one.result->render.focusVelocities)
                         : BarChart {};
        chart.title = caseTitle (one) + (one.result ? "" : ": infeasible");
        chart.xLabel.clear();
        chart.yLabel.clear();
        grid.panels.emplace_back (chart);
    }

    return { "figure-11", "Fig. 11: the modal velocities at the focus in the same eight cases", grid, 960, 1000 };
}

LineChart fieldPanel (const RenderedFocus& focus)
{
    auto chart = fieldChart (focus.model, focus.design.target.field, focus.design.truncatedField, focus.reachedField);
    chart.xLabel.clear();
    chart.yLabel.clear();
    chart.spans.clear();
    return chart;
}

BarChart spectrumPanel (const RenderedFocus& focus)
{
    auto chart = spectrumChart (focus.model, focus.design, focus.render.focusVelocities);
    chart.xLabel.clear();
    chart.yLabel.clear();
    return chart;
}

template <typename MakePanel>
ChartGrid makeGrid (const std::vector<PaperCell>& cells, const std::vector<std::size_t>& rows, MakePanel&& makePanel)
{
    ChartGrid grid;
    grid.columns = static_cast<int> (paperPlaces);
    grid.columnTitles = { "-46 mm", "-24 mm", "0 mm", "24 mm", "46 mm" };

    for (const auto row : rows)
    {
        grid.rowTitles.emplace_back (paperTables[row].name);

        for (std::size_t place = 0; place < paperPlaces; ++place)
            grid.panels.emplace_back (makePanel (cells[row * paperPlaces + place].exact));
    }

    return grid;
}

PaperFigure fieldFigure (const std::vector<PaperCell>& cells, const std::vector<std::size_t>& rows, std::string name,
                         std::string caption)
{
    auto grid = makeGrid (cells, rows, fieldPanel);
    grid.xLabel = "position (mm)";
    grid.yLabel = "velocity (mm/s)";
    return { std::move (name), std::move (caption), grid, 1200, 140 + 190 * static_cast<int> (rows.size()) };
}

PaperFigure spectrumFigure (const std::vector<PaperCell>& cells)
{
    auto grid = makeGrid (cells, { 0, 1, 2, 3 }, spectrumPanel);
    grid.xLabel = "mode";
    grid.yLabel = "modal velocity (mm/s \xE2\x88\x9Akg)";
    return { "figure-13", "Fig. 13: the modal velocities at the focus, wanted and reached, of all twenty fields", grid,
             1200, 900 };
}

void addTimeFigures (std::vector<PaperFigure>& figures, const ModalModel& model)
{
    constexpr double shown = 0.0015;         // s around the focus
    constexpr double shownFrequency = 12000; // Hz, a little above the highest controlled mode

    const auto early = renderWhole (model, 0.025);
    const auto late = renderWhole (model, 0.05);
    figures.push_back ({ "figure-14", "Fig. 14: the transients of the five strongest modes (sinc 25 mm at 24 mm)",
                         transientsChart (early.model, early.design, early.render, 5), 960, 480 });
    figures.push_back ({ "figure-15", "Fig. 15: the spectrogram of the velocity at the focus",
                         spectrogramChart (early.render, 0, shownFrequency) });
    figures.push_back ({ "figure-16a", "Fig. 16: the field over position and time around a focus after 25 ms",
                         fieldOverTimeChart (early.model, early.design, early.render, shown), 960, 480 });
    figures.push_back ({ "figure-16b", "Fig. 16: the same after 50 ms",
                         fieldOverTimeChart (late.model, late.design, late.render, shown), 960, 480 });
}
} // namespace

std::vector<PaperFigure> paperFigures (const ModalModel& model, const std::vector<PaperCell>& cells,
                                       const TwoModeStudy& study)
{
    std::vector<PaperFigure> figures;
    figures.push_back (growthFigure (model));
    figures.push_back (twoModeVoltages (study));
    figures.push_back (twoModeSpectra (study));
    figures.push_back (
        fieldFigure (cells, { 0, 1, 2 }, "figure-12", "Fig. 12: the fifteen sinc fields: wanted, truncated, reached"));
    figures.push_back (spectrumFigure (cells));
    addTimeFigures (figures, model);
    figures.push_back (
        fieldFigure (cells, { 3 }, "figure-17", "Fig. 17: the five bump fields: wanted, truncated, reached"));
    return figures;
}
} // namespace antinode
