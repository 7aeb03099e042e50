#include "Support/ErrorText.h"
#include "Support/GoodFiles.h"
#include "Support/ViscousChain.h"

#include <antinode_documents/DeviceFile.h>
#include <antinode_text/JsonText.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <random>

using namespace antinode;

namespace
{
nlohmann::json goodModal()
{
    for (const auto& file : goodFiles())
        if (file.name == "modal")
            return parseJson (file.text, "modal");

    throw InputError ("modal", "is not among the good files");
}

ModalModel readModel (const nlohmann::json& document)
{
    return std::get<ModalModel> (readDevice (document, "my.json").body);
}

/** Through text and back, as a file would go. */
ModalModel modalFileReadBack (const ModalModel& model)
{
    return readModel (parseJson (modalDeviceToJson (model, "a test").dump (2), "my.json"));
}

std::string errorOfModalFile (std::string_view assignment)
{
    auto document = goodModal();
    applyAssignment (document, assignment);
    return errorText ([&] { readModel (document); });
}

/** A model with numbers that no unit of the file makes rounder. */
ModalModel irregularModel (SurfaceKind kind)
{
    constexpr Eigen::Index modes = 30, points = 40, ceramics = 5;
    std::mt19937 random (7);
    std::uniform_real_distribution<double> number (0.1, 1.0);
    const auto next = [&] { return number (random); };

    ModalModel model;
    model.name = "irregular";
    model.angularFrequencies = Eigen::VectorXd::NullaryExpr (modes, [&] { return 1e5 * next(); });
    std::sort (model.angularFrequencies.begin(), model.angularFrequencies.end());
    model.dampingRatios = Eigen::VectorXd::NullaryExpr (modes, [&] { return 0.1 * next(); });
    model.shapes = Eigen::MatrixXd::NullaryExpr (points, modes, next);
    model.participation = Eigen::MatrixXd::NullaryExpr (modes, ceramics, next);
    model.staticShare = Eigen::MatrixXd::NullaryExpr (points, ceramics, next) * 1e-9;
    model.frequencyErrors = Eigen::VectorXd::NullaryExpr (modes, next);
    model.fullScaleVoltage = 200;
    model.rigidBodyModes = 2;

    auto& surface = model.surface;
    surface.kind = kind;
    surface.points = Eigen::MatrixX2d::NullaryExpr (points, 2, next);
    surface.masses = Eigen::VectorXd::NullaryExpr (points, next);
    surface.areas = Eigen::VectorXd::NullaryExpr (points, next);
    surface.xMinimum = 0.01 / 3;
    surface.xMaximum = 1.1;
    surface.yMaximum = 1.1;

    if (kind == SurfaceKind::line)
    {
        surface.points.col (1).setZero();
        std::sort (surface.points.col (0).begin(), surface.points.col (0).end());
        surface.yMaximum = 0;
        model.slopes = Eigen::MatrixXd::NullaryExpr (points, modes, next);
    }

    for (Eigen::Index i = 0; i < ceramics; ++i)
        model.ceramics.push_back ({ "C" + std::to_string (i), next(), 1 + next(), 0, next() / 3, i == 2 ? 70.0 : 150.0,
                                    0, (1 + next()) / 1e9, 0.1 * next() });

    return model;
}

void checkSame (const ModalModel& a, const ModalModel& b)
{
    CHECK (a.name == b.name);
    CHECK (a.angularFrequencies == b.angularFrequencies);
    CHECK (a.dampingRatios == b.dampingRatios);
    CHECK (a.shapes == b.shapes);
    CHECK (a.slopes.rows() == b.slopes.rows());
    CHECK (a.slopes.reshaped() == b.slopes.reshaped());
    CHECK (a.participation == b.participation);
    CHECK (a.staticShare == b.staticShare);
    CHECK (a.frequencyErrors == b.frequencyErrors);
    CHECK (a.fullScaleVoltage == b.fullScaleVoltage);
    CHECK (a.coversWholeBody == b.coversWholeBody);
    CHECK (a.rigidBodyModes == b.rigidBodyModes);
    CHECK (a.surface.kind == b.surface.kind);
    CHECK (a.surface.points == b.surface.points);
    CHECK (a.surface.masses == b.surface.masses);
    CHECK (a.surface.areas == b.surface.areas);
    CHECK (std::pair (a.surface.xMinimum, a.surface.xMaximum) == std::pair (b.surface.xMinimum, b.surface.xMaximum));
    CHECK (std::pair (a.surface.yMinimum, a.surface.yMaximum) == std::pair (b.surface.yMinimum, b.surface.yMaximum));
    REQUIRE (a.ceramics.size() == b.ceramics.size());

    for (std::size_t i = 0; i < a.ceramics.size(); ++i)
    {
        CHECK (a.ceramics[i].name == b.ceramics[i].name);
        CHECK (a.ceramics[i].voltageLimit == b.ceramics[i].voltageLimit);
        CHECK (a.ceramics[i].capacitance == b.ceramics[i].capacitance);
        CHECK (a.ceramics[i].lossFactor == b.ceramics[i].lossFactor);
        CHECK (std::pair (a.ceramics[i].xMinimum, a.ceramics[i].xMaximum)
               == std::pair (b.ceramics[i].xMinimum, b.ceramics[i].xMaximum));
        CHECK (std::pair (a.ceramics[i].yMinimum, a.ceramics[i].yMaximum)
               == std::pair (b.ceramics[i].yMinimum, b.ceramics[i].yMaximum));
    }
}
} // namespace

