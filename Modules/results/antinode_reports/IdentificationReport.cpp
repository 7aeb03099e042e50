#include "IdentificationReport.h"

#include "IdentificationTables.h"
#include "ModesReport.h"
#include "PlateCharts.h"

#include <antinode_base/MessageText.h>
#include <antinode_identification/FitDiagram.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace antinode
{
namespace
{
constexpr int galleryCount = 48;
constexpr std::size_t shownPairs = 6;

/** A point and a reference. */
struct Pair
{
    Eigen::Index point = 0, reference = 0;
    double energy = 0;
};

double finiteEnergy (const Eigen::VectorXcd& values)
{
    const Eigen::ArrayXd squares = values.cwiseAbs2();
    return squares.isFinite().select (squares, 0).sum();
}

/** For one reference after the other the points that move most, each point once. */
std::vector<Pair> strongestPairs (const FrequencyResponses& measured)
{
    std::vector<Pair> pairs, chosen;

    for (std::size_t i = 0; i < measured.values.size(); ++i)
        for (Eigen::Index p = 0; p < measured.points.rows(); ++p)
            if (const auto energy = finiteEnergy (measured.values[i].col (p)); energy > 0)
                pairs.push_back ({ p, static_cast<Eigen::Index> (i), energy });

    std::stable_sort (pairs.begin(), pairs.end(), [] (const auto& a, const auto& b) { return a.energy > b.energy; });

    for (const auto isNewReference : { true, false })
        for (const auto& pair : pairs)
        {
            const auto same = [&] (const auto& other)
            { return other.point == pair.point || (isNewReference && other.reference == pair.reference); };

            if (chosen.size() < shownPairs && std::none_of (chosen.begin(), chosen.end(), same))
                chosen.push_back (pair);
        }

    return chosen;
}

/** One response as a measurement of its own. */
FrequencyResponses onlyPair (const FrequencyResponses& measured, const Pair& pair)
{
    return { measured.frequencies,
             measured.drive,
             { measured.references[static_cast<std::size_t> (pair.reference)] },
             measured.points.row (pair.point),
             { measured.values[static_cast<std::size_t> (pair.reference)].col (pair.point) },
             {},
             measured.integrations };
}

/** What modes give where they were fitted; elsewhere residual terms mean nothing. */
FrequencyResponses synthesisedWithin (const IdentifiedModes& modes, const FrequencyResponses& measured)
{
    auto result = synthesise (modes, measured.frequencies);
    auto& values = result.values.front();
    const auto lines = usedLines (measured, modes);
    const auto nothing = std::complex<double> (std::numeric_limits<double>::quiet_NaN(), 0);

    for (Eigen::Index f = 0; f < values.rows(); ++f)
        if (! std::binary_search (lines.begin(), lines.end(), f))
            values.row (f).setConstant (nothing);

    return result;
}

/** The modes as one point and one reference see them. */
IdentifiedModes onlyPair (IdentifiedModes modes, const Pair& pair)
{
    modes.references = { modes.references[static_cast<std::size_t> (pair.reference)] };
    modes.points = modes.points.row (pair.point).eval();
    modes.shapes = modes.shapes.row (pair.point).eval();
    modes.participation = modes.participation.col (pair.reference).eval();

    if (modes.complexShapes.size() > 0)
    {
        modes.complexShapes = modes.complexShapes.row (pair.point).eval();
        modes.complexParticipation = modes.complexParticipation.col (pair.reference).eval();
    }

    if (modes.lowPasses.size() > 0)
        modes.lowPasses = modes.lowPasses.block (pair.point, pair.reference, 1, 1).eval();

    for (auto& term : modes.residuals)
        term.coefficients = term.coefficients.block (pair.point, pair.reference, 1, 1).eval();

    return modes;
}

ReportSection stabilisationSection (const IdentificationResult& result)
{
    ReportSection section;
    section.heading = "Stabilisation";
    section.paragraphs = {
        "Polynomials of increasing order are fitted to the responses. Poles that recur at most orders with the same "
        "frequency, damping and participation are modes; isolated poles are not."
    };
    section.figures.push_back ({ "Stabilisation diagram with the numbers of the modes.",
                                 {},
                                 stabilisationChart (result.modes, result.measured),
                                 reportFigureWidth,
                                 420 });
    return section;
}

ReportSection responseSection (const IdentificationResult& result)
{
    const auto& measured = result.measured;
    ReportSection section;
    section.heading = "Measured and synthesised responses";
    section.paragraphs = { "Modes were fitted from " + inWords (result.modes.minimumFrequency) + " to "
                           + inWords (result.modes.maximumFrequency)
                           + " Hz; all measured lines are shown. The phases are without the common delay; where "
                             "the noise of a response is more than half of it, its phase is left out." };

    for (const auto& pair : strongestPairs (measured))
    {
        const auto ofPair = onlyPair (measured, pair);
        section.figures.push_back ({ "Point " + result.pointNames[static_cast<std::size_t> (pair.point)]
                                         + ", reference "
                                         + measured.references[static_cast<std::size_t> (pair.reference)].name + ".",
                                     {},
                                     responseChart (ofPair, synthesisedWithin (onlyPair (result.modes, pair), ofPair),
                                                    0, 0, result.modes.delay),
                                     reportFigureWidth,
                                     440 });
    }

    return section;
}

/** How many of the shapes are shown, and where the others are. */
std::string galleryCaption (const IdentificationResult& result, bool hasDiagram)
{
    std::string scale = std::string (result.model.hasComplexModes() ? "Real parts. " : "")
                        + "Each shape is scaled to its largest value.";

    if (result.model.modes() <= galleryCount)
        return scale;

    return "The lowest " + std::to_string (galleryCount) + " of " + std::to_string (result.model.modes()) + " shapes. "
           + scale + (hasDiagram ? " The diagram to work with shows all of them." : "");
}

ReportSection shapeSection (const IdentificationResult& result, bool hasDiagram)
{
    const auto& model = result.model;
    ReportSection section;
    section.heading = "Mode shapes";
    section.paragraphs = { scalingInWords (result.modes) };

    if (! result.modes.kindReason.empty())
        section.paragraphs.push_back (result.modes.kindReason);

    if (model.points() > 1)
        section.figures.push_back ({ galleryCaption (result, hasDiagram),
                                     {},
                                     modeGallery (model, galleryCount),
                                     reportFigureWidth,
                                     comfortableGalleryHeight (model, galleryCount, reportFigureWidth),
                                     1 });

    if (model.actuators() > 1)
        section.figures.push_back (
            { "Participation of each reference in each mode, relative to the reference that excites the mode most.",
              {},
              participationChart (model),
              reportFigureWidth,
              std::clamp (110 + 16 * static_cast<int> (model.actuators()), 240, 900) });

    return section;
}

/** A matrix of modes with a colour bar at its side: cells are square. */
ReportFigure assuranceFigure (const std::string& caption, HeatMap chart)
{
    constexpr int cell = 16, margin = 90, colourBar = 110, smallest = 280, largest = 760;
    const auto side = std::clamp (margin + cell * static_cast<int> (chart.values.rows()), smallest, largest);
    return { caption, {}, std::move (chart), std::min (side + colourBar, reportFigureWidth), side };
}

ReportSection assuranceSection (const IdentificationResult& result)
{
    const Eigen::MatrixXd shapes = result.model.shapes.leftCols (result.model.modes());
    ReportSection section;
    section.heading = "Independence of the shapes at the points";
    section.paragraphs = {
        "Modal assurance criterion (MAC) between the shapes: 1 for equal shapes at the measured points. Off the "
        "diagonal it is 0 for modes of a whole body that is mapped densely and evenly, but not necessarily for a "
        "part of a body."
    };
    section.figures.push_back (assuranceFigure (
        result.model.hasComplexModes() ? "MAC of the identified modes with each other, of their real parts."
                                       : "MAC of the identified modes with each other.",
        assuranceChart (modalAssurance (shapes, shapes, {}), "mode", "mode")));
    return section;
}

ReportSection comparisonSection (const IdentificationResult& result)
{
    ReportSection section;
    section.heading = "Comparison with " + result.computed->name;
    section.paragraphs = { "Each identified mode with the corresponding computed mode." };
    section.figures.push_back (
        assuranceFigure ("MAC of identified and computed modes at the measured points.",
                         assuranceChart (result.comparison->assurance, "identified mode", "computed mode")));
    section.tables.push_back (pairTable (result));
    return section;
}

ReportSection numberSection (const IdentificationResult& result)
{
    ReportSection section;
    section.heading = "Table of modes";
    section.paragraphs = {
        "Values after a plus-minus sign are standard deviations: the larger of the effect of noise in the responses "
        "and the disagreement of points and references. MPC (modal phase collinearity) is 1 "
        "if all points move in phase. One shape: the fraction of a mode's energy that one shape "
        "times one participation explains."
    };
    auto table = modeTable (result);
    const auto warnings = warningColumn (result);
    table.header.emplace_back ("warnings");

    for (std::size_t k = 0; k < table.rows.size(); ++k)
        table.rows[k].push_back (k < warnings.size() ? warnings[k] : "");

    section.tables.push_back (std::move (table));
    return section;
}
} // namespace

ReportPage identificationReport (const IdentificationResult& result, const std::string& diagramName)
{
    const auto& modes = result.modes;
    ReportPage page;
    page.title = result.model.name + ": identified modes";
    page.subtitle = sizeInWords (result);

    if (! diagramName.empty())
        page.links = { { "Diagram to work with: pick and reject poles, all responses, moving shapes", diagramName } };

    page.scores = { { "modes", std::to_string (modes.modes()), "found in this band" },
                    { "reconstruction error", fixedText (modes.reconstructionError, 1) + " dB",
                      "part of the measured responses that modes and residual terms do not explain; "
                          + fixedText (modes.modalReconstructionError, 1) + " dB by the modes alone" },
                    { "delay", delayInWords (modes) + " \xC2\xB5s", "common delay of all responses" } };
    page.warnings = summariseWarnings (result);
    page.sections = { stabilisationSection (result), responseSection (result),
                      shapeSection (result, ! diagramName.empty()), assuranceSection (result) };

    if (result.comparison)
        page.sections.push_back (comparisonSection (result));

    page.sections.push_back (numberSection (result));
    page.footer = "Antinode " ANTINODE_VERSION;
    return page;
}

namespace
{
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/** Dots without a line between them: a gap stands behind each. */
Series dots (const std::string& name, const std::vector<StabilisationPoint>& points, bool stable, int colour)
{
    Series series;
    series.name = name;
    series.points = true;
    series.colour = colour;
    std::vector<double> x, y;

    for (const auto& point : points)
        if (point.stable == stable)
        {
            x.insert (x.end(), { point.frequency, point.frequency });
            y.insert (y.end(), { static_cast<double> (point.order), nothing });
        }

    series.x = Eigen::Map<const Eigen::VectorXd> (x.data(), static_cast<Eigen::Index> (x.size()));
    series.y = Eigen::Map<const Eigen::VectorXd> (y.data(), static_cast<Eigen::Index> (y.size()));
    return series;
}

/** Root of the mean square over points and references at each line. */
Eigen::VectorXd meanMagnitude (const FrequencyResponses& responses)
{
    Eigen::ArrayXd sum = Eigen::ArrayXd::Zero (responses.frequencies.size());

    for (const auto& values : responses.values)
        sum += values.cwiseAbs2()
                   .unaryExpr ([] (double square) { return std::isfinite (square) ? square : 0.0; })
                   .rowwise()
                   .sum()
                   .array();

    return sum.sqrt();
}

/** The magnitude in decades, stretched between two orders. */
Series magnitudeBehind (const FrequencyResponses& responses, double lowest, double highest)
{
    Series series;
    series.name = "mean magnitude (logarithmic, arbitrary scale)";
    series.colour = series_colour::neutral;

    const Eigen::ArrayXd magnitude = meanMagnitude (responses);
    const Eigen::ArrayXd decades = (magnitude / magnitude.maxCoeff()).max (1e-12).log10();
    series.x = responses.frequencies;
    series.y = lowest + (highest - lowest) * (decades - decades.minCoeff()) / std::max (-decades.minCoeff(), 1e-12);
    return series;
}

/** Degrees over frequency without the delay; a gap stands at each leap from one end of the scale to the other, so that
   no line crosses it, and where the values are less than hidden. */
Series phaseCurve (const Eigen::VectorXd& frequencies, const Eigen::VectorXcd& values, double delay,
                   const Eigen::VectorXd& hidden)
{
    constexpr double halfTurn = 180;
    std::vector<double> x, y;

    for (Eigen::Index n = 0; n < values.size(); ++n)
    {
        const auto turned = values[n] * std::polar (1.0, 2 * std::numbers::pi * frequencies[n] * delay);
        const auto degrees = std::abs (turned) > hidden[n] ? std::arg (turned) * halfTurn / std::numbers::pi : nothing;

        if (! y.empty() && std::abs (degrees - y.back()) > halfTurn)
        {
            x.push_back (frequencies[n]);
            y.push_back (nothing);
        }

        x.push_back (frequencies[n]);
        y.push_back (degrees);
    }

    Series series;
    series.x = Eigen::Map<const Eigen::VectorXd> (x.data(), static_cast<Eigen::Index> (x.size()));
    series.y = Eigen::Map<const Eigen::VectorXd> (y.data(), static_cast<Eigen::Index> (y.size()));
    return series;
}

/** Magnitudes over frequency. */
Series magnitudeCurve (const Eigen::VectorXd& frequencies, const Eigen::VectorXcd& values)
{
    Series series;
    series.x = frequencies;
    series.y = values.cwiseAbs();
    return series;
}

LineChart comparison (Series measured, Series synthesised, const std::string& label)
{
    measured.name = "measured";
    measured.colour = series_colour::neutral;
    synthesised.name = "synthesised from the modes";
    synthesised.style = LineStyle::dashed;
    synthesised.colour = 0;
    LineChart chart;
    chart.yLabel = label;
    chart.series = { std::move (measured), std::move (synthesised) };
    return chart;
}
} // namespace

LineChart stabilisationChart (const IdentifiedModes& modes, const FrequencyResponses& measured)
{
    LineChart chart;
    chart.xLabel = "frequency (Hz)";
    chart.yLabel = "model order";
    chart.xRange = AxisRange { measured.frequencies[0], measured.frequencies[measured.frequencies.size() - 1] };
    auto lowest = std::numeric_limits<int>::max(), highest = 0;

    for (const auto& point : modes.stabilisation)
    {
        lowest = std::min (lowest, point.order);
        highest = std::max (highest, point.order);
    }

    if (modes.stabilisation.empty())
        return chart;

    chart.series = { magnitudeBehind (measured, lowest, highest + 1), dots ("alone", modes.stabilisation, false, 1),
                     dots ("of a mode", modes.stabilisation, true, 0) };

    for (Eigen::Index k = 0; k < modes.modes(); ++k)
        chart.markers.push_back ({ modes.angularFrequencies[k] / (2 * std::numbers::pi), std::to_string (k + 1) });

    return chart;
}

ChartGrid responseChart (const FrequencyResponses& measured, const FrequencyResponses& synthesised, Eigen::Index point,
                         Eigen::Index reference, double delay)
{
    const auto perDrive = measured.drive == DriveQuantity::force ? "(m/s)/N" : "(m/s)/V";
    const auto& frequencies = measured.frequencies;
    const Eigen::VectorXcd was = measured.values[static_cast<std::size_t> (reference)].col (point);
    const Eigen::VectorXcd is = synthesised.values[static_cast<std::size_t> (reference)].col (point);
    auto magnitude = comparison (magnitudeCurve (frequencies, was), magnitudeCurve (frequencies, is),
                                 std::string ("magnitude (") + perDrive + ")");
    auto phase = comparison (phaseCurve (frequencies, was, delay, 2 * localNoise (was)),
                             phaseCurve (frequencies, is, delay, Eigen::VectorXd::Zero (is.size())), "phase (degrees)");
    magnitude.logarithmicY = true;
    phase.yRange = AxisRange { -180, 180 };
    phase.xRange = AxisRange { frequencies[0], frequencies[frequencies.size() - 1] };
    magnitude.xRange = phase.xRange;
    phase.legend = LegendPlace::none;
    phase.xLabel = "frequency (Hz)";
    ChartGrid grid;
    grid.columns = 1;
    grid.sharedScale = false;
    grid.panels = { std::move (magnitude), std::move (phase) };
    return grid;
}

HeatMap assuranceChart (const Eigen::MatrixXd& assurance, const std::string& rowLabel, const std::string& columnLabel)
{
    HeatMap chart;
    chart.xLabel = columnLabel;
    chart.yLabel = rowLabel;
    chart.valueLabel = "MAC";
    chart.values = assurance;
    chart.valueRange = AxisRange { 0, 1 };

    for (Eigen::Index row = 0; row < assurance.rows(); ++row)
        chart.rowNames.push_back (std::to_string (row + 1));

    for (Eigen::Index column = 0; column < assurance.cols(); ++column)
        chart.columnNames.push_back (std::to_string (column + 1));

    return chart;
}
} // namespace antinode
