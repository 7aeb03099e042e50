#include "RecordedPasses.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_base/WholeFile.h>
#include <antinode_text/CsvTable.h>
#include <antinode_text/WaveReader.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>

namespace antinode
{
namespace
{
constexpr double sameRate = 1e-3; // times may be rounded

/** The sample of the trigger, from the summary of a pass. */
double triggerSample (const std::filesystem::path& path)
{
    const auto json = nlohmann::json::parse (readWholeFile (path, { "a JSON file" }), nullptr, false);

    if (! json.is_object() || ! json.contains ("trigger_sample") || ! json["trigger_sample"].is_number())
        throw InputError (path.string(), "has no \"trigger_sample\"; allowed: summary.json of antinode perform");

    return json["trigger_sample"].get<double>();
}

/** The columns of a table but the time, points x samples, m. */
Eigen::MatrixXd recordedTable (const std::filesystem::path& path, double sampleRate, TrackBand band)
{
    const auto table = readCsvTable (readWholeFile (path, { "a CSV file" }), path.string());
    const auto all = [&] (const char* unit)
    {
        for (std::size_t i = 1; i < table.headings.size(); ++i)
            if (table.headings[i].find (unit) == std::string::npos)
                return false;

        return table.headings.size() > 1;
    };
    const auto isDisplacement = all ("_um");

    if (! isDisplacement && ! all ("_mm_s"))
        throw InputError (path.string(),
                          "does not say what it has; allowed: headings time_s and then displacement_um_1 "
                          "or velocity_mm_s_1 and so on");

    const auto last = table.numbers.rows() - 1;

    if (const auto span = table.numbers (last, 0) - table.numbers (0, 0);
        last > 0 && ! (std::abs (span * sampleRate / static_cast<double> (last) - 1) < sameRate))
        throw InputError (path.string(), "does not have a sample each " + inWords (micro / sampleRate)
                                             + " us in its first column, as voltages.wav has");

    const Eigen::MatrixXd samples = table.numbers.rightCols (table.numbers.cols() - 1).transpose();
    return isDisplacement ? Eigen::MatrixXd (samples / micro) : displacementsOf (samples / milli, sampleRate, band);
}

Eigen::MatrixXd recordedWave (const std::filesystem::path& path, double sampleRate, TrackBand band,
                              const SensorOptions& sensor)
{
    if (! (sensor.sensitivity > 0))
        throw InputError ("--sensitivity-mm-s-per-v", "is missing; give the sensitivity of the sensor in mm/s per V");

    const auto wave = readWaveFile (path);

    if (wave.sampleRate != sampleRate)
        throw InputError (path.string(), "has " + inWords (wave.sampleRate) + " Hz; allowed: the rate of voltages.wav, "
                                             + inWords (sampleRate) + " Hz");

    return displacementsOf (sensor.fullScaleVelocity() * wave.samples, sampleRate, band);
}
} // namespace

std::vector<RecordedPass> readRecordedPasses (const std::vector<std::string>& folders, const ModalModel& model,
                                              TrackBand band, const SensorOptions& sensor)
{
    std::vector<RecordedPass> passes;

    for (const auto& name : folders)
    {
        const std::filesystem::path folder (name);
        const auto wave = readWaveFile (folder / "voltages.wav");
        const auto trigger = triggerSample (folder / "summary.json");
        auto& pass = passes.emplace_back();
        pass.voltages = { { Reconstruction::bandLimited, wave.sampleRate },
                          -trigger / wave.sampleRate,
                          model.fullScaleVoltage * wave.samples };
        const auto table = folder / "recorded.csv", sound = folder / "recorded.wav";

        if (! std::filesystem::exists (table) && ! std::filesystem::exists (sound))
            throw InputError (name,
                              "has neither recorded.csv nor recorded.wav: what was recorded while its voltages.wav "
                              "was played");

        pass.displacements = std::filesystem::exists (table) ? recordedTable (table, wave.sampleRate, band)
                                                             : recordedWave (sound, wave.sampleRate, band, sensor);
    }

    return passes;
}
} // namespace antinode
