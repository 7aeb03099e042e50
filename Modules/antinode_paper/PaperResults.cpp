#include "PaperResults.h"

#include "PaperTables.h"

#include <antinode_documents/FocusWords.h>
#include <antinode_focus/DesignFocus.h>

#include <nlohmann/json.hpp>

namespace antinode
{
namespace
{

/** An object with a list of five a shape. */
template <typename Value>
nlohmann::ordered_json byShape (const std::vector<PaperCell>& cells, Value&& value)
{
    nlohmann::ordered_json object;

    for (std::size_t row = 0; row < paperTables.size(); ++row)
        for (std::size_t place = 0; place < paperPlaces; ++place)
            object[std::string (paperTables[row].key)].push_back (value (cells[row * paperPlaces + place]));

    return object;
}

nlohmann::ordered_json printedTables()
{
    nlohmann::ordered_json captured, measured;

    for (const auto& row : paperTables)
    {
        captured[std::string (row.key)] = row.captured;

        if (row.vScore)
            measured[std::string (row.key)] = *row.vScore;
    }

    return { { "captured", captured }, { "v_score_measured", measured } };
}

/** Both drives for each growth. */
nlohmann::ordered_json drivesJson (const std::vector<PaperCell>& cells)
{
    nlohmann::ordered_json json;

    for (std::size_t i = 0; i < paperGrowths.size(); ++i)
    {
        nlohmann::ordered_json entry;
        entry["growth"] =
            paperGrowths[i] ? nlohmann::ordered_json (*paperGrowths[i]) : nlohmann::ordered_json ("chosen");
        entry["paper"] = byShape (cells, [i] (const PaperCell& cell) { return cell.drivePeaks[i].paper; });
        entry["offset_free"] = byShape (cells, [i] (const PaperCell& cell) { return cell.drivePeaks[i].offsetFree; });
        json.push_back (entry);
    }

    return json;
}

nlohmann::ordered_json twoModeJson (const TwoModeStudy& study)
{
    nlohmann::ordered_json json;
    json["ceramics"] = study.ceramics;
    json["frequencies_Hz"] = study.frequencies;

    for (const auto& one : study.cases)
    {
        nlohmann::ordered_json entry;
        entry["drive"] = wordFor (driveKindWords, one.drive);
        entry["voltage_limit_V"] = one.limit;
        entry["allocated"] = one.isAllocated;
        entry["met"] = one.result.has_value() && one.peakVoltage <= one.limit * (1 + 1e-9);

        if (one.result)
        {
            entry["peak_voltage_V"] = one.peakVoltage;
            entry["field_error"] = one.result->truncatedScore.fieldError;
        }
        else
        {
            entry["least_peak_voltage_V"] = one.minimumPeakVoltage;
            entry["reachable_velocity_mm_s"] = one.reachableVelocity * 1000;
        }

        json["cases"].push_back (entry);
    }

    return json;
}
} // namespace

nlohmann::ordered_json paperJson (const std::vector<PaperCell>& cells, const TwoModeStudy& study,
                                  const std::vector<PaperFigure>& figures)
{
    nlohmann::ordered_json json;
    json["print"] = printedTables();
    json["captured"] = byShape (cells, [] (const PaperCell& cell) { return cell.exact.design.captured; });
    json["modes_needed"] = byShape (cells, [] (const PaperCell& cell) { return cell.modesNeeded; });
    json["v_score"] = byShape (cells, [] (const PaperCell& cell) { return cell.exact.truncatedScore.vScore; });
    json["field_error"] = byShape (cells, [] (const PaperCell& cell) { return cell.exact.truncatedScore.fieldError; });
    json["v_score_paper"] = byShape (cells, [] (const PaperCell& cell) { return cell.paper.truncatedScore.vScore; });
    json["field_error_paper"] =
        byShape (cells, [] (const PaperCell& cell) { return cell.paper.truncatedScore.fieldError; });
    json["v_score_detuned"] = byShape (cells, [] (const PaperCell& cell) { return cell.detunedVScore[0]; });
    json["v_score_detuned_0.1_percent"] = byShape (cells, [] (const PaperCell& cell) { return cell.detunedVScore[1]; });
    json["v_score_detuned_0.5_percent"] = byShape (cells, [] (const PaperCell& cell) { return cell.detunedVScore[2]; });
    json["peak_voltage_V"] = byShape (cells, [] (const PaperCell& cell) { return peakVoltage (cell.exact.design); });
    json["peak_voltage_minimum_norm_V"] =
        byShape (cells, [] (const PaperCell& cell) { return cell.drivePeaks[0].offsetFree; });
    json["peak_voltage_by_drive_V"] = drivesJson (cells);
    json["lower_bound_voltage_V"] =
        byShape (cells, [] (const PaperCell& cell) { return cell.exact.design.lowerBoundVoltage; });
    json["lower_bound_gap"] = byShape (cells, [] (const PaperCell& cell) { return cell.exact.design.lowerBoundGap; });
    json["two_mode"] = twoModeJson (study);

    for (const auto& figure : figures)
        json["figures"].push_back (figure.name + ".png");

    return json;
}

ReportPage paperReport (const ModalModel& model, const std::vector<ReportTable>& tables,
                        std::vector<PaperFigure> figures)
{
    ReportPage page;
    page.title = "The paper, reproduced";
    page.subtitle = "Enferad et al., Journal of Sound and Vibration 449 (2019) 196-213, on '" + model.name + "'";
    ReportSection numbers { "The tables", {}, {}, tables };
    numbers.paragraphs = {
        "Our numbers are computed by the plate model from samples at 192 kHz; detuned plates are computed in closed "
        "form. The geometry of the device in print is inferred, so its measured numbers are a reference, not a target."
    };
    ReportSection pictures { "The figures", {}, {}, {} };

    for (auto& figure : figures)
        pictures.figures.push_back ({ figure.caption, {}, std::move (figure.chart), figure.width, figure.height });

    page.sections = { std::move (numbers), std::move (pictures) };
    page.links = { { "paper.json", "paper.json" } };
    page.footer = "Antinode " ANTINODE_VERSION;
    return page;
}
} // namespace antinode
