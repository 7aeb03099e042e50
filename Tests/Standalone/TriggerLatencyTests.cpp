#include <Standalone/StandaloneHost.h>

#include <catch2/catch.hpp>

using namespace antinode;

TEST_CASE ("The latency of a note is the sum of focus time, block and output, and its largest part is what to lower")
{
    const TriggerLatency focus { 0.025, 256 / 48000.0, 512 / 48000.0 };
    CHECK (latencyInWords (focus) == "focus 41.0 ms after a note: 25.0 focus time, 5.3 block, 10.7 output");
    CHECK (latencyAdvice (focus).contains ("shorter focus time"));
    const TriggerLatency device { 0.005, 1024 / 48000.0, 0 };
    CHECK (latencyInWords (device) == "focus 26.3 ms after a note: 5.0 focus time, 21.3 block, 0.0 output");
    CHECK (latencyAdvice (device).contains ("smaller block"));
}

TEST_CASE ("Without an open device no latency is told")
{
    StandaloneHost host (SettingsFile ({}), false);
    CHECK_FALSE (triggerLatency (host).has_value());
}
