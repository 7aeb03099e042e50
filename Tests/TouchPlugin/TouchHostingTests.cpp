// What hosts do with Antinode Touch: layouts, latency, rates, devices.

#include "JudgedTouch.h"

#include <catch2/catch.hpp>

using namespace antinode;
using namespace antinode::test;

namespace
{
constexpr double rate = judgedRate;
constexpr int ceramics = 12, length = 14400;
} // namespace

TEST_CASE ("A finger without an input is silent", "[touch-plugin]")
{
    auto parameters = threeFingers();
    const auto processor = offlineTouch (ceramics, rate, 256, parameters);
    REQUIRE (processor->setBusesLayout (touchLayout (2, ceramics)));
    parameters["finger3_state"] = 2;
    processor->parameters().setValues (parameters);
    processor->prepareToPlay (rate, 256);
    const auto inputs = withRest (fingerTones (2, length, rate));
    const auto scores = judged (*processor, voltagesOf (*processor, inputs, 256), inputs);
    REQUIRE (scores.fingers.size() == 3);
    CHECK (scores.normalisedError (1) < 1e-4);
    CHECK (scores.suppression (2) < -40);
}

TEST_CASE ("Another latency is reported, and its filters give the same voltages as if they had been first",
           "[touch-plugin]")
{
    auto parameters = threeFingers();
    const auto changed = offlineTouch (ceramics, rate, 256, parameters);
    const auto inputs = withRest (fingerTones (2, length, rate));
    voltagesOf (*changed, inputs, 256);
    parameters["latency"] = 1;
    changed->parameters().setValues (parameters);
    changed->session().waitUntilSettled();
    const auto other = offlineTouch (ceramics, rate, 256, parameters);
    changed->prepareToPlay (rate, 256);
    CHECK (changed->getLatencySamples() == 480);
    CHECK (other->getLatencySamples() == 480);
    voltagesOf (*changed, Eigen::MatrixXd::Zero (2, length), 256);
    voltagesOf (*other, Eigen::MatrixXd::Zero (2, length), 256);
    CHECK ((voltagesOf (*changed, inputs, 256) - voltagesOf (*other, inputs, 256)).isZero (0));
}

TEST_CASE ("Every rate from 44.1 to 192 kHz has its latency within a sample of the filters, lower ones are refused",
           "[touch-plugin]")
{
    for (const auto hertz : { 44100.0, 88200.0, 192000.0 })
    {
        const auto processor = offlineTouch (ceramics, hertz, 256);
        CHECK (processor->getLatencySamples() / hertz == Approx (0.02).margin (1.0 / 4000));
        CHECK (voltagesOf (*processor, fingerTones (2, 20000, hertz), 256).cwiseAbs().maxCoeff() > 1e-4);
    }

    const auto slow = offlineTouch (ceramics, 2000, 256);
    CHECK (slow->warning().contains ("sample rate"));
    CHECK (voltagesOf (*slow, fingerTones (2, 2000, 2000), 256).isZero (0));
    slow->prepareToPlay (rate, 256);
    slow->session().waitUntilSettled();
    CHECK (slow->warning().isEmpty());
    CHECK (voltagesOf (*slow, fingerTones (2, length, rate), 256).cwiseAbs().maxCoeff() > 1e-4);
}

TEST_CASE ("More fingers than ceramics are refused in a sentence", "[touch-plugin]")
{
    auto json = loadDocument (LibraryKind::device, "aluminium-200x120");
    json["ceramics"].erase (json["ceramics"].begin() + 2, json["ceramics"].end());
    const auto processor = offlineTouch (2, rate, 64);
    processor->load (touchDeviceFrom (json));
    processor->session().waitUntilSettled();
    CHECK (processor->warning().startsWith ("touch 3 points; allowed: at most 2"));
}
