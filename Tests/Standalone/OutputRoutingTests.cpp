#include <Standalone/OutputRouter.h>

#include "Support/ErrorText.h"

#include <catch2/catch.hpp>

#include <limits>

using namespace antinode;

TEST_CASE ("ceramic k is on output k at first and the monitor on none")
{
    const auto routing = straightRouting();

    for (std::size_t k = 0; k < routing.outputs.size(); ++k)
        CHECK (routing.outputs[k] == static_cast<int> (k));

    CHECK (routing.monitor == OutputRouting::none);
    CHECK_NOTHROW (validate (routing));
}

TEST_CASE ("a ceramic that gets an output takes it from the one that had it")
{
    const auto routing = withOutput (straightRouting(), 2, 5);
    CHECK (routing.outputs[2] == 5);
    CHECK (routing.outputs[5] == OutputRouting::none);
    CHECK_NOTHROW (validate (routing));
}

TEST_CASE ("monitor and ceramics never share an output")
{
    auto routing = withMonitor (straightRouting(), 8);
    CHECK (routing.outputs[8] == OutputRouting::none);
    CHECK (routing.outputs[9] == OutputRouting::none);
    CHECK (routing.outputs[10] == 10);
    CHECK_NOTHROW (validate (routing));

    routing = withOutput (routing, 8, 9);
    CHECK (routing.monitor == OutputRouting::none);
    CHECK_NOTHROW (validate (routing));
}

TEST_CASE ("a marker takes its output from a ceramic or the monitor, and each of them takes it back")
{
    auto routing = withMarker (withMonitor (straightRouting(), 8), { 3, 0.5, 0.005 });
    CHECK (routing.outputs[3] == OutputRouting::none);
    CHECK (routing.monitor == 8);
    CHECK_NOTHROW (validate (routing));
    routing = withMarker (routing, { 9, 0.5, 0.005 });
    CHECK (routing.monitor == OutputRouting::none);
    CHECK_NOTHROW (validate (routing));
    CHECK (withOutput (routing, 0, 9).marker.output == OutputRouting::none);
    CHECK (withMonitor (routing, 8).marker.output == OutputRouting::none);
    CHECK (withMarker (routing, { OutputRouting::none }).outputs == routing.outputs);
}

TEST_CASE ("a routing with an output that is used twice is refused")
{
    auto routing = straightRouting();
    routing.outputs[3] = 0;
    CHECK (errorText ([&] { validate (routing); }) == "ceramic 4: has output 1, which ceramic 1 uses already");
    routing.outputs[3] = OutputRouting::maximumOutputs;
    CHECK (errorText ([&] { validate (routing); }) == "ceramic 4: has output 129; allowed: 1 to 128");
}

TEST_CASE ("a chain with a gain or a polarity that is none is refused")
{
    for (const auto volts : { -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
    {
        auto routing = straightRouting();
        routing.chains[1].voltsPerFullScale = volts;
        CHECK (errorText ([&] { validate (routing); })
               == "output 2: has negative or invalid volts per full scale; allowed: 0 V or more");
    }

    auto routing = straightRouting();
    routing.chains[1].polarity = 0;
    CHECK (errorText ([&] { validate (routing); }) == "output 2: polarity is 0; allowed: 1 or -1");
}
