#include "SensorsFiles.h"

#include <antinode_base/NumberText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_reports/PlateCharts.h>
#include <antinode_reports/Report.h>
#include <antinode_text/CsvText.h>
#include <antinode_text/OutputFolder.h>

#include <nlohmann/json.hpp>

#include <limits>

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
} // namespace antinode
