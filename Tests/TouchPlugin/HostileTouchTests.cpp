#include "JudgedTouch.h"

#include <catch2/catch.hpp>

#include <limits>

using namespace antinode;
using namespace antinode::test;

namespace
{
constexpr double rate = judgedRate;
constexpr int ceramics = 12, length = 14400;

double largestVoltage (TouchProcessor& processor)
{
    const auto model = processor.session().snapshot()->model;
    return voltageLimits (*model).maxCoeff() / model->fullScaleVoltage;
}
} // namespace

TEST_CASE ("Hostile inputs never give more than the limit, nothing that is not finite, and no crash", "[touch-plugin]")
{
    auto parameters = threeFingers();
    parameters["finger1_level"] = parameters["finger2_level"] = 100;
    parameters["gain"] = 20;
    const auto processor = offlineTouch (ceramics, rate, 333, parameters);
    const auto limit = largestVoltage (*processor);
    const auto kind = GENERATE (0, 1, 2, 3, 4);
    Eigen::MatrixXd inputs (8, length);
    juce::Random random (5);

    for (Eigen::Index n = 0; n < inputs.size(); ++n)
    {
        const double values[] = { std::numeric_limits<double>::quiet_NaN(),
                                  n % 3 == 0 ? std::numeric_limits<double>::infinity() : -1e300,
                                  2.0 * random.nextDouble() - 1, 1,
                                  std::sin (2 * std::numbers::pi * 10000 * static_cast<double> (n / 8) / rate) };
        inputs (n) = values[kind];
    }

    CAPTURE (kind);
    const auto played = voltagesOf (*processor, inputs, 333);
    CHECK (played.allFinite());
    CHECK (played.cwiseAbs().maxCoeff() <= limit);
    CHECK (processor->warning().isEmpty());
    // What came is forgotten after the filters' length, its offset after some seconds: then a usual input plays.
    processor->parameters().setValues (threeFingers());
    voltagesOf (*processor, Eigen::MatrixXd::Zero (8, static_cast<Eigen::Index> (8 * rate)), 333);
    const auto usual = withRest (fingerTones (8, length, rate));
    CHECK (judged (*processor, voltagesOf (*processor, usual, 333), usual).normalisedError (0) < 1e-4);
}

TEST_CASE ("Fingers that leap a thousand times a second leave all voltages within their limits", "[touch-plugin]")
{
    TouchProcessor processor (ceramics, juce::AudioProcessor::wrapperType_Undefined);
    processor.parameters().setValues (threeFingers());
    processor.prepareToPlay (rate, 48);
    processor.session().waitUntilSettled();
    const auto limit = largestVoltage (processor);
    const auto inputs = fingerTones (8, 48, rate, 100);
    juce::Random random (3);
    auto isHeard = false, isWithin = true;

    for (int i = 0; i < 3000; ++i)
    {
        for (std::size_t k = 0; k < 3; ++k)
        {
            processor.parameters().finger (k).x->setValueNotifyingHost (random.nextFloat());
            processor.parameters().finger (k).y->setValueNotifyingHost (random.nextFloat());
        }

        const auto played = voltagesOf (processor, inputs, 48);
        isHeard = isHeard || played.cwiseAbs().maxCoeff() > 1e-4;
        isWithin = isWithin && played.allFinite() && played.cwiseAbs().maxCoeff() <= limit;
    }

    CHECK (isHeard);
    CHECK (isWithin);
}

TEST_CASE ("Voltages of amplifiers with a slew rate never change quicker", "[touch-plugin]")
{
    auto json = loadDocument (LibraryKind::device, "aluminium-200x120");
    json["limits"]["slew_V_per_us"] = 0.01;
    auto parameters = threeFingers();
    parameters["finger1_level"] = 50;
    const auto processor = offlineTouch (ceramics, rate, 256, parameters);
    processor->load (touchDeviceFrom (json));
    processor->session().waitUntilSettled();
    processor->prepareToPlay (rate, 256);
    processor->session().waitUntilSettled();
    const auto model = processor->session().snapshot()->model;
    const auto steepest = model->ceramics[0].slewLimit / rate / model->fullScaleVoltage;
    REQUIRE (steepest > 0);
    Eigen::MatrixXd noise (2, length);
    juce::Random random (5);

    for (auto& value : noise.reshaped())
        value = 2 * random.nextDouble() - 1;

    const auto played = voltagesOf (*processor, noise, 256);
    const auto step = (played.rightCols (length - 1) - played.leftCols (length - 1)).cwiseAbs().maxCoeff();
    // The ramp of arming may add a thousandth; it has ended by then.
    CHECK (step <= steepest * (1 + 1e-9));
    CHECK (step > 0.9 * steepest);
}

TEST_CASE ("A track that is not finite is silence, and leaves the other fingers' tracks as they are", "[touch-plugin]")
{
    auto inputs = fingerTones (2, length, rate, 0.1);
    inputs.row (1).setZero();
    const auto alone = voltagesOf (*offlineTouch (ceramics, rate, 256), inputs, 256);
    inputs.row (1).setConstant (std::numeric_limits<double>::quiet_NaN());
    CHECK (voltagesOf (*offlineTouch (ceramics, rate, 256), inputs, 256) == alone);
    CHECK (alone.cwiseAbs().maxCoeff() > 1e-4);
}

TEST_CASE ("A constant track and one of 10 kHz move nothing: neither is within the band", "[touch-plugin]")
{
    const auto seconds = static_cast<Eigen::Index> (4 * rate);
    const auto peakOf = [&] (double frequency, double phase)
    {
        Eigen::MatrixXd inputs (1, seconds);

        for (Eigen::Index n = 0; n < seconds; ++n)
            inputs (0, n) = 0.1 * std::sin (2 * std::numbers::pi * frequency * static_cast<double> (n) / rate + phase);

        // Behind the step with which it begins, which has all frequencies.
        return voltagesOf (*offlineTouch (ceramics, rate, 512), inputs, 512)
            .rightCols (seconds / 8)
            .cwiseAbs()
            .maxCoeff();
    };
    const auto within = peakOf (300, 0);
    REQUIRE (within > 1e-4);
    CHECK (peakOf (10000, 0) < 1e-3 * within);
    CHECK (peakOf (0, std::numbers::pi / 2) < 1e-3 * within);
}
