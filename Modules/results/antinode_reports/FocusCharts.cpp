#include "FocusCharts.h"

#include "Ticks.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Prefixes.h>
#include <antinode_base/Watch.h>
#include <unsupported/Eigen/FFT>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace antinode
{
namespace
{
constexpr int shownGuardModes = 6; // of the uncontrolled modes above the controlled ones
constexpr Eigen::Index mapColumns = 240, mapRows = 200;

double focusTime (const Render& render)
{
    return static_cast<double> (render.focusSample) / render.sampleRate * milli;
}

std::string modeName (const ModalModel& model, int mode)
{
    return "mode " + std::to_string (mode + 1) + ", " + std::to_string (std::lround (model.frequencyHz (mode))) + " Hz";
}

Series fieldSeries (const Eigen::VectorXd& places, const std::string& name, const Eigen::VectorXd& field,
                    LineStyle style, int colour)
{
    Series series;
    series.name = name;
    series.x = places * milli;
    series.y = field * milli;
    series.style = style;
    series.colour = colour;
    return series;
}
} // namespace

LineChart profileChart (const Eigen::VectorXd& places, const Eigen::MatrixX3d& velocities)
{
    LineChart chart;
    chart.xLabel = "position (mm)";
    chart.yLabel = "velocity (mm/s)";
    // The reached field mostly covers the represented one, so the dashes are drawn on top.
    chart.series = { fieldSeries (places, "wanted", velocities.col (0), LineStyle::dotted, series_colour::neutral),
                     fieldSeries (places, "reached", velocities.col (2), LineStyle::solid, 0),
                     fieldSeries (places, "represented by the controlled modes", velocities.col (1), LineStyle::dashed,
                                  1) };
    return chart;
}

LineChart fieldChart (const ModalModel& model, const Eigen::VectorXd& wanted, const Eigen::VectorXd& truncated,
                      const Eigen::VectorXd& reached)
{
    Eigen::MatrixX3d velocities (model.points(), 3);
    velocities << wanted, truncated, reached;
    auto chart = profileChart (model.surface.points.col (0), velocities);

    for (const auto& ceramic : model.ceramics)
        chart.spans.push_back ({ ceramic.xMinimum * milli, ceramic.xMaximum * milli, ceramic.name });

    return chart;
}

BarChart spectrumChart (const ModalModel& model, const FocusDesign& design, const Eigen::VectorXd& reached)
{
    const auto shown = std::min<Eigen::Index> (model.modes(), design.controlledModes.back() + 1 + shownGuardModes);
    Eigen::VectorXd wanted = Eigen::VectorXd::Constant (shown, std::nan (""));
    BarChart chart;

    for (const auto mode : design.controlledModes)
        wanted[mode] = design.target.modalVelocities[mode] * milli;

    for (Eigen::Index k = 0; k < shown; ++k)
        chart.categories.push_back (std::to_string (k + 1));

    chart.xLabel = "mode";
    chart.yLabel = "modal velocity (mm/s \xE2\x88\x9Akg)";
    chart.series = { { "wanted (controlled modes)", wanted, 1 }, { "reached", reached.head (shown) * milli, 0 } };
    return chart;
}

StackedTraces voltagesChart (const ModalModel& model, const VoltageProgram& program, const Render& render)
{
    StackedTraces traces;
    traces.xLabel = "time (ms)";
    traces.unit = "V";
    traces.step = milli / render.sampleRate;
    traces.values = render.voltages;
    traces.limits = program.voltageLimits;
    traces.markers = { { focusTime (render), "focus" } };

    for (const auto& ceramic : model.ceramics)
        traces.names.push_back (ceramic.name);

    return traces;
}

LineChart probeChart (const Render& render, Eigen::Index probe, const std::string& name)
{
    const auto samples = render.probeVelocities.cols();
    Series series;
    series.name = name;
    series.x = Eigen::VectorXd::LinSpaced (samples, 0, static_cast<double> (samples - 1) / render.sampleRate * milli);
    series.y = render.probeVelocities.row (probe).transpose() * milli;

    LineChart chart;
    chart.xLabel = "time (ms)";
    chart.yLabel = "velocity (mm/s)";
    chart.series = { series };
    chart.markers = { { focusTime (render), "focus" } };
    chart.legend = LegendPlace::none;
    return chart;
}

StackedTraces transientsChart (const ModalModel& model, const FocusDesign& design, const Render& render, int count)
{
    auto modes = design.controlledModes;
    Eigen::VectorXd largest = Eigen::VectorXd::Zero (model.modes());

    for (const auto mode : modes)
        largest[mode] = model.shapes.col (mode).cwiseAbs().maxCoeff();

    const auto strength = [&] (int mode) { return std::abs (design.target.modalVelocities[mode]) * largest[mode]; };
    std::stable_sort (modes.begin(), modes.end(), [&] (int a, int b) { return strength (a) > strength (b); });
    modes.resize (std::min (modes.size(), static_cast<std::size_t> (count)));
    std::sort (modes.begin(), modes.end());

    StackedTraces traces;
    traces.xLabel = "time (ms)";
    traces.unit = "mm/s";
    traces.step = milli / render.sampleRate;
    traces.values.resize (static_cast<Eigen::Index> (modes.size()), render.modalVelocities.cols());
    traces.markers = { { focusTime (render), "focus" } };

    for (std::size_t i = 0; i < modes.size(); ++i)
    {
        traces.values.row (static_cast<Eigen::Index> (i)) =
            render.modalVelocities.row (modes[i]) * (largest[modes[i]] * milli);
        traces.names.push_back (modeName (model, modes[i]));
    }

    return traces;
}

HeatMap spectrogramChart (const Render& render, Eigen::Index probe, double maximumFrequency)
{
    SpectrogramSettings settings;
    settings.maximumFrequency = std::min (maximumFrequency, 0.5 * render.sampleRate);
    const Eigen::VectorXd signal = render.probeVelocities.row (probe).transpose();
    const auto result = spectrogram (signal, render.sampleRate, settings);

    HeatMap map;
    map.xLabel = "time (ms)";
    map.yLabel = "frequency (kHz)";
    map.valueLabel = "level (dB re largest)";
    // Before the trigger there is silence, but after the last sample the plate continues to move: windows that reach
    // beyond it would show a cut.
    const auto end = static_cast<double> (signal.size() - 1) / render.sampleRate;
    const auto shown = (result.times.array() <= end - 0.5 * settings.windowDuration).count();
    map.values = result.decibels.leftCols (std::max<Eigen::Index> (shown, 1));
    map.x = { 0, result.times[std::max<Eigen::Index> (shown, 1) - 1] * milli };
    map.y = { 0, result.frequencies[result.frequencies.size() - 1] / milli };
    map.markers = { { focusTime (render), "focus" } };
    return map;
}

HeatMap fieldOverTimeChart (const ModalModel& model, const FocusDesign& design, const Render& render, double span)
{
    Eigen::MatrixXd shapes (mapColumns, model.coordinates());
    const auto& surface = model.surface;
    const auto width = surface.xMaximum - surface.xMinimum;
    const auto isPlate = surface.kind == SurfaceKind::plate;
    const auto y = isPlate ? design.description.targets.front().y : 0.0;

    for (Eigen::Index i = 0; i < mapColumns; ++i)
    {
        const auto x = surface.xMinimum + width * (static_cast<double> (i) + 0.5) / mapColumns;

        if (liesOn (surface, x, y))
            shapes.row (i) = shapesAt (model, x, y);
        else
            shapes.row (i).setConstant (std::nan ("")); // beyond its boundary: left empty
    }

    Eigen::MatrixXd velocities (model.modes(), mapRows);

    for (Eigen::Index j = 0; j < mapRows; ++j)
    {
        const auto offset =
            std::lround (span * render.sampleRate * (2 * (static_cast<double> (j) + 0.5) / mapRows - 1));
        const auto sample =
            std::clamp<Eigen::Index> (render.focusSample + offset, 0, render.modalVelocities.cols() - 1);
        velocities.col (j) = render.modalVelocities.col (sample);
    }

    HeatMap map;
    map.xLabel = isPlate ? "x (mm)" : "position (mm)";
    map.yLabel = "time from the focus (ms)";
    map.valueLabel = "velocity (mm/s)";
    map.values = (shapes * velocities).transpose() * milli;
    map.x = { surface.xMinimum * milli, surface.xMaximum * milli };
    map.y = { -span * milli, span * milli };
    map.scale = ColourScale::diverging;

    // Those that lie on the line.
    for (const auto& target : design.description.targets)
        if (! isPlate || target.y == y)
            map.points.push_back ({ target.x * milli, 0, "focus" });

    return map;
}

namespace
{
void requireUsable (double sampleRate, const SpectrogramSettings& settings)
{
    const auto require = [] (bool isUsable, const std::string& what, double value, const std::string& allowed)
    {
        if (! isUsable)
            throw InputError ("spectrogram", what + " is " + formatNumber (value) + "; allowed: " + allowed);
    };
    require (std::isfinite (sampleRate) && sampleRate > 0, "the sample rate", sampleRate, "above 0 Hz");
    const auto samples = settings.windowDuration * sampleRate;
    require (samples >= 4 && samples <= 1e7, "the window's length", samples, "4 to 10 000 000 samples");
    require (settings.columns >= 1 && settings.columns <= 100000, "the number of instants", settings.columns,
             "1 to 100 000");
    require (settings.floorDecibels < 0, "the floor", settings.floorDecibels, "below 0 dB");
    require (settings.reference >= 0, "the reference", settings.reference, "0 or more");
    require (settings.maximumFrequency >= 0, "the highest frequency", settings.maximumFrequency, "0 Hz or more");
}

// Hann, scaled so that a sine of amplitude 1 has a line of height 1.
Eigen::VectorXd amplitudeWindow (Eigen::Index length)
{
    const Eigen::ArrayXd place =
        (Eigen::ArrayXd::LinSpaced (length, 0, static_cast<double> (length - 1)) + 0.5) / static_cast<double> (length);
    const Eigen::VectorXd window = (1 - (2 * std::numbers::pi * place).cos()).matrix();
    return window * (2 / window.sum());
}

// Twice the window or more: zero padding, so that lines between two frequencies lose little.
Eigen::Index transformLength (Eigen::Index window)
{
    Eigen::Index length = 1;
    while (length < 2 * window)
        length *= 2;
    return length;
}

std::vector<double> windowed (const Eigen::Ref<const Eigen::VectorXd>& signal, const Eigen::VectorXd& window,
                              Eigen::Index middle, Eigen::Index length)
{
    std::vector<double> frame (static_cast<std::size_t> (length), 0.0);
    for (Eigen::Index k = 0; k < window.size(); ++k)
    {
        const auto sample = middle - window.size() / 2 + k;
        if (sample >= 0 && sample < signal.size() && std::isfinite (signal[sample]))
            frame[static_cast<std::size_t> (k)] = signal[sample] * window[k];
    }
    return frame;
}

Eigen::MatrixXd toDecibels (const Eigen::MatrixXd& amplitudes, const SpectrogramSettings& settings)
{
    const auto largest = amplitudes.maxCoeff();
    const auto reference = settings.reference > 0 ? settings.reference : largest;
    if (! (reference > 0))
        return Eigen::MatrixXd::Constant (amplitudes.rows(), amplitudes.cols(), settings.floorDecibels);
    const auto minimum = std::pow (10.0, settings.floorDecibels / 20);
    return (20 * (amplitudes.array() / reference).max (minimum).log10()).matrix();
}
} // namespace

Spectrogram spectrogram (const Eigen::Ref<const Eigen::VectorXd>& signal, double sampleRate,
                         const SpectrogramSettings& settings)
{
    requireUsable (sampleRate, settings);
    const auto window = amplitudeWindow (std::lround (settings.windowDuration * sampleRate));
    const auto length = transformLength (window.size());
    const auto spacing = sampleRate / static_cast<double> (length);
    const auto highest = settings.maximumFrequency > 0 ? settings.maximumFrequency : sampleRate / 2;
    const auto rows = std::min (length / 2, static_cast<Eigen::Index> (std::min (highest / spacing, 1e9))) + 1;

    Spectrogram result;
    const auto lastSample = static_cast<double> (std::max<Eigen::Index> (0, signal.size() - 1));
    const Eigen::VectorXd middles = Eigen::VectorXd::LinSpaced (settings.columns, 0, lastSample).array().round();
    result.times = middles / sampleRate;
    result.frequencies = Eigen::VectorXd::LinSpaced (rows, 0, static_cast<double> (rows - 1) * spacing);

    Eigen::FFT<double> transform (Eigen::FFT<double>::impl_type(), Eigen::FFT<double>::HalfSpectrum);
    Eigen::MatrixXd amplitudes (rows, settings.columns);
    std::vector<std::complex<double>> spectrum;
    for (Eigen::Index column = 0; column < amplitudes.cols(); ++column)
    {
        checkWatch();
        transform.fwd (spectrum, windowed (signal, window, static_cast<Eigen::Index> (middles[column]), length));
        for (Eigen::Index row = 0; row < rows; ++row)
            amplitudes (row, column) = std::abs (spectrum[static_cast<std::size_t> (row)]);
    }
    // A constant has one line where a sine has two.
    amplitudes.row (0) /= 2;
    result.decibels = toDecibels (amplitudes, settings);
    return result;
}
} // namespace antinode
