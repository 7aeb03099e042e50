#include "LearningBench.h"
#include "Support/ErrorText.h"

#include <antinode_learning/LearnModes.h>

#include <catch2/catch.hpp>

#include <functional>
#include <limits>

using namespace antinode;
using namespace antinode::test;

TEST_CASE ("Sensors that are swapped, silent or clipped are refused, and the first design stays", "[learning]")
{
    const Bench bench (0.005, 1);
    const auto isRefused = [&] (const std::function<void (PlayedRecording&)>& spoil)
    {
        const auto learnt = learn (bench,
                                   [&] (const Eigen::MatrixXd& volts, int pass)
                                   {
                                       auto recording = bench (volts, pass);
                                       spoil (recording);
                                       return recording;
                                   });
        return ! learnt.refusal.empty()
               && learnt.wide.model.angularFrequencies == bench.nominal.model.angularFrequencies
               && peakVoltage (learnt.design) == peakVoltage (learnt.passes.front().design);
    };
    CHECK (isRefused ([] (PlayedRecording& r) { r.signals.row (0).swap (r.signals.row (2)); }));
    CHECK (isRefused ([] (PlayedRecording& r) { r.signals.setZero(); }));
    CHECK (isRefused ([] (PlayedRecording& r) { r.signals *= 1e-6, r.noise *= 1e-6; }));
    CHECK (isRefused (
        [] (PlayedRecording& r)
        {
            const auto most = r.signals.cwiseAbs().maxCoeff() / 50;
            r.signals = r.signals.cwiseMin (most).cwiseMax (-most);
        }));
}

TEST_CASE ("Recordings that are not usable are refused in a sentence", "[learning]")
{
    const Bench bench (0.005, 1);
    const auto message = [&] (const std::function<void (PlayedRecording&)>& spoil)
    {
        return errorText (
            [&]
            {
                learn (bench,
                       [&] (const Eigen::MatrixXd& volts, int pass)
                       {
                           auto recording = bench (volts, pass);
                           spoil (recording);
                           return recording;
                       });
            });
    };
    CHECK (message ([] (PlayedRecording& r) { r.signals (0, 5) = std::numeric_limits<double>::quiet_NaN(); })
           == "recordings: need a finite signal of every sensor, as long as the voltages");
    CHECK (message ([] (PlayedRecording& r) { r.signals.conservativeResize (2, Eigen::NoChange); })
           == "recordings: need a finite signal of every sensor, as long as the voltages");
    CHECK (message ([] (PlayedRecording& r) { r.noise.setZero(); })
           == "recordings: need noise above 0, a sample rate above 0 and a delay of 0 or more");
}
