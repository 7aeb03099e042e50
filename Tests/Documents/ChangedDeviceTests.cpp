#include "Support/ErrorText.h"
#include "Support/GoodFiles.h"

#include <antinode_documents/DeviceFile.h>
#include <antinode_documents/MeasuredDevice.h>
#include <antinode_text/JsonText.h>

#include <catch2/catch.hpp>

#include <random>

using namespace antinode;

namespace
{
constexpr auto changeInWords = "Changed by a test";

/** Every device of the good files, its limits with every key that its kind may have. */
std::vector<nlohmann::json> everyDevice()
{
    std::vector<nlohmann::json> devices;

    for (const auto& file : goodFiles())
    {
        if (file.isFocus)
            continue;

        auto device = parseJson (file.text, "my.json");
        device["limits"]["requires_arming"] = true;
        device["limits"]["slew_V_per_us"] = 20;
        devices.push_back (device);
    }

    return devices;
}

/** What commands change of a device: modes that drift past each other, gains, limits and lags of amplifiers. */
ModalModel changedByCommands (ModalModel model)
{
    const auto last = model.modes() - 1;
    model.angularFrequencies *= 1.01;
    model.dampingRatios *= 0.9;
    model.participation *= 1.03;

    for (auto& ceramic : model.ceramics)
    {
        ceramic.voltageLimit /= 1.03;
        ceramic.slewLimit /= 1.03;
        ceramic.lag = { 3e-6, 5e-6, 0.02 };
    }

    if (last > 0)
    {
        // As after a sort: the last two modes have changed places.
        const auto swap = [&] (auto&& matrix, Eigen::Index one, Eigen::Index other)
        { matrix.col (one).swap (matrix.col (other)); };
        swap (model.shapes, last, last - 1);
        swap (model.participation.transpose(), last, last - 1);

        if (model.slopes.size() > 0)
            swap (model.slopes, last, last - 1);
    }

    return model;
}

DeviceDescription deviceReadBack (const std::string& text)
{
    return readDevice (parseJson (text, "changed.json"), "changed.json");
}

void checkReadAsWritten (const ModalModel& read, const ModalModel& written)
{
    constexpr double rounding = 1e-15;
    CHECK (read.name == written.name);
    CHECK (read.angularFrequencies.isApprox (written.angularFrequencies, rounding));
    CHECK (read.dampingRatios == written.dampingRatios);
    CHECK (read.shapes == written.shapes);
    CHECK (read.slopes.reshaped() == written.slopes.reshaped());
    CHECK (read.participation == written.participation);
    CHECK (read.fullScaleVoltage == written.fullScaleVoltage);
    CHECK (read.surface.points == written.surface.points);
    REQUIRE (read.ceramics.size() == written.ceramics.size());

    for (std::size_t i = 0; i < read.ceramics.size(); ++i)
    {
        const auto &one = read.ceramics[i], &other = written.ceramics[i];
        CHECK (one.name == other.name);
        CHECK (one.voltageLimit == other.voltageLimit);
        CHECK (one.slewLimit == Approx (other.slewLimit).epsilon (rounding));
        CHECK (one.capacitance == other.capacitance);
        CHECK (one.lossFactor == other.lossFactor);
        CHECK (one.xMinimum == other.xMinimum);
        CHECK (one.yMaximum == other.yMaximum);
        CHECK (one.lag.delay == Approx (other.lag.delay).epsilon (rounding));
        CHECK (one.lag.timeConstant == Approx (other.lag.timeConstant).epsilon (rounding));
        CHECK (one.lag.angle == Approx (other.lag.angle).epsilon (rounding));
    }
}

/** Of a ceramic all that no command measures. */
nlohmann::json unmeasured (nlohmann::json ceramic)
{
    for (const auto* const key : { "voltage_limit_V", "slew_limit_V_per_us", "lag" })
        ceramic.erase (key);

    return ceramic;
}
} // namespace

