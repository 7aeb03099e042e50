#include "Support/IdentificationScore.h"

#include <antinode_identification/Identification.h>

#include <catch2/catch.hpp>

using namespace antinode;
using namespace antinode::test;

namespace
{
/** A wooden plate: twelve modes from 62 to 880 Hz, damping ratios .6 to 1.4 %, at some points, hit at a few places. */
KnownStructure woodenPlate (Eigen::Index points, Eigen::Index hits)
{
    constexpr Eigen::Index modes = 12;
    std::mt19937_64 random (21);
    std::uniform_real_distribution<double> uniform (0, 1);
    KnownStructure plate;
    plate.points.resize (points, 2);
    plate.masses.setConstant (points, 0.4 / static_cast<double> (points));
    plate.frequencies.resize (modes);
    plate.frequencies << 62, 91, 148, 171, 252, 297, 341, 436, 512, 604, 729, 880;
    plate.dampingRatios.resize (modes);
    plate.shapes.resize (points, modes);
    plate.participation.resize (modes, hits);
    plate.delay = 0;

    for (Eigen::Index p = 0; p < points; ++p)
        plate.points.row (p) << 0.5 * uniform (random), 0.2 * uniform (random);

    for (Eigen::Index k = 0; k < modes; ++k)
    {
        plate.dampingRatios[k] = 0.006 + 0.008 * uniform (random);
        const auto waveX = std::numbers::pi * static_cast<double> (k % 4 + 1) / 0.5;
        const auto waveY = std::numbers::pi * static_cast<double> (k / 4 + 1) / 0.2;

        for (Eigen::Index p = 0; p < points; ++p)
            plate.shapes (p, k) =
                3 * std::cos (waveX * plate.points (p, 0) + 0.2) * std::cos (waveY * plate.points (p, 1) + 0.1);

        for (Eigen::Index i = 0; i < hits; ++i)
            plate.participation (k, i) = 1 + uniform (random);
    }

    return plate;
}

/** Adds what a bench adds below the modes, in velocities: two suspension modes of 6 and 11 Hz that differ from channel
   to channel, the white noise of an accelerometer integrated, so many dB below the modes at 200 Hz, and its drift. */
void addSuspension (FrequencyResponses& responses, double decibels)
{
    const auto level = rootMeanSquare (responses);
    ComplexNoise noise (12);

    for (auto& values : responses.values)
        for (Eigen::Index p = 0; p < values.cols(); ++p)
        {
            const std::array resonances { 6 * (1 + 0.02 * noise().real()), 11 * (1 + 0.02 * noise().real()) };

            for (Eigen::Index f = 0; f < values.rows(); ++f)
            {
                const auto frequency = std::max (responses.frequencies[f], 0.5);
                const std::complex<double> i (0, 1);

                for (const auto resonance : resonances)
                    values (f, p) +=
                        20 * level * 0.1 * i * resonance * frequency
                        / (resonance * resonance - frequency * frequency + 0.1 * i * resonance * frequency);

                const auto integrated = std::pow (10, -decibels / 20) * 200 / frequency;
                values (f, p) += level * integrated * (1 + 100 / (frequency * frequency)) * noise();
            }
        }
}

bool hasWarning (const IdentifiedModes& modes, const std::string& part)
{
    return std::any_of (modes.warnings.begin(), modes.warnings.end(),
                        [&part] (const auto& warning) { return warning.find (part) != std::string::npos; });
}

int modesBelow (const IdentifiedModes& modes, double frequency)
{
    return static_cast<int> ((modes.angularFrequencies.array() < 2 * std::numbers::pi * frequency).count());
}
} // namespace

TEST_CASE ("Suspension and drift a thousand times stronger than the modes are left out without a hint",
           "[identification]")
{
    const auto truth = woodenPlate (10, 1);
    auto responses = idealResponses (truth, lines (0, 1000, 0.5));
    addSuspension (responses, 45);
    const auto modes = identify (responses, {});
    CHECK (modes.minimumFrequency < 62);
    CHECK (modes.reconstructionError < -30);
    CHECK (hasWarning (modes, "are left out"));
    const auto result = score (modes, truth);
    CHECK (result.found == 12);
    CHECK (result.falseOnes - modesBelow (modes, 40) <= 0);
    CHECK (quantile (result.frequency, 1) < 100e-6);
    CHECK (quantile (result.damping, 1) < 2e-2);
}

TEST_CASE ("A single response shows its modes by higher orders", "[identification]")
{
    auto truth = woodenPlate (1, 1);
    auto responses = idealResponses (truth, lines (0.5, 1000, 0.5));
    addSuspension (responses, 50);
    const auto modes = identify (responses, {});
    CHECK (modes.reconstructionError < -30);
    CHECK (score (modes, truth).found >= 11);
}

TEST_CASE ("Lines of the mains and a point without signal are left out and named", "[identification]")
{
    const auto truth = woodenPlate (10, 2);
    auto responses = idealResponses (truth, lines (30, 1000, 0.5));
    addNoise (responses, 40, 3);
    ComplexNoise noise (4);

    for (auto& values : responses.values)
    {
        for (const Eigen::Index hertz : { 50, 150, 250 })
            for (Eigen::Index p = 0; p < 10; ++p)
                values (2 * (hertz - 30), p) += 20 * rootMeanSquare (responses) * noise();

        values.col (6).setZero();
    }

    const auto modes = identify (responses, {});
    const auto result = score (modes, truth);
    CHECK (result.found == 12);
    CHECK (result.falseOnes == 0);
    CHECK (hasWarning (modes, "50, 150, 250 Hz"));
    CHECK (hasWarning (modes, "point 7"));
    CHECK (modes.shapes.row (6).array().isNaN().all());
    CHECK (modes.shapes.row (5).allFinite());
}

TEST_CASE ("A point that disagrees with the others counts for little and is named", "[identification]")
{
    const auto truth = woodenPlate (10, 1);
    auto responses = idealResponses (truth, lines (30, 1000, 0.5));
    addNoise (responses, 50, 3);

    // A sensor that came loose: its resonances are elsewhere.
    auto other = truth;
    other.frequencies *= 1.01;
    responses.values[0].col (3) = idealResponses (other, responses.frequencies).values[0].col (3);
    const auto modes = identify (responses, {});
    CHECK (hasWarning (modes, "point 4"));
    const auto result = score (modes, truth);
    CHECK (result.found == 12);
    CHECK (quantile (result.frequency, 0.5) < 100e-6);
}

TEST_CASE ("A poor result says where its error lies", "[identification]")
{
    const auto truth = woodenPlate (6, 1);
    auto responses = idealResponses (truth, lines (30, 1000, 0.5));

    // Every point is a structure of its own.
    for (Eigen::Index p = 0; p < 6; ++p)
    {
        auto other = truth;
        other.frequencies *= 1 + 0.02 * static_cast<double> (p);
        responses.values[0].col (p) = idealResponses (other, responses.frequencies).values[0].col (p);
    }

    addNoise (responses, 60, 3);
    const auto modes = identify (responses, {});
    CHECK ((modes.reconstructionError < -15 || hasWarning (modes, "of the error lies from")));
}