TEST_CASE ("A modal device holds its modes in ascending frequency", "[files]")
{
    const auto model = readModel (goodModal());
    CHECK (model.name == "measured");
    CHECK (model.angularFrequencies[0] == 2 * std::numbers::pi * 420);
    CHECK (model.angularFrequencies[1] == 2 * std::numbers::pi * 900);
    CHECK (model.dampingRatios == Eigen::Vector2d (0.003, 1 / 80.0));
    CHECK (model.shapes.col (0) == Eigen::Vector3d (1, 2, 3));
    CHECK (model.shapes.col (1) == Eigen::Vector3d (1, 0, -1));
    CHECK (model.slopes.col (1) == Eigen::Vector3d (0, -2, 0));
    CHECK (model.participation.row (1) == Eigen::RowVector2d (0.1, -0.2));
    CHECK (model.frequencyErrors == Eigen::Vector2d (2e-6, 1e-6));
    CHECK (model.rigidBodyModes == 2);
    CHECK (model.surface.kind == SurfaceKind::line);
    CHECK (model.surface.xMinimum == -0.05);
    CHECK (model.surface.xMaximum == 0.04);
    CHECK (model.ceramics[0].name == "left");
    CHECK (model.ceramics[0].voltageLimit == 100);
    CHECK (model.ceramics[0].capacitance == 2.9e-9);
    CHECK (model.ceramics[0].lossFactor == 0.03);
    CHECK (model.ceramics[0].area == Approx (45e-6));
    CHECK (model.ceramics[1].capacitance == 0);
    CHECK (model.ceramics[1].lossFactor == 0.02);
    CHECK (model.ceramics[0].xMaximum == -0.021);
    CHECK (model.ceramics[1].name == "C2");
    CHECK (model.ceramics[1].voltageLimit == 120);
    CHECK (model.fullScaleVoltage == 150);
}

TEST_CASE ("Points of a line are sorted with their shapes and weights", "[files]")
{
    const auto sorted = readModel (goodModal());
    auto document = goodModal();
    applyAssignment (document, "points_mm=[[40, 7], [-50, 7], [0, 7]]");
    applyAssignment (document, "weights_kg=[0.001, 0.001, 0.002]");
    applyAssignment (document, "areas_m2=[1, 1, 2]");
    applyAssignment (document, "modes.0.shape=[-1, 1, 0]");
    applyAssignment (document, "modes.1.shape=[3, 1, 2]");
    applyAssignment (document, "modes.0.slope=[0, 0, -2]");
    checkSame (readModel (document), sorted);
}

TEST_CASE ("What a modal device leaves out follows from the rest", "[files]")
{
    auto document = goodModal();

    for (const auto* const key : { "ceramics", "areas_m2", "covers_whole_body" })
        document.erase (key);

    for (auto& mode : document["modes"])
        mode.erase ("slope");

    const auto model = readModel (document);
    CHECK (model.ceramics[0].name == "C1");
    CHECK (model.ceramics[0].voltageLimit == 120);
    CHECK (model.surface.areas.isApprox (Eigen::Vector3d (0.025, 0.045, 0.02), 1e-14));
    CHECK_FALSE (model.coversWholeBody);
    REQUIRE (model.slopes.rows() == 3);
    CHECK (model.slopes (1, 0)
           == Approx ((1 / 0.05 * 0.04 + 1 / 0.04 * 0.05) / 0.09)); // Natural cubic spline, by hand.
}

TEST_CASE ("Points whose weights make the shapes orthonormal stand for the whole body", "[files]")
{
    auto document = goodModal();
    document.erase ("covers_whole_body");
    document["weights_kg"] = { 1, 2, 1 };
    const auto scale = 1 / std::sqrt (2.0);
    document["modes"][0]["shape"] = { scale, 0, -scale };
    document["modes"][1]["shape"] = { 0.5, 0.5, 0.5 };
    CHECK (readModel (document).coversWholeBody);
    document["modes"][1]["shape"] = { 0.55, 0.5, 0.5 };
    CHECK_FALSE (readModel (document).coversWholeBody);
}

TEST_CASE ("A modal device written and read again is the same to the bit", "[files]")
{
    const auto read = readModel (goodModal());
    checkSame (modalFileReadBack (read), read);

    for (const auto kind : { SurfaceKind::line, SurfaceKind::plate })
    {
        const auto model = irregularModel (kind);
        checkSame (modalFileReadBack (model), model);
    }
}

