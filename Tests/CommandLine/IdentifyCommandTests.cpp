#include "Support/RunProgram.h"

#include <antinode_identification/IdentifiedModes.h>
#include <antinode_responses/UniversalFile.h>
#include <antinode_responses/UniversalResponses.h>

#include <nlohmann/json.hpp>

#include <catch2/catch.hpp>

#include <fstream>
#include <numbers>
#include <random>

using namespace antinode;
using namespace antinode::test;

namespace
{
constexpr int modeCount = 3, pointCount = 12;

double modeFrequency (int mode)
{
    return 100.0 * (mode + 1) * (mode + 1);
}

/** Three modes of a simply supported beam at twelve points from two ceramics, 10.7 us late, noise 60 dB below the mean.
 */
FrequencyResponses measuredBeam()
{
    IdentifiedModes modes;
    modes.references = { { "left", {} }, { "right", {} } };
    modes.points = Eigen::MatrixX2d::Zero (pointCount, 2);
    modes.points.col (0) = 0.2 * (Eigen::ArrayXd::LinSpaced (pointCount, 0.5, pointCount - 0.5) / pointCount - 0.5);
    modes.angularFrequencies.resize (modeCount);
    modes.dampingRatios = Eigen::VectorXd::Constant (modeCount, 0.006);
    modes.shapes.resize (pointCount, modeCount);
    modes.participation.resize (modeCount, 2);
    modes.delay = 10.7e-6;

    for (int k = 0; k < modeCount; ++k)
    {
        const auto wave = (k + 1) * std::numbers::pi;
        modes.angularFrequencies[k] = 2 * std::numbers::pi * modeFrequency (k);
        modes.shapes.col (k) = 6 * (wave * (modes.points.col (0).array() / 0.2 + 0.5)).sin();
        modes.participation.row (k) << 0.01 * std::sin (0.15 * wave), 0.01 * std::sin (0.72 * wave);
    }

    auto responses = synthesise (modes, Eigen::VectorXd::LinSpaced (1200, 1, 1200));
    std::mt19937_64 random (7);
    std::normal_distribution<double> normal;
    const auto scale = 1e-3 * std::sqrt (responses.values[0].cwiseAbs2().mean() / 2);

    for (auto& values : responses.values)
        for (auto& value : values.reshaped())
            value += std::complex<double> (scale * normal (random), scale * normal (random));

    return responses;
}

void write (const std::filesystem::path& path, const std::string& content)
{
    std::ofstream (path, std::ios::binary) << content;
}

nlohmann::json readJson (const std::filesystem::path& path)
{
    return nlohmann::json::parse (readContent (path));
}
} // namespace

TEST_CASE ("identify makes a device of a universal file that other commands take", "[command line][identify]")
{
    const TemporaryFolder folder;
    const auto path = [&] (const std::string& name) { return (folder.path() / name).string(); };
    write (path ("frf.uff"), encodeUniversalFile (responseSets (measuredBeam())));
    const auto run = runProgram (
        { "identify", path ("frf.uff"), "--out", path ("beam.json"), "--uff", path ("beam.uff"), "--report" });
    INFO (run.errors);
    REQUIRE (run.exitCode == 0);
    CHECK (run.output.find ("3 modes") != std::string::npos);

    const auto device = readJson (path ("beam.json"));
    REQUIRE (device["modes"].size() == modeCount);
    CHECK (device["delay_s"].get<double>() == Approx (10.7e-6).margin (1e-8));
    CHECK (device["ceramics"][1]["name"] == "right");
    CHECK (device["points_mm"].size() == pointCount);

    for (int k = 0; k < modeCount; ++k)
    {
        const auto& mode = device["modes"][static_cast<std::size_t> (k)];
        const auto deviation = mode["frequency_standard_deviation_Hz"].get<double>();
        CHECK (deviation > 0);
        CHECK (std::abs (mode["frequency_Hz"].get<double>() - modeFrequency (k))
               < 6 * deviation); // Beyond it once in 5e8.
        CHECK (mode["damping_ratio"].get<double>() == Approx (0.006).epsilon (1e-3));
        CHECK (mode["participation_standard_deviation_per_V"].size() == 2);
        // The product at the first point is what no convention changes.
        CHECK (mode["shape"][0].get<double>() * mode["participation_per_V"][0].get<double>()
               == Approx (6 * std::sin ((k + 1) * std::numbers::pi * 0.5 / pointCount) * 0.01
                          * std::sin (0.15 * (k + 1) * std::numbers::pi))
                      .epsilon (1e-2));
    }

    CHECK (readContent (path ("beam.html")).find ("Stabilisation diagram") != std::string::npos);
    CHECK (readContent (path ("beam.html")).find ("href=\"beam-diagram.html\"") != std::string::npos);
    CHECK (readContent (path ("beam-diagram.html")).find ("\"report\":\"beam.html\"") != std::string::npos);
    CHECK (readUniversalFile (readContent (path ("beam.uff")), "beam.uff").size() >= 4 + modeCount);
    CHECK (runProgram ({ "modes", path ("beam.json") }).exitCode == 0);

    const auto again = runProgram (
        { "identify", path ("frf.uff"), "--against", path ("beam.json"), "--transfer", path ("tuned.json") });
    CHECK (again.exitCode == 0);
    CHECK (again.output.find ("identified (Hz)") != std::string::npos);
    CHECK (readJson (path ("tuned.json"))["modes"].size() == modeCount);
}