TEST_CASE ("What a device's file says survives what commands change of it, every key of every kind", "[files]")
{
    for (const auto& document : everyDevice())
    {
        INFO (document.dump());
        const auto device = readDevice (document, "my.json");
        const auto before = solveStructure (device);
        const auto changed =
            parseJson (changedDeviceText (device, before, changedByCommands (before), changeInWords), "changed.json");
        const auto isModal = document.value ("kind", "") == "modal";
        const auto& drawing = document.contains ("base") ? document["base"] : document;
        CHECK (readDevice (changed, "changed.json").requiresArming);
        CHECK (changed["name"] == document["name"]);
        CHECK (changed["description"].get<std::string>().starts_with (document.value ("description", changeInWords)));

        for (const auto& [key, value] : document["limits"].items())
            CHECK (changed["limits"][key] == value);

        if (isModal)
            for (std::size_t i = 0; i < document.value ("ceramics", nlohmann::json::array()).size(); ++i)
            {
                const auto kept = unmeasured (document["ceramics"][i]);

                for (const auto& [key, value] : kept.items())
                    CHECK (changed["ceramics"][i][key] == value);
            }
        else
            for (const auto& [key, value] : drawing.items())
                if (key != "schema" && key != "name" && key != "description" && key != "limits")
                    CHECK (changed["base"][key] == value);
    }
}

TEST_CASE ("A device that was changed is read as it was written, and may be changed again", "[files]")
{
    for (const auto& document : everyDevice())
    {
        INFO (document.dump());
        auto device = readDevice (document, "my.json");
        auto model = solveStructure (device);

        for (int time = 0; time < 2; ++time)
        {
            const auto now = changedByCommands (model);
            device = deviceReadBack (changedDeviceText (device, model, now, changeInWords));
            model = solveStructure (device);
            checkReadAsWritten (model, now);
        }

        CHECK (device.description.find (changeInWords) == device.description.rfind (changeInWords));
    }
}

TEST_CASE ("A drawn device with measured modes takes some kilobytes, however many points it has", "[files]")
{
    for (const auto& file : goodFiles())
        if (file.name == "minimal plate")
        {
            auto document = parseJson (file.text, "my.json");
            document["modes"]["count"] = 40;
            const auto device = readDevice (document, "my.json");
            const auto model = solveStructure (device);
            REQUIRE (model.points() > 500);
            CHECK (changedDeviceText (device, model, changedByCommands (model), changeInWords).size() < 20000);
        }
}

TEST_CASE ("Modes of a drawing keep their sign where a solution has the other one", "[files]")
{
    for (const auto& file : goodFiles())
        if (file.name == "beam")
        {
            const auto device = readDevice (parseJson (file.text, "my.json"), "my.json");
            const auto before = solveStructure (device);
            auto changed = parseJson (changedDeviceText (device, before, changedByCommands (before), changeInWords),
                                      "changed.json");
            auto& mode = changed["modes"][0];
            mode["base_sign"]["participation_per_V"] = -mode["base_sign"]["participation_per_V"].get<double>();
            const auto turned = readDevice (changed, "changed.json");
            const auto model = solveStructure (turned);
            CHECK (model.participation (0, 0) == -mode["participation_per_V"][0].get<double>());

            // It is so, too, once it is written for that sign.
            const auto again = deviceReadBack (changedDeviceText (turned, model, model, changeInWords));
            CHECK (solveStructure (again).participation == model.participation);
        }
}

TEST_CASE ("Modes that are mixtures of a drawing's modes stay so, and may be mixed again", "[files]")
{
    const auto mixed = [] (ModalModel model, Eigen::Index k, double share)
    {
        const Eigen::MatrixXd pair = model.shapes.middleCols (k, 2);
        model.shapes.col (k) += share * pair.col (1);
        model.shapes.col (k + 1) -= share * pair.col (0);
        return model;
    };

    for (const auto& file : goodFiles())
        if (file.name == "beam")
        {
            const auto device = readDevice (parseJson (file.text, "my.json"), "my.json");
            const auto before = solveStructure (device);
            const auto once = mixed (before, 1, 0.05);
            const auto text = changedDeviceText (device, before, once, changeInWords);
            const auto read = deviceReadBack (text);
            const auto model = solveStructure (read);
            CHECK ((model.shapes - once.shapes).norm() < 1e-9 * once.shapes.norm());
            CHECK (text.size() < 20000);

            const auto twice = mixed (model, 2, -0.03);
            const auto again = solveStructure (deviceReadBack (changedDeviceText (read, model, twice, changeInWords)));
            CHECK ((again.shapes - twice.shapes).norm() < 1e-9 * twice.shapes.norm());

            // A solution that turns mode 3 over has the same device.
            auto turned = parseJson (text, "changed.json");
            auto& sign = turned["modes"][2]["base_sign"]["participation_per_V"];
            sign = -sign.get<double>();
            const auto other = solveStructure (readDevice (turned, "changed.json"));
            CHECK ((other.shapes.col (1) - once.shapes.col (1) + 0.1 * before.shapes.col (2)).norm() < 1e-6);

            turned["modes"][1]["base_shares"][0]["base_mode"] = 900;
            CHECK_THROWS_WITH (solveStructure (readDevice (turned, "changed.json")),
                               Catch::Contains ("has a share of mode 900 of its base, which it does not list"));
        }
}

