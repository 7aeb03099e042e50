#pragma once

#include <Processor/StepParameters.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

namespace antinode::test
{
/** Sets all parameters to 1000 random values as a host does, and requires that each reads back what it keeps, and that
   another instance gets it back to the bit: as a share, and in the unit of its text. */
template <typename Processor>
void requireReadBack (const std::function<std::unique_ptr<Processor>()>& make)
{
    const auto first = make();
    std::unique_ptr<Processor> second;
    juce::Random random (7);

    for (int i = 0; i < 1000; ++i)
    {
        if (i % 50 == 0)
            second = make();

        for (auto* const parameter : first->parameters().all())
        {
            // Hosts have 24 bits: a smaller share is the end of the range.
            const auto share =
                i % 2 == 0 ? random.nextFloat() : std::max (std::pow (random.nextFloat(), 8.0F), 0x1p-24F);
            parameter->setValueNotifyingHost (share);
            const auto& asHostsSee = static_cast<const juce::AudioProcessorParameter&> (*parameter);

            if (! hasSteps (*parameter))
                REQUIRE (asHostsSee.getValue() == share);
            else
                REQUIRE (parameter->convertTo0to1 (parameter->convertFrom0to1 (share)) == asHostsSee.getValue());
        }

        juce::MemoryBlock kept, again;
        first->getStateInformation (kept);
        second->setStateInformation (kept.getData(), static_cast<int> (kept.getSize()));
        second->getStateInformation (again);
        REQUIRE (kept == again);
        REQUIRE (first->parameters().values() == second->parameters().values());

        for (std::size_t k = 0; k < first->parameters().all().size(); ++k)
        {
            const juce::AudioProcessorParameter &one = *first->parameters().all()[k],
                                                &other = *second->parameters().all()[k];
            INFO (one.getName (100));
            REQUIRE (one.getValue() == other.getValue());
        }
    }
}
} // namespace antinode::test
