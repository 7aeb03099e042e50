#include "ToleranceFile.h"

#include "FileUnits.h"

#include <nlohmann/json.hpp>

namespace antinode
{
namespace
{
using Json = nlohmann::ordered_json;

Json scoreToJson (const FocusScore& score)
{
    return { { "v_score", score.vScore }, { "field_error", score.fieldError }, { "peak_ratio", score.peakRatio } };
}

Json causeToJson (const ToleranceCause& cause, const ModalModel& model)
{
    Json json { { "kind", wordFor (toleranceKindWords, cause.kind) } };

    if (cause.mode)
    {
        json["mode"] = *cause.mode + 1;
        json["frequency_Hz"] = model.frequencyHz (*cause.mode);
    }

    json["field_error"] = cause.fieldError;
    return json;
}

Json designToleranceToJson (const DesignTolerance& design, const ModalModel& model)
{
    const auto& tolerance = design.tolerance;
    Json json { { "design", design.name },
                { "peak_voltage_V", design.peakVoltage },
                { "as_known", scoreToJson (tolerance.known) },
                { "v_score", tolerance.vScore },
                { "field_error", tolerance.fieldError },
                { "peak_ratio", tolerance.peakRatio } };
    json["causes"] = Json::array();
    json["draws"] = Json::array();

    for (const auto& cause : tolerance.causes)
        json["causes"].push_back (causeToJson (cause, model));

    for (const auto& score : tolerance.draws)
        json["draws"].push_back (scoreToJson (score));

    return json;
}
} // namespace

nlohmann::ordered_json toleranceToJson (const ModalModel& model, const std::string& focus,
                                        const std::vector<DesignTolerance>& designs)
{
    const auto& options = designs.front().tolerance.options;
    Json json { { "schema", "antinode.tolerance/1" }, { "device", model.name }, { "focus", focus } };
    json["draws"] = options.draws;
    json["seed"] = options.seed;
    json["spread"] = { { "frequency_percent", toPercent (options.spread.frequency) },
                       { "damping_percent", toPercent (options.spread.damping) },
                       { "participation_percent", toPercent (options.spread.participation) },
                       { "drift_percent", toPercent (options.spread.drift) } };
    json["percentiles"] = tolerancePercents;
    json["designs"] = Json::array();

    for (const auto& design : designs)
        json["designs"].push_back (designToleranceToJson (design, model));

    return json;
}
} // namespace antinode
