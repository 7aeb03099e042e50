#include "FingerInputs.h"

#include "OutputRouting.h"

#include <antinode_base/InputError.h>

#include <charconv>

namespace antinode
{
FingerInputs readFingerInputs (const std::string& list)
{
    FingerInputs read;
    read.inputs.fill (FingerInputs::none);
    const auto* at = list.data();
    const auto* const end = at + list.size();

    for (std::size_t k = 0;; ++k, ++at)
    {
        int number = 0;
        const auto [behind, error] = std::from_chars (at, end, number);
        const auto isLast = behind == end;

        if (error != std::errc() || number < 0 || number > OutputRouting::maximumOutputs || k >= read.inputs.size()
            || (! isLast && *behind != ','))
            throw InputError ("--inputs " + list,
                              "is no list of inputs; allowed: up to " + std::to_string (FingerInputs::fingers)
                                  + " numbers from 0 (none) to " + std::to_string (OutputRouting::maximumOutputs)
                                  + " with commas, the input of finger 1 first");

        read.inputs[k] = number - 1;
        at = behind;

        if (isLast)
            return read;
    }
}

FingerInputs sensorAlone()
{
    FingerInputs sensor;
    sensor.inputs.fill (FingerInputs::none);
    sensor.inputs.front() = FingerInputs::firstOpen;
    return sensor;
}
} // namespace antinode
