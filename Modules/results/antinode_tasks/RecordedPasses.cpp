#include "RecordedPasses.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_base/WholeFile.h>
#include <antinode_engine/LagFilters.h>
#include <antinode_learning/PassDelay.h>
#include <antinode_text/CsvTable.h>
#include <antinode_text/WaveReader.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>

namespace antinode
{
namespace
{
constexpr double sameRate = 1e-3; // times may be rounded

/** The sample of the trigger, from the summary of a pass of so many samples. */
double triggerSample (const std::filesystem::path& path, Eigen::Index samples)
{
    const auto json = nlohmann::json::parse (readWholeFile (path, { "a JSON file" }), nullptr, false);

    if (! json.is_object() || ! json.contains ("trigger_sample") || ! json["trigger_sample"].is_number())
        throw InputError (path.string(), "has no \"trigger_sample\"; allowed: summary.json of antinode perform");

    const auto trigger = json["trigger_sample"].get<double>();

    if (! (trigger >= 0 && trigger < static_cast<double> (samples) && trigger == std::floor (trigger)))
        throw InputError (path.string(), "has the trigger_sample " + inWords (trigger)
                                             + "; allowed: a whole number from 0 to " + std::to_string (samples - 1)
                                             + ", the last sample of voltages.wav");

    return trigger;
}

bool endsWith (const std::string& text, const std::string& end)
{
    return text.size() >= end.size() && text.compare (text.size() - end.size(), end.size(), end) == 0;
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
        throw InputError (path.string(), "has other headings; allowed: headings time_s and then displacement_um_1 "
                                         "or velocity_mm_s_1 and so on");

    for (std::size_t i = 1; i < table.headings.size(); ++i)
        if (const auto number = "_" + std::to_string (i); ! endsWith (table.headings[i], number))
            throw InputError (path.string(), "has '" + table.headings[i] + "' as column " + std::to_string (i + 1)
                                                 + "; allowed: a heading that ends with '" + number
                                                 + "', the finger's number");

    const auto last = table.numbers.rows() - 1;

    if (const auto begin = table.numbers (0, 0); ! (std::abs (begin) * sampleRate < 0.5))
        throw InputError (path.string(),
                          "begins at " + inWords (begin) + " s; allowed: 0 s, with the first sample of voltages.wav");

    if (const auto span = table.numbers (last, 0) - table.numbers (0, 0);
        last > 0 && ! (std::abs (span * sampleRate / static_cast<double> (last) - 1) < sameRate))
        throw InputError (path.string(), "does not have a sample each " + inWords (micro / sampleRate)
                                             + " us in its first column, as voltages.wav has");

    const Eigen::MatrixXd samples = table.numbers.rightCols (table.numbers.cols() - 1).transpose();
    return isDisplacement ? Eigen::MatrixXd (samples / micro) : displacementsOf (samples / milli, sampleRate, band);
}
} // namespace

std::vector<RecordedPass> readRecordedPasses (const std::vector<std::filesystem::path>& folders,
                                              const ModalModel& model, TrackBand band, const SensorScale& sensor)
{
    std::vector<RecordedPass> passes;

    for (std::size_t i = 0; i < folders.size(); ++i)
    {
        const auto& folder = folders[i];

        if (std::find (folders.begin(), folders.begin() + static_cast<std::ptrdiff_t> (i), folder)
            != folders.begin() + static_cast<std::ptrdiff_t> (i))
            throw InputError ("--correct " + folder.string(),
                              "is given twice; allowed: each pass once, in the order of playing");

        const auto wave = readWaveFile (folder / "voltages.wav");
        const auto trigger = triggerSample (folder / "summary.json", wave.samples.cols());
        auto& pass = passes.emplace_back();
        pass.voltages = { { Reconstruction::bandLimited, wave.sampleRate },
                          -trigger / wave.sampleRate,
                          withLags (model, model.fullScaleVoltage * wave.samples, wave.sampleRate) };
        const auto file = recordedFile (folder);
        pass.displacements =
            file.extension() == ".csv"
                ? recordedTable (file, wave.sampleRate, band)
                : displacementsOf (recordedVelocities (file, wave.sampleRate, sensor), wave.sampleRate, band);
    }

    return passes;
}

std::vector<RecordedPass> withoutLatency (std::vector<RecordedPass> passes, const ModalModel& known,
                                          const WaveformsDescription& description, double sampleRate,
                                          double longestLatency)
{
    if (! (longestLatency > 0))
        return passes;

    requirePasses (passes, known, description, sampleRate);

    for (std::size_t i = 0; i < passes.size(); ++i)
    {
        auto& pass = passes[i];

        if (pass.displacements.isZero (0) || pass.voltages.values.isZero (0))
            throw InputError ("recorded pass " + std::to_string (i + 1),
                              "is silent, so no latency can be found; allowed: a pass that was played");

        auto aligned = alignedWith (pass.displacements, predictedDisplacements (known, description, pass.voltages, 0),
                                    sampleRate, longestLatency);
        pass.displacements = std::move (aligned.signals);
        pass.latency = aligned.delay;
    }

    return passes;
}
} // namespace antinode
