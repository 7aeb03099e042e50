#include "Support/SineBeam.h"

#include <antinode_documents/DeviceFile.h>
#include <antinode_documents/MeasuredDevice.h>

#include <nlohmann/json.hpp>

#include <catch2/catch.hpp>

#include <limits>
#include <numbers>

using namespace antinode;
using namespace antinode::test;

namespace
{
/** The modes of a model with deviations of a millionth in frequency. */
IdentifiedModes toIdentifiedModes (const ModalModel& model)
{
    IdentifiedModes modes;
    modes.delay = 1.07e-5;
    modes.deviations.angularFrequencies = 1e-6 * model.angularFrequencies;
    modes.deviations.dampingRatios = Eigen::VectorXd::Constant (model.modes(), 1e-5);
    modes.deviations.participation = 1e-3 * model.participation.cwiseAbs();
    return modes;
}
} // namespace

TEST_CASE ("An identified device keeps its standard deviations and its delay, and is read as any other", "[files]")
{
    const auto model = sineBeam (3, 2);
    const auto device = identifiedDeviceToJson (model, toIdentifiedModes (model), "measured");
    CHECK (device["delay_s"] == 1.07e-5);
    CHECK (device["modes"][2]["frequency_standard_deviation_Hz"].get<double>()
           == Approx (1e-6 * model.angularFrequencies[2] / (2 * std::numbers::pi)));
    CHECK (device["modes"][1]["damping_ratio_standard_deviation"] == 1e-5);
    CHECK (device["modes"][0]["participation_standard_deviation_per_V"][1].get<double>()
           == 1e-3 * std::abs (model.participation (0, 1)));
    const auto read = std::get<ModalModel> (readDevice (nlohmann::json (device), "device").body);
    CHECK (read.angularFrequencies == model.angularFrequencies);
    CHECK (read.participation == model.participation);
}

TEST_CASE ("Deviations that are not known are left out", "[files]")
{
    const auto model = sineBeam (3, 2);
    auto modes = toIdentifiedModes (model);
    modes.deviations.angularFrequencies[1] = std::numeric_limits<double>::infinity();
    modes.deviations.dampingRatios.resize (0);
    const auto device = identifiedDeviceToJson (model, modes, "measured");
    CHECK_FALSE (device["modes"][0].contains ("frequency_standard_deviation_Hz"));
    CHECK_FALSE (device["modes"][0].contains ("damping_ratio_standard_deviation"));
    CHECK (device["modes"][0].contains ("participation_standard_deviation_per_V"));
}

TEST_CASE ("A device may be known at one point alone, as after one hammer and one accelerometer", "[files]")
{
    const auto device = nlohmann::json::parse (R"({ "schema": "antinode.device/1", "name": "one", "kind": "modal",
        "limits": { "voltage_V": 10 }, "points_mm": [[0, 0]], "weights_kg": [1],
        "modes": [{ "frequency_Hz": 100, "damping_ratio": 0.01, "participation_per_V": [0.5], "shape": [1] }] })");
    const auto model = std::get<ModalModel> (readDevice (device, "one.json").body);
    CHECK (model.points() == 1);
    CHECK (shapesAt (model, 0, 0)[0] == 1);
}
