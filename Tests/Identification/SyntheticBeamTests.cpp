#include "Support/IdentificationScore.h"

#include <antinode_identification/Identification.h>

#include <catch2/catch.hpp>

using namespace antinode;
using namespace antinode::test;

namespace
{
struct MeasuredBeam
{
    KnownStructure truth = knownBeam (1);
    FrequencyResponses ideal = idealResponses (truth, lines (200, 29000, 1));
};

const MeasuredBeam& beam()
{
    static const MeasuredBeam measured;
    return measured;
}

IdentifiedModes identified (double decibels)
{
    auto responses = beam().ideal;
    addNoise (responses, decibels, 1);
    IdentificationOptions options;
    options.pointMasses = beam().truth.masses;
    return identify (responses, options);
}

/** RMS of errors over stated deviations: of 20 numbers it lies within these bounds in 98 of 100 measurements, of more
    within closer ones. */
void checkDeviations (const IdentificationScore& result)
{
    for (const auto z : { result.zFrequency, result.zDamping })
    {
        CHECK (z > 0.6);
        CHECK (z < 1.4);
    }

    for (const auto z : { result.zShape, result.zParticipation })
    {
        CHECK (z > 0.8);
        CHECK (z < 1.25);
    }
}
} // namespace

TEST_CASE ("All 20 modes of a beam are found at 40 dB, none that is not there, at the Cramer-Rao bound",
           "[identification]")
{
    const auto modes = identified (40);
    const auto result = score (modes, beam().truth);
    CHECK (result.found == 20);
    CHECK (result.falseOnes == 0);
    // Some four times what the bound of this measurement gives in the median, ten times what a peak and its width give.
    CHECK (quantile (result.frequency, 0.5) < 0.2e-6);
    CHECK (quantile (result.frequency, 0.95) < 1e-6);
    CHECK (quantile (result.damping, 0.5) < 0.01e-2);
    CHECK (quantile (result.damping, 0.95) < 0.05e-2);
    CHECK (quantile (result.assurance, 0.5) < 1e-7);
    CHECK (quantile (result.assurance, 0.95) < 1e-5);
    CHECK (quantile (result.participation, 0.5) < 0.01e-2);
    CHECK (quantile (result.participation, 0.95) < 0.1e-2);
    CHECK (std::abs (modes.delay - beam().truth.delay) < 0.001e-6);
    checkDeviations (result);
    CHECK (modes.reconstructionError == Approx (-40).margin (0.05));
}

TEST_CASE ("All 20 modes of a beam are found at 20 dB, none that is not there, at the Cramer-Rao bound",
           "[identification]")
{
    const auto modes = identified (20);
    const auto result = score (modes, beam().truth);
    CHECK (result.found == 20);
    CHECK (result.falseOnes == 0);
    CHECK (quantile (result.frequency, 0.5) < 2e-6);
    CHECK (quantile (result.frequency, 0.95) < 10e-6);
    CHECK (quantile (result.damping, 0.5) < 0.1e-2);
    CHECK (quantile (result.damping, 0.95) < 0.5e-2);
    CHECK (quantile (result.assurance, 0.5) < 1e-5);
    CHECK (quantile (result.assurance, 0.95) < 1e-3);
    CHECK (quantile (result.participation, 0.5) < 0.1e-2);
    CHECK (quantile (result.participation, 0.95) < 1e-2);
    CHECK (std::abs (modes.delay - beam().truth.delay) < 0.01e-6);
    checkDeviations (result);
}

TEST_CASE ("Without noise a beam is identified to rounding", "[identification]")
{
    IdentificationOptions options;
    options.maximumFrequency = 6000; // higher modes are residual terms, which are not exact
    auto truth = beam().truth;
    const auto inBand = (truth.frequencies.array() < 5900).count();
    truth.frequencies = truth.frequencies.head (inBand).eval();
    truth.dampingRatios = truth.dampingRatios.head (inBand).eval();
    truth.shapes = truth.shapes.leftCols (inBand).eval();
    truth.participation = truth.participation.topRows (inBand).eval();
    const auto result = score (identify (idealResponses (truth, lines (200, 6000, 1)), options), truth);
    CHECK (result.found == inBand);
    CHECK (result.falseOnes == 0);
    CHECK (quantile (result.frequency, 1) < 1e-10);
    CHECK (quantile (result.damping, 1) < 1e-8);
    CHECK (quantile (result.assurance, 1) < 1e-12);
}

TEST_CASE ("Peaks and their widths see a beam two orders of magnitude less exactly", "[identification]")
{
    auto responses = beam().ideal;
    addNoise (responses, 40, 1);
    IdentificationOptions options;
    options.method = IdentificationMethod::peakPicking;
    options.selected.assign (beam().truth.frequencies.begin(), beam().truth.frequencies.end());
    options.delay = beam().truth.delay;
    const auto modes = identify (responses, options);
    const auto result = score (modes, beam().truth);
    CHECK (result.found >= 17);
    // Lines are 1 Hz apart: half of that at 8 kHz is 60 ppm.
    CHECK (quantile (result.frequency, 0.5) < 100e-6);
    CHECK (quantile (result.frequency, 0.5) > 10e-6);
    CHECK (quantile (result.damping, 0.5) < 2e-2);
    CHECK (quantile (result.damping, 0.5) > 0.1e-2);
}
