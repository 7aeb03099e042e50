#include "HysteresisFiles.h"

#include <antinode_tasks/Retune.h>

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>
#include <antinode_documents/ChangedDevice.h>
#include <antinode_documents/Library.h>
#include <antinode_text/OutputFolder.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>

namespace antinode
{
namespace
{
constexpr double percent = 100, degrees = 180 / std::numbers::pi;

void requireSame (const FrequencyResponses& low, const FrequencyResponses& high, const ModalModel& model)
{
    if (std::ssize (low.references) != model.actuators() || low.references.size() != high.references.size())
        throw InputError ("--high", "needs, as --low, responses to each of the " + std::to_string (model.actuators())
                                        + " ceramics of the device");

    if (low.points.rows() != high.points.rows() || ! low.points.isApprox (high.points))
        throw InputError ("--high", "has other points than --low; allowed: the same points in the same order");

    if (low.frequencies.size() != high.frequencies.size() || ! low.frequencies.isApprox (high.frequencies))
        throw InputError ("--high", "has other lines than --low; allowed: the same excitation at another level");
}

/** The values that both have, in one order. */
std::pair<Eigen::VectorXcd, Eigen::VectorXcd> inBoth (const Eigen::MatrixXcd& low, const Eigen::MatrixXcd& high)
{
    std::vector<Eigen::Index> there;

    for (Eigen::Index n = 0; n < low.size(); ++n)
        if (std::isfinite (std::abs (low.reshaped()[n])) && std::isfinite (std::abs (high.reshaped()[n])))
            there.push_back (n);

    return { low.reshaped() (there), high.reshaped() (there) };
}
} // namespace

HysteresisMeasurement hysteresisByFiles (const DeviceDescription& device, const HysteresisFiles& files, bool usesCache)
{
    HysteresisMeasurement measurement { device, solveDevice (device, {}, usesCache), {}, {}, {} };
    const auto& model = measurement.before;
    const auto low = responsesOfFiles (files.low).responses, high = responsesOfFiles (files.high).responses;
    requireSame (low, high, model);
    std::vector<Hysteresis> all;
    measurement.playedLevels.resize (model.actuators());

    for (std::size_t i = 0; i < low.references.size(); ++i)
    {
        const auto& ceramic = model.ceramics[i];
        const auto limit = ceramic.voltageLimit;

        if (files.playedLevel > limit)
            throw InputError ("--played-level-v", "is " + inWords (files.playedLevel)
                                                      + " V; allowed: up to the limit of '" + ceramic.name + "', "
                                                      + inWords (limit) + " V");

        const auto [lowValues, highValues] = inBoth (low.values[i], high.values[i]);
        measurement.ceramics.push_back (
            fitHysteresis (highValues, lowValues, files.highLevel / limit, files.lowLevel / limit));
        measurement.playedLevels[static_cast<Eigen::Index> (i)] = files.playedLevel / limit;
        all.push_back (measurement.ceramics.back().hysteresis);
    }

    measurement.model = withHysteresis (model, all, measurement.playedLevels);
    return measurement;
}

void writeHysteresis (const std::filesystem::path& path, const HysteresisMeasurement& measurement)
{
    nlohmann::ordered_json document { { "schema", "antinode.hysteresis/1" },
                                      { "device", measurement.model.name },
                                      { "ceramics", nlohmann::ordered_json::array() } };

    for (std::size_t i = 0; i < measurement.ceramics.size(); ++i)
    {
        const auto& [hysteresis, misfit] = measurement.ceramics[i];
        document["ceramics"].push_back (
            { { "ceramic", measurement.model.ceramics[i].name },
              { "gain_at_full_level_percent", percent * hysteresis.gain },
              { "lag_at_full_level_deg", degrees * hysteresis.phase },
              { "played_level_percent", percent * measurement.playedLevels[static_cast<Eigen::Index> (i)] },
              { "misfit_percent", percent * misfit } });
    }

    OutputFolder folder (path);
    folder.write ("device.json", changedDeviceText (measurement.device, measurement.before, measurement.model,
                                                    "With gain and lag of its ceramics at the played level"));
    folder.write ("hysteresis.json", document.dump (2) + "\n");
    folder.commit();
}

void printHysteresis (const std::string& folder, const HysteresisMeasurement& measurement)
{
    std::printf ("%s\n  %-12s %20s %18s %18s %14s\n", measurement.model.name.c_str(), "ceramic", "full level adds (%)",
                 "and lags (deg)", "played level (%)", "not fitted (%)");

    for (std::size_t i = 0; i < measurement.ceramics.size(); ++i)
    {
        const auto& [hysteresis, misfit] = measurement.ceramics[i];
        std::printf ("  %-12s %20.3f %18.3f %18.1f %14.3f\n", measurement.model.ceramics[i].name.c_str(),
                     percent * hysteresis.gain, degrees * hysteresis.phase,
                     percent * measurement.playedLevels[static_cast<Eigen::Index> (i)], percent * misfit);
    }

    std::printf ("The device at the played level: %s/device.json; numbers: %s/hysteresis.json\n", folder.c_str(),
                 folder.c_str());
}
} // namespace antinode
