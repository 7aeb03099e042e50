#include "OutputRouting.h"

#include <antinode_base/InputError.h>

#include <cmath>
#include <numeric>
#include <string>
#include <vector>

namespace antinode
{
namespace
{
bool isMonitorOutput (const OutputRouting& routing, int output)
{
    return routing.monitor != OutputRouting::none && output >= routing.monitor
           && output < routing.monitor + OutputRouting::monitors;
}

void validateChains (const OutputRouting& routing)
{
    for (std::size_t i = 0; i < routing.chains.size(); ++i)
    {
        const auto& chain = routing.chains[i];
        const auto name = "output " + std::to_string (i + 1);

        if (! (chain.voltsPerFullScale >= 0 && std::isfinite (chain.voltsPerFullScale)))
            throw InputError (name, "has negative or invalid volts per full scale; allowed: 0 V or more");

        if (chain.polarity != 1 && chain.polarity != -1)
            throw InputError (name, "polarity is " + std::to_string (chain.polarity) + "; allowed: 1 or -1");
    }
}
} // namespace

OutputRouting straightRouting()
{
    OutputRouting routing;
    std::iota (routing.outputs.begin(), routing.outputs.end(), 0);
    return routing;
}

OutputRouting withOutput (OutputRouting routing, int ceramic, int output)
{
    if (output != OutputRouting::none)
        for (auto& other : routing.outputs)
            if (other == output)
                other = OutputRouting::none;

    if (isMonitorOutput (routing, output))
        routing.monitor = OutputRouting::none;

    routing.outputs[static_cast<std::size_t> (ceramic)] = output;
    return routing;
}

OutputRouting withMonitor (OutputRouting routing, int firstOutput)
{
    routing.monitor = firstOutput;

    for (auto& output : routing.outputs)
        if (isMonitorOutput (routing, output))
            output = OutputRouting::none;

    return routing;
}

std::vector<double> amplifierVoltages (const OutputRouting& routing)
{
    std::vector<double> volts;

    for (const auto output : routing.outputs)
        volts.push_back (
            output == OutputRouting::none ? 0 : routing.chains[static_cast<std::size_t> (output)].voltsPerFullScale);

    return volts;
}

void validate (const OutputRouting& routing)
{
    std::vector<std::string> users (OutputRouting::maximumOutputs);
    const auto use = [&] (int output, const std::string& user)
    {
        if (output < 0 || output >= OutputRouting::maximumOutputs)
            throw InputError (user, "has output " + std::to_string (output + 1) + "; allowed: 1 to "
                                        + std::to_string (OutputRouting::maximumOutputs));

        auto& other = users[static_cast<std::size_t> (output)];

        if (! other.empty())
            throw InputError (user, "has output " + std::to_string (output + 1) + ", which " + other + " uses already");

        other = user;
    };

    for (std::size_t k = 0; k < routing.outputs.size(); ++k)
        if (routing.outputs[k] != OutputRouting::none)
            use (routing.outputs[k], "ceramic " + std::to_string (k + 1));

    if (routing.monitor != OutputRouting::none)
        for (int i = 0; i < OutputRouting::monitors; ++i)
            use (routing.monitor + i, "monitor " + std::to_string (i + 1));

    validateChains (routing);
}
} // namespace antinode
