#include <antinode_identification/Identification.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <fstream>
#include <numbers>
#include <string>

using namespace antinode;

namespace
{
/** Tests/Data/Identification/accelerometer_frf.csv as mobility. */
FrequencyResponses measuredBeam()
{
    std::ifstream file (std::string (ANTINODE_TEST_DATA) + "/Identification/accelerometer_frf.csv");
    std::vector<double> frequencies;
    std::vector<std::complex<double>> values;
    double frequency = 0, real = 0, imaginary = 0;
    char comma = 0;

    for (std::string line; std::getline (file, line);)
        if (std::istringstream fields (line);
            fields >> frequency >> comma >> real >> comma >> imaginary && frequency > 0)
        {
            frequencies.push_back (frequency);
            values.push_back (std::complex (real, imaginary) / std::complex (0.0, 2 * std::numbers::pi * frequency));
        }

    const auto count = static_cast<Eigen::Index> (values.size());
    FrequencyResponses responses;
    responses.frequencies = Eigen::Map<Eigen::VectorXd> (frequencies.data(), count);
    responses.drive = DriveQuantity::force;
    responses.references = { { "hammer", {} } };
    responses.points = Eigen::RowVector2d (0, 0);
    responses.values = { Eigen::Map<Eigen::VectorXcd> (values.data(), count) };
    return responses;
}
} // namespace

TEST_CASE ("A measured beam has its four modes and is reconstructed to 36 dB", "[identification]")
{
    const auto responses = measuredBeam();
    REQUIRE (responses.frequencies.size() == 3999);
    IdentificationOptions options;
    options.minimumFrequency = 300;
    options.maximumFrequency = 3990;
    const auto modes = identify (responses, options);
    REQUIRE (modes.modes() == 4);
    // Another program's fit of the same data; it agrees with ours to what leakage leaves unsure.
    const Eigen::Vector4d frequencies (695.77, 1898.08, 2777.39, 3671.14),
        dampings (0.436e-2, 0.306e-2, 0.235e-2, 0.201e-2);

    for (Eigen::Index k = 0; k < 4; ++k)
    {
        CHECK (modes.angularFrequencies[k] / (2 * std::numbers::pi) == Approx (frequencies[k]).epsilon (3e-4));
        CHECK (modes.dampingRatios[k] == Approx (dampings[k]).epsilon (0.06));
    }

    CHECK (modes.reconstructionError < -36);
    CHECK (modes.scaling == ShapeScaling::convention);
    // What is said of the error is what synthesis shows.
    const auto used = responses.frequencies.segment (299, 3691);
    const auto synthesised = synthesise (modes, used);
    const auto measured = responses.values[0].col (0).segment (299, 3691);
    const auto error = 20 * std::log10 ((synthesised.values[0].col (0) - measured).norm() / measured.norm());
    CHECK (error == Approx (modes.reconstructionError).margin (0.01));
}

TEST_CASE ("A selected pole becomes a mode, or a warning says that it does not", "[identification]")
{
    IdentificationOptions options;
    options.minimumFrequency = 20;
    options.maximumFrequency = 2000;
    options.selected = { 695.7, 1202.7, 1898 }; // At 1202.7 Hz is a pole of most orders, far below the resonances.
    const auto modes = identify (measuredBeam(), options);
    const auto leftOut =
        std::count_if (modes.warnings.begin(), modes.warnings.end(),
                       [] (const auto& warning) { return warning.rfind ("the selected pole at 12", 0) == 0; });
    CHECK (modes.modes() + leftOut == 3);
}
