#include <antinode_documents/ToleranceFile.h>

#include <nlohmann/json.hpp>

#include <catch2/catch.hpp>

using namespace antinode;

TEST_CASE ("A tolerance is written in percent and shares, with what hurts in its order", "[files]")
{
    ModalModel model;
    model.name = "device";
    model.angularFrequencies = Eigen::Vector2d (628.318530717958648, 6283.18530717958648);
    Tolerance tolerance;
    tolerance.options = { { 0.003, 0.2, 0.05, 0.001 }, 1, 9 };
    tolerance.draws = { FocusScore { { 0.99, 0.04 }, 1.01 } };
    tolerance.fieldError = { 0.01, 0.02, 0.03, 0.04, 0.05 };
    tolerance.causes = { { 1, ToleranceKind::damping, 0.02 }, { {}, ToleranceKind::drift, 0.01 } };
    const auto json = toleranceToJson (model, "focus", { { "nominal", 12.5, tolerance } });
    CHECK (json["device"] == "device");
    CHECK (json["focus"] == "focus");
    CHECK (json["seed"] == 9);
    CHECK (json["spread"]["frequency_percent"] == 0.3);
    CHECK (json["spread"]["damping_percent"] == 20);
    CHECK (json["percentiles"] == nlohmann::ordered_json { 5, 25, 50, 75, 95 });
    const auto& design = json["designs"][0];
    CHECK (design["peak_voltage_V"] == 12.5);
    CHECK (design["field_error"] == nlohmann::ordered_json { 0.01, 0.02, 0.03, 0.04, 0.05 });
    CHECK (design["draws"][0]["peak_ratio"] == 1.01);
    CHECK (design["causes"][0]["mode"] == 2);
    CHECK (design["causes"][0]["frequency_Hz"] == Approx (1000));
    CHECK (design["causes"][0]["kind"] == "damping");
    CHECK (design["causes"][1]["kind"] == "drift");
    CHECK_FALSE (design["causes"][1].contains ("mode"));
}