TEST_CASE ("Large sets of shapes are written compactly, to seven digits", "[files]")
{
    constexpr Eigen::Index modes = 150, points = 900;
    std::mt19937 random (3);
    std::uniform_real_distribution<double> number (-1, 1);
    ModalModel model;
    model.name = "scanned";
    model.angularFrequencies = Eigen::VectorXd::LinSpaced (modes, 1e3, 1e5);
    model.dampingRatios = Eigen::VectorXd::Constant (modes, 0.01);
    model.shapes = Eigen::MatrixXd::NullaryExpr (points, modes, [&] { return number (random); });
    model.participation = Eigen::MatrixXd::Ones (modes, 1);
    model.coversWholeBody = false;
    model.surface.kind = SurfaceKind::plate;
    model.surface.points.resize (points, 2);

    for (Eigen::Index p = 0; p < points; ++p)
        model.surface.points.row (p) << 1e-3 * static_cast<double> (p % 30), 1e-3 * static_cast<double> (p / 30);

    model.surface.xMaximum = model.surface.yMaximum = 0.029;
    model.surface.masses = model.surface.areas = Eigen::VectorXd::Ones (points);
    model.ceramics = { { "C1", 0, 0.01, 0, 0.01, 100 } };
    const auto text = deviceText (modalDeviceToJson (model, ""));
    CHECK (text.size() < 6 * modes * points);
    const auto read = std::get<ModalModel> (deviceReadBack (text).body);
    CHECK ((read.shapes - model.shapes).cwiseAbs().maxCoeff() < 1e-7);
    CHECK (read.angularFrequencies == model.angularFrequencies);

    auto broken = parseJson (text, "scanned.json");
    broken["modes"][2]["shape"] = "AAAA";
    CHECK (errorText ([&] { readDevice (broken, "scanned.json"); })
           == "scanned.json: /modes/2/shape: is no text of 900 numbers of 4 bytes; allowed: base64 of finite "
              "little-endian numbers of 4 bytes, or a list");
}

TEST_CASE ("What could not be read is not written", "[files]")
{
    for (const auto& file : goodFiles())
        if (file.name == "modal" || file.name == "beam")
        {
            const auto device = readDevice (parseJson (file.text, "my.json"), "my.json");
            const auto before = solveStructure (device);
            auto now = before;
            now.dampingRatios[0] = 1.5;
            const auto message = errorText ([&] { changedDeviceText (device, before, now, changeInWords); });
            CHECK_THAT (message, Catch::StartsWith ("the device is not written, since it could not be read: device '"));
            CHECK_THAT (message, Catch::Contains ("/damping_ratio: is 1.5"));
        }
}

TEST_CASE ("A base says what is drawn, the device all else", "[files]")
{
    const auto errorAfter = [] (const std::string& assignment)
    {
        for (const auto& file : goodFiles())
            if (file.name == "measured")
            {
                auto document = parseJson (file.text, "my.json");
                applyAssignment (document, assignment);
                return errorText ([&] { solveStructure (readDevice (document, "my.json")); });
            }

        return std::string();
    };
    CHECK (errorAfter ("base.limits={\"voltage_V\": 500}")
           == "my.json: /base/limits: is in the base; allowed: in the device that has the base");
    CHECK_THAT (errorAfter ("base.kind=modal"),
                Catch::StartsWith ("my.json: /base/kind: is the text 'modal'; allowed: "));
    CHECK (errorAfter ("modes.1.base_mode=2")
           == "my.json: /modes/1/base_mode: is given to two modes; allowed: a mode of the base once");
    CHECK_THAT (errorAfter ("modes.1.base_mode=9"), Catch::StartsWith ("device 'tuned': has measured mode 9 of its "));
    CHECK (errorAfter ("ceramics.0.voltage_limit_V=121")
           == "my.json: /ceramics/0/voltage_limit_V: is 121; allowed: 0 to 120");
    CHECK (errorAfter ("modes.0.participation_per_V=[1, 2]")
           == "my.json: /modes/0/participation_per_V: has 2 entries; allowed: a list of 1");
}