TEST_CASE ("A modal device is written in people's numbers where there are such", "[files]")
{
    const auto written = modalDeviceToJson (readModel (goodModal()), "a test");
    CHECK (written["description"] == "a test");
    CHECK (written["modes"][0]["frequency_Hz"].dump() == "420.0");
    CHECK (written["points_mm"].dump() == "[[-50.0,0.0],[0.0,0.0],[40.0,0.0]]");
    CHECK (written["ceramics"][0]["x_mm"].dump() == "-30.0");
    CHECK (written["ceramics"][0]["size_x_mm"].dump() == "9.0");
}

TEST_CASE ("Modal devices whose parts do not fit together are refused", "[files]")
{
    CHECK (errorOfModalFile ("modes.0.shape=[1, 2]") == "my.json: /modes/0/shape: has 2 entries; allowed: a list of 3");
    CHECK (errorOfModalFile ("modes.1.participation_per_V=[1]")
           == "my.json: /modes/1/participation_per_V: has 1 entries; allowed: a list of 2");
    CHECK (errorOfModalFile ("weights_kg=[0, 0, 0]")
           == "my.json: /weights_kg: is zero everywhere; allowed: at least one number above 0");
    CHECK (errorOfModalFile ("ceramics=[]") == "my.json: /ceramics: has 0 entries; allowed: a list of 2");
    CHECK (errorOfModalFile ("ceramics.0.voltage_limit_V=121")
           == "my.json: /ceramics/0/voltage_limit_V: is 121; allowed: 0 to 120");
    CHECK (errorOfModalFile ("points_mm.2=[0, 0]")
           == "my.json: /points_mm: has entries 1 and 2 at the same position; allowed on a line: distinct positions");
    CHECK (errorOfModalFile ("points_mm.2=[40, 1]")
           == "my.json: /modes/0/slope: is given for a plate; allowed only on a line (all points with the same y)");
    CHECK (errorOfModalFile ("modes.2={\"frequency_Hz\": 5}")
           == "my.json: /modes/2: has no 'slope'; allowed: for all modes or none");
}

TEST_CASE ("Exact numbers that contradict the keys with units are refused", "[files]")
{
    auto document = parseJson (modalDeviceToJson (readModel (goodModal()), {}).dump(), "my.json");
    CHECK (readModel (document).points() == 3);
    applyAssignment (document, "points_mm.2.0=41");
    CHECK (errorText ([&] { readModel (document); })
           == "my.json: /exact/points_m/2/0: is 0.04; allowed: 0.041 as in the key with the unit; a file that is "
              "edited by hand "
              "should omit 'exact'");
}

TEST_CASE ("Complex modes go through a file to the bit, and real ones have no imaginary parts in it",
           "[files][complex]")
{
    const auto model = test::complexModel (test::viscousChain (8, 3, 40));
    const auto read = modalFileReadBack (model);
    CHECK (read.hasComplexModes());
    checkSame (model, read);
    CHECK (read.slopes == model.slopes);

    const auto text = modalDeviceToJson (irregularModel (SurfaceKind::line), {}).dump();
    CHECK (text.find ("imaginary") == std::string::npos);
}

TEST_CASE ("Imaginary parts are given for every mode and quantity or for none", "[files][complex]")
{
    const auto complexDevice = []
    { return modalDeviceToJson (test::complexModel (test::viscousChain (8, 3, 40)), {}); };
    const auto errorAfter = [&] (const auto& change)
    {
        nlohmann::json document = complexDevice();
        change (document);
        return errorText ([&] { readModel (document); });
    };
    CHECK_THAT (errorAfter ([] (auto& d) { d["modes"][2].erase ("shape_imaginary"); }),
                Catch::Contains ("allowed: for all modes or none"));
    CHECK_THAT (errorAfter (
                    [] (auto& d)
                    {
                        for (auto& mode : d["modes"])
                            mode.erase ("participation_imaginary_per_V");
                    }),
                Catch::Contains ("allowed: both or none"));
    CHECK_THAT (errorAfter (
                    [] (auto& d)
                    {
                        for (auto& mode : d["modes"])
                            mode.erase ("slope_imaginary");
                    }),
                Catch::Contains ("allowed: the imaginary part of every quantity or of none"));
    CHECK_THAT (errorAfter ([] (auto& d) { d["covers_whole_body"] = true; }),
                Catch::Contains ("not orthogonal; allowed: false"));
    CHECK_THAT (errorAfter ([] (auto& d) { d["modes"][0]["shape_imaginary"].erase (0); }),
                Catch::Contains ("shape_imaginary"));
}

TEST_CASE ("What ceramics do later than they are asked for is kept by a file")
{
    auto model = irregularModel (SurfaceKind::plate);
    model.ceramics[1].lag = { 12.3e-6, 31.8e-6, 0.05 };
    const auto lag = modalFileReadBack (model).ceramics[1].lag;
    CHECK (lag.delay == model.ceramics[1].lag.delay);
    CHECK (lag.timeConstant == model.ceramics[1].lag.timeConstant);
    CHECK (lag.angle == Approx (0.05).epsilon (1e-15));
    CHECK (modalFileReadBack (model).ceramics[0].lag == InputLag {});
    CHECK (errorOfModalFile (R"(ceramics.0.lag={"delay_us": 20000})")
           == "my.json: /ceramics/0/lag/delay_us: is 20000; allowed: 0 to 10000");
}
