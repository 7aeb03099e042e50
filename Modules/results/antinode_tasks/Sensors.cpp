#include "Sensors.h"

#include "DeviceChecks.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_learning/LearningPasses.h>
#include <antinode_learning/PlayedRecording.h>
#include <antinode_model/ModalModel.h>
#include <antinode_numerics/Statistics.h>
#include <antinode_reports/PlateCharts.h>
#include <antinode_reports/Report.h>
#include <antinode_text/CsvText.h>
#include <antinode_text/OutputFolder.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace antinode
{
namespace
{
constexpr int sensorDigits = 9;

void appendPlace (std::string& text, const Eigen::Vector2d& place)
{
    appendCsvNumber (text, place.x() * milli, sensorDigits);
    text += ',';
    appendCsvNumber (text, place.y() * milli, sensorDigits);
}

/** The chosen places; ceramics need none. */
std::string sensorTable (const ModalModel& model, const SensorPlaces& places)
{
    std::string text = "x_mm,y_mm\n";

    for (std::size_t i = 0; i < places.choice.chosen.size(); ++i)
    {
        if (chosenCeramic (places, i) > 0)
            continue;

        appendPlace (text, sensorPlace (model, places, i));
        text += '\n';
    }

    return text;
}

std::string candidateTable (const SensorPlaces& places)
{
    std::string text = "x_mm,y_mm,bits\n";

    for (std::size_t c = 0; c < places.cell.size(); ++c)
    {
        appendPlace (text, places.cells.centres.row (places.cell[c]));
        text += ',';
        appendCsvNumber (text, places.bits[static_cast<Eigen::Index> (c)], sensorDigits);
        text += '\n';
    }

    return text;
}

/** What one sensor tells, by cells; where there is no surface no number. */
Eigen::VectorXd bitsByCell (const SensorPlaces& places)
{
    Eigen::VectorXd values =
        Eigen::VectorXd::Constant (places.cells.centres.rows(), std::numeric_limits<double>::quiet_NaN());

    for (std::size_t c = 0; c < places.cell.size(); ++c)
        values[places.cell[c]] = places.bits[static_cast<Eigen::Index> (c)];

    return values;
}

HeatMap sensorMap (const ModalModel& model, const SensorPlaces& places)
{
    const auto& surface = model.surface;
    HeatMap chart;
    chart.values = bitsByCell (places).reshaped (places.cells.columns, places.cells.rows).transpose();
    chart.xLabel = "x (mm)";
    chart.yLabel = "y (mm)";
    chart.valueLabel = "one sensor (bits)";
    chart.x = { surface.xMinimum * milli, surface.xMaximum * milli };
    chart.y = { surface.yMinimum * milli, surface.yMaximum * milli };
    chart.equalAspect = true;
    chart.rectangles = ceramicRectangles (model);
    chart.surface = surfaceShape (surface);

    for (std::size_t i = 0; i < places.choice.chosen.size(); ++i)
    {
        const Eigen::Vector2d place = milli * sensorPlace (model, places, i);
        chart.points.push_back ({ place.x(), place.y(), std::to_string (i + 1) });
    }

    return chart;
}

LineChart sensorCurve (const ModalModel& model, const SensorPlaces& places)
{
    LineChart chart;
    chart.xLabel = "position of the sensor (mm)";
    chart.yLabel = "one sensor (bits)";
    chart.series = { { "one sensor", milli * places.cells.centres.col (0), bitsByCell (places) } };
    chart.legend = LegendPlace::none;

    for (const auto& ceramic : model.ceramics)
        chart.spans.push_back ({ ceramic.xMinimum * milli, ceramic.xMaximum * milli, ceramic.name });

    for (std::size_t i = 0; i < places.choice.chosen.size(); ++i)
        chart.markers.push_back ({ milli * sensorPlace (model, places, i).x(), std::to_string (i + 1) });

    return chart;
}
} // namespace

nlohmann::ordered_json sensorsToJson (const ModalModel& model, const SensorPlaces& places)
{
    nlohmann::ordered_json json { { "schema", "antinode.sensors/1" },
                                  { "device", places.device },
                                  { "focus", places.focus },
                                  { "candidates", places.cell.size() + places.idle.size() },
                                  { "sensors", nlohmann::json::array() },
                                  { "bits", places.choice.bits.back() },
                                  { "random_bits", places.randomBits } };

    for (std::size_t i = 0; i < places.choice.chosen.size(); ++i)
    {
        const Eigen::Vector2d place = milli * sensorPlace (model, places, i);
        auto& sensor = json["sensors"].emplace_back (
            nlohmann::ordered_json { { "x_mm", place.x() }, { "y_mm", place.y() }, { "bits", places.choice.bits[i] } });

        if (const auto ceramic = chosenCeramic (places, i); ceramic > 0)
            sensor["idle_ceramic"] = ceramic;
    }

    return json;
}

ReportPage sensorsReport (const ModalModel& model, const SensorPlaces& places)
{
    const auto isLine = model.surface.kind == SurfaceKind::line;
    constexpr int mapHeight = 480, curveHeight = 300;
    const std::string caption = "Information of one sensor alone, by its place; the chosen ones by number.";
    ReportSection section;
    section.heading = "Where to listen";
    section.paragraphs = {
        "A play of the focus gives information on the frequency, damping and participations of each mode: it reduces "
        "the volume of possible values by so many bits. Sensors on nodes give none, two at one antinode the same."
    };

    if (isLine)
        section.figures.push_back ({ caption, {}, sensorCurve (model, places), reportFigureWidth, curveHeight });
    else
        section.figures.push_back ({ caption, {}, sensorMap (model, places), reportFigureWidth, mapHeight });

    ReportTable table { "The sensors, the most informative first",
                        { "", "is", "x (mm)", "y (mm)", "together (bits)" },
                        {} };

    for (std::size_t i = 0; i < places.choice.chosen.size(); ++i)
    {
        const Eigen::Vector2d place = milli * sensorPlace (model, places, i);
        const auto ceramic = chosenCeramic (places, i);
        table.rows.push_back (
            { std::to_string (i + 1), ceramic > 0 ? "idle ceramic " + std::to_string (ceramic) : "a place",
              fixedText (place.x(), 2), fixedText (place.y(), 2), fixedText (places.choice.bits[i], 1) });
    }

    section.tables = { std::move (table) };
    ReportPage page;
    page.title = "Sensors on " + places.device;
    page.subtitle = "For " + places.focus;
    page.scores = { { "Information", fixedText (places.choice.bits.back(), 1) + " bits", "All sensors together." },
                    { "At random", fixedText (places.randomBits, 1) + " bits",
                      "The median of as many sensors at random places." } };
    page.sections = { std::move (section) };
    page.links = { { "sensors.csv", "sensors.csv" }, { "candidates.csv", "candidates.csv" } };
    page.footer = "Antinode " ANTINODE_VERSION ".";
    return page;
}

int chosenCeramic (const SensorPlaces& places, std::size_t rank)
{
    const auto candidate = static_cast<std::size_t> (places.choice.chosen[rank]);
    return candidate < places.cell.size() ? 0 : places.idle[candidate - places.cell.size()];
}

Eigen::Vector2d sensorPlace (const ModalModel& model, const SensorPlaces& places, std::size_t rank)
{
    if (const auto number = chosenCeramic (places, rank); number > 0)
    {
        const auto& ceramic = model.ceramics[static_cast<std::size_t> (number - 1)];
        return { (ceramic.xMinimum + ceramic.xMaximum) / 2, (ceramic.yMinimum + ceramic.yMaximum) / 2 };
    }

    return places.cells.centres.row (places.cell[static_cast<std::size_t> (places.choice.chosen[rank])]);
}

void writeSensors (const std::filesystem::path& path, const ModalModel& model, const SensorPlaces& places)
{
    OutputFolder folder (path);
    folder.write ("sensors.csv", sensorTable (model, places));
    folder.write ("candidates.csv", candidateTable (places));
    folder.write ("summary.json", sensorsToJson (model, places).dump (2) + "\n");
    folder.write ("report.html", renderReport (sensorsReport (model, places)));
    folder.commit();
}

namespace
{
/** The candidates: cells whose centres lie on the surface. */
SensorPlaces candidatesOn (const Surface& surface, int about)
{
    SensorPlaces places;
    places.cells = squareCells (surface, about);

    for (Eigen::Index c = 0; c < places.cells.centres.rows(); ++c)
        if (liesOn (surface, places.cells.centres (c, 0), places.cells.centres (c, 1)))
            places.cell.push_back (c);

    return places;
}

/** Rows of shapes as (shape over noise)^2. The noise is that which an average row has by its ratio. */
Eigen::MatrixXd overNoise (const Eigen::MatrixXd& shapes, const Eigen::MatrixXd& velocityGram, double signalToNoise)
{
    const auto meanSquare = (shapes * velocityGram).cwiseProduct (shapes).sum()
                            / static_cast<double> (std::max<Eigen::Index> (1, shapes.rows()));

    if (shapes.rows() > 0 && ! (meanSquare > 0))
        throw InputError ("focus", "moves no candidate; sensors would record nothing");

    constexpr double decibelsPerBel = 10;
    return shapes.cwiseAbs2() / (meanSquare * std::pow (10.0, -signalToNoise / decibelsPerBel));
}

/** candidates x N_m: places, then idle ceramics, whose currents are their participations by reciprocity. */
Eigen::MatrixXd audibilitiesOf (const ModalModel& model, const SensorPlaces& places, const PlayedVoltages& voltages,
                                double signalToNoise)
{
    const Eigen::MatrixX2d at = places.cells.centres (places.cell, Eigen::all);
    const auto velocities = modeVelocities (model, voltages, voltages.samples());
    const Eigen::MatrixXd gram = velocities.transpose() * velocities / static_cast<double> (voltages.samples());
    Eigen::MatrixXd currents (std::ssize (places.idle), model.modes());

    for (Eigen::Index i = 0; i < currents.rows(); ++i)
        currents.row (i) = model.participation.col (places.idle[static_cast<std::size_t> (i)] - 1).transpose();

    Eigen::MatrixXd result (at.rows() + currents.rows(), model.modes());
    result << overNoise (shapesAtPlaces (model, at), gram, signalToNoise), overNoise (currents, gram, signalToNoise);
    return result;
}

/** The median of what as many sensors at random candidates tell. */
double bitsAtRandom (const PlayedInformation& information, const Eigen::MatrixXd& audibilities, int count)
{
    constexpr int draws = 101;
    RandomNumbers random (1);
    std::vector<double> bits;
    bits.reserve (draws);

    for (int i = 0; i < draws; ++i)
    {
        Eigen::VectorXd sum = Eigen::VectorXd::Zero (audibilities.cols());

        for (int m = 0; m < count; ++m)
            sum += audibilities
                       .row (static_cast<Eigen::Index> (random.uniform() * static_cast<double> (audibilities.rows())))
                       .transpose();

        bits.push_back (informationBits (information, sum));
    }

    std::nth_element (bits.begin(), bits.begin() + draws / 2, bits.end());
    return bits[draws / 2];
}

void checkCount (int count, const SensorPlaces& places)
{
    const auto candidates = places.cell.size() + places.idle.size();

    if (count < 1 || static_cast<std::size_t> (count) > candidates)
        throw InputError ("--count", "is " + std::to_string (count) + "; allowed: 1 to " + std::to_string (candidates)
                                         + ", as many as there are candidates");
}
} // namespace

std::vector<Field> fields (SensorRequest& request)
{
    constexpr double percent = 100, milliseconds = 1000;
    const auto deviation = [&] (const char* option, double& value, const char* of)
    { return Field (option, &value, std::string ("Standard deviation of each ") + of).in (percent).within (0, 50); };
    return {
        focusField (request.focus),
        deviceOfFocusField (request.device),
        Field ("--count", &request.count, "How many sensors").within (1, 100),
        Field ("--idle-ceramic", &request.idleCeramics,
               "Ceramic that is not driven and may be one of the sensors, counted from 1 (repeatable)")
            .as ("idle_ceramics")
            .within (1, 4096),
        Field ("--candidates", &request.candidates, "Approximate number of compared places, in square cells")
            .within (1, 100000),
        deviation ("--frequency-percent", request.frequency, "frequency from the device, %"),
        deviation ("--damping-percent", request.damping, "damping ratio, %"),
        deviation ("--participation-percent", request.participation, "participation, %"),
        Field ("--snr-db", &request.signalToNoise, "Signal-to-noise ratio at an average place, dB")
            .as ("snr_dB")
            .within (-20, 300),
        sampleRateField (request.sampleRate),
        Field ("--duration-ms", &request.duration, "Length of the play, ms").in (milliseconds).within (1, 10000),
        cacheField (request.usesCache),
    };
}

SensorsOnDevice sensors (const SensorRequest& request, const ShowProgress& progress)
{
    const auto& focus = request.focus;
    const auto show = [&] (const char* what, double share)
    {
        if (progress)
            progress (what, share);
    };
    show ("Modes of the device", 0);
    const auto setup = setUp (request.device, { Reconstruction::bandLimited, request.sampleRate }, request.usesCache);
    auto known = setup.known;
    checkKindOfPlaces (known, focus);
    checkIdleCeramics (request.idleCeramics, known);
    auto places = candidatesOn (known.surface, request.candidates);
    places.device = known.name;
    places.focus = focus.name;
    places.idle = request.idleCeramics;
    checkCount (request.count, places);

    const auto& wide = setup.wide;
    auto driven = wide;
    driven.model = withoutDrive (wide.model, request.idleCeramics);
    const auto design = designWithin (driven, focus, setup.playback, DesignExtent::playable);
    const LearningSettings play { request.sampleRate, request.duration, 0 };
    const PlayedVoltages voltages (playedVoltages (known, design, play), request.sampleRate);
    const auto heard = modesWithin (wide.model, request.sampleRate);
    show ("What the play tells", 0.3);
    const auto information = playedInformation (
        heard, sameSpread (heard.modes(), request.frequency, request.damping, request.participation), voltages);
    show ("Choosing places", 0.9);
    const auto audibilities = audibilitiesOf (heard, places, voltages, request.signalToNoise);
    places.bits.resize (audibilities.rows());

    for (Eigen::Index c = 0; c < audibilities.rows(); ++c)
        places.bits[c] = informationBits (information, audibilities.row (c).transpose());

    places.choice = chooseSensors (information, audibilities, request.count);
    places.randomBits = bitsAtRandom (information, audibilities, request.count);
    return { std::move (known), std::move (places) };
}
} // namespace antinode