TEST_CASE ("A hammer's responses become a device of newtons, with a word about it", "[command line][identify]")
{
    const TemporaryFolder folder;
    const auto path = [&] (const std::string& name) { return (folder.path() / name).string(); };
    const auto responses = measuredBeam();
    std::string table = "# accelerance (m/s^2)/N\nfrequency_Hz";

    for (int p = 0; p < pointCount; ++p)
        table += ",P" + std::to_string (p + 1) + " real,P" + std::to_string (p + 1) + " imag";

    for (Eigen::Index f = 0; f < responses.frequencies.size(); ++f)
    {
        table += "\n" + std::to_string (responses.frequencies[f]);

        for (int p = 0; p < pointCount; ++p)
        {
            const auto acceleration = 1e3 * responses.values[0](f, p)
                                      * std::complex<double> (0, 2 * std::numbers::pi * responses.frequencies[f]);
            table += "," + std::to_string (acceleration.real()) + "," + std::to_string (acceleration.imag());
        }
    }

    write (path ("hammer.csv"), table + "\n");
    const auto run =
        runProgram ({ "identify", path ("hammer.csv"), "--out", path ("hammer.json"), "--select", "100,400" });
    INFO (run.errors);
    REQUIRE (run.exitCode == 0);
    CHECK (run.output.find ("in the device 1 V stands for 1 N") != std::string::npos);
    const auto modes = readJson (path ("hammer.json"))["modes"];
    REQUIRE (modes.size() == 2);
    CHECK (modes[0]["frequency_Hz"].get<double>() == Approx (modeFrequency (0)).epsilon (1e-4));
}

TEST_CASE ("Files in the order of a shell are read in that of their numbers", "[command line][identify]")
{
    const TemporaryFolder folder;
    const auto path = [&] (const std::string& name) { return (folder.path() / name).string(); };
    const auto responses = measuredBeam();
    std::string places = "x_mm,y_mm\n";
    ProgramArguments ascending { "identify" }, byShell { "identify" };

    for (const auto p : { 0, 9, 10, 11, 1, 2, 3, 4, 5, 6, 7, 8 }) // 1, 10, 11, 12, 2 ...
    {
        std::string table = "frequency_Hz,real (m/s)/V,imag (m/s)/V\n";

        for (Eigen::Index f = 0; f < responses.frequencies.size(); ++f)
            table += std::to_string (responses.frequencies[f]) + ","
                     + std::to_string (1e3 * responses.values[0](f, p).real()) + ","
                     + std::to_string (1e3 * responses.values[0](f, p).imag()) + "\n";

        write (path ("FRF_" + std::to_string (p + 1) + ".csv"), table);
        byShell.emplace_back (path ("FRF_" + std::to_string (p + 1) + ".csv"));
    }

    for (int p = 0; p < pointCount; ++p)
    {
        places += std::to_string (10 * p) + ",0\n";
        ascending.emplace_back (path ("FRF_" + std::to_string (p + 1) + ".csv"));
    }

    write (path ("points.csv"), places);
    const auto deviceBy = [&] (ProgramArguments arguments, bool isReordered)
    {
        arguments.insert (arguments.end(), { "--points", path ("points.csv"), "--out", path ("beam.json") });
        const auto run = runProgram (arguments);
        INFO (run.errors);
        REQUIRE (run.exitCode == 0);
        CHECK ((run.output.find ("in the order of the numbers in their names: FRF_1.csv, FRF_2.csv to FRF_12.csv")
                != std::string::npos)
               == isReordered);
        return readContent (path ("beam.json"));
    };
    CHECK (deviceBy (byShell, true) == deviceBy (ascending, false));
}

TEST_CASE ("identify refuses in one line and writes nothing", "[command line][identify]")
{
    const TemporaryFolder folder;
    const auto path = [&] (const std::string& name) { return (folder.path() / name).string(); };
    write (path ("frf.csv"), "1,1,0\n2,1,0\n3,1,0\n");
    const auto refusal = [&] (ProgramArguments arguments)
    {
        arguments.insert (arguments.begin(), { "identify", path ("frf.csv"), "--out", path ("out.json"), "--report" });
        const auto run = runProgram (arguments);
        CHECK (run.exitCode == 1);
        CHECK (std::count (run.errors.begin(), run.errors.end(), '\n') == 1);
        CHECK_FALSE (std::filesystem::exists (path ("out.json")));
        CHECK_FALSE (std::filesystem::exists (path ("out.html")));
        CHECK_FALSE (std::filesystem::exists (path ("out-diagram.html")));
        return run.errors;
    };
    CHECK (refusal ({ "--transfer", path ("t.json") })
           == "antinode: --transfer: needs a computed device; allowed only with --against DEVICE\n");
    CHECK (refusal ({ "--band", "300" })
           == "antinode: --band: is '300'; allowed: two ascending numbers, for example 300:4000\n");
    CHECK (refusal ({ "--orders", "3:200" }) == "antinode: --orders: are 3 to 200; allowed: 1 to 100, ascending\n");
    CHECK (refusal ({ "--orders", "0:20" }) == "antinode: --orders: are 0 to 20; allowed: 1 to 100, ascending\n");
    CHECK (refusal ({ "--response-unit", "Pa" })
           == "antinode: --response-unit: is 'Pa'; allowed: a unit, for example m/s, um, g or (mm/s)/V\n");
    CHECK (refusal ({ "--quantity", "velocity", "--response-unit", "g" })
           == "antinode: --response-unit: is 'g'; allowed: a unit of velocity\n");
    CHECK (refusal ({ "--drive", "force", "--drive-unit", "V" })
           == "antinode: --drive-unit: is 'V'; allowed: a unit of the excitation, for example V, mV or N\n");
    CHECK (runProgram ({ "identify", path ("missing.uff") }).errors
           == "antinode: " + path ("missing.uff") + ": cannot be read\n");
}
