#include <antinode_reports/IdentificationDiagram.h>
#include <antinode_reports/IdentificationTables.h>

#include <juce_core/juce_core.h>

#include <nlohmann/json.hpp>

#include <catch2/catch.hpp>

#include <cstring>
#include <numbers>

using namespace antinode;

namespace
{
std::vector<unsigned char> bytesOf (const std::string& base64)
{
    juce::MemoryOutputStream stream;
    REQUIRE (juce::Base64::convertFromBase64 (stream, base64));
    const auto* data = static_cast<const unsigned char*> (stream.getData());
    return { data, data + stream.getDataSize() };
}

/** Two modes at two points, of which the second mode has a warning; its names try to leave the script. */
IdentificationResult someResult()
{
    IdentificationResult result;
    auto& modes = result.modes;
    modes.references = { { "</script><b>", {} } };
    modes.points = Eigen::MatrixX2d::Zero (2, 2);
    modes.points (1, 0) = 0.1;
    modes.angularFrequencies = 2 * std::numbers::pi * Eigen::Vector2d (100, 300);
    modes.dampingRatios = Eigen::Vector2d (0.01, 0.02);
    modes.shapes = Eigen::Matrix2d { { 1, 0.5 }, { -1, 0.25 } };
    modes.participation = Eigen::Vector2d (2, 3);
    modes.quality.resize (2);
    modes.minimumFrequency = 50;
    modes.maximumFrequency = 400;
    modes.stabilisation = { { 3, 100, 0.01, true }, { 4, 222, 0.1, false } };
    modes.candidates = { { 100.5, 0.01, 0.9, 0 }, { 222, 0.1, 0.2, {} }, { 300.5, 0.02, 0.8, 1 } };
    result.measured = synthesise (modes, Eigen::VectorXd::LinSpaced (500, 1, 500));
    result.measured.values[0](99, 0) += std::complex<double> (0, 1e-3);
    result.pointNames = { "<!--", "2" };
    result.model.name = "\xff</script>";
    return result;
}
} // namespace

TEST_CASE ("Residuals in a page are exact to 3 % of themselves", "[views]")
{
    Eigen::VectorXcd values (200);

    for (Eigen::Index n = 0; n < 200; ++n)
        values[n] = std::polar (2 * std::pow (10, -0.03 * static_cast<double> (n)), 0.7 * static_cast<double> (n));

    const auto bytes = bytesOf (compactComplex (values, 2));
    REQUIRE (bytes.size() == 400);

    for (std::size_t n = 0; n < 200; ++n)
    {
        // As the manual of the format says: half decibels below the largest, 256 parts of a turn.
        const auto read = std::polar (2 * std::pow (10, 0.5 * (bytes[2 * n] - 254.0) / 20),
                                      bytes[2 * n + 1] * 2 * std::numbers::pi / 256);
        const auto wanted = values[static_cast<Eigen::Index> (n)];
        CHECK (std::abs (read - wanted) < 0.033 * std::abs (wanted));
    }

    const Eigen::Vector3cd special (0, std::numeric_limits<double>::quiet_NaN(), 1e-9);
    const auto codes = bytesOf (compactComplex (special, 1));
    CHECK (codes[0] == 0);
    CHECK (codes[2] == 255);
    CHECK (codes[4] == 0);
}

TEST_CASE ("The data of a diagram are poles, candidates and what the modes leave in the band", "[views]")
{
    const auto data = diagramData (someResult());
    CHECK (data["candidates"].size() == 3);
    CHECK (data["candidates"][1]["mode"].is_null());
    CHECK (data["candidates"][2]["mode"] == 1);
    CHECK (data["usedLines"] == 351);
    CHECK (bytesOf (data["frequencies"]).size() == 351 * sizeof (double));
    float shape[2];
    const auto bytes = bytesOf (data["modes"][1]["shape"]);
    REQUIRE (bytes.size() == sizeof (shape));
    std::memcpy (shape, bytes.data(), sizeof (shape));
    CHECK (shape[1] == 0.25f);
    // The only error is that of the first point at 100 Hz, the 51st line of the band: 1e-3 at 90 degrees.
    const auto residual = bytesOf (data["responses"][0][0]["residual"]);
    CHECK (data["responses"][0][0]["largest"].get<double>() == Approx (1e-3));
    CHECK (residual[100] == 254);
    CHECK (residual[101] == 64);
    CHECK (std::count (residual.begin(), residual.end(), 254) == 1);
}

TEST_CASE ("The page of a diagram is one file without a network, and no name leaves its data", "[views]")
{
    const auto page = identificationDiagram (someResult(), "beam.html");
    const auto count = [&page] (const std::string& text)
    {
        std::size_t found = 0;

        for (auto place = page.find (text); place != std::string::npos; place = page.find (text, place + 1))
            ++found;

        return found;
    };
    CHECK (count ("</script>") == 2);
    CHECK (count ("<script") == 2);
    CHECK (count ("<b>") == 0);
    CHECK (count ("<!--") == 0);
    CHECK (count ("http:") + count ("https:") + count (" src=") + count ("url(") + count ("@import") == 0);
    CHECK (count ("default-src 'none'") == 1);
}

TEST_CASE ("Many warnings of modes are one sentence, a few are said one by one", "[views]")
{
    auto result = someResult();
    result.remarks = { "About a file." };
    result.modes.quality[1].warnings = { "it is close to the noise level" };
    CHECK (summariseWarnings (result)
           == std::vector<std::string> { "About a file.", "Mode 2: it is close to the noise level" });
    result.modes.quality.assign (10, { 1, 1, 1, 0, { "it is close to the noise level" } });
    const auto warnings = summariseWarnings (result);
    REQUIRE (warnings.size() == 2);
    CHECK (warnings[1]
           == "10 of 10 modes have warnings, which the table of modes gives: 1, 2, 3, 4, 5, 6, 7, 8, 9, 10.");
    CHECK (collectWarnings (result).size() == 11);
    CHECK (warningColumn (result)[9] == "it is close to the noise level");
}
