#include "ElementChain.h"

#include <antinode_base/InputError.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antinode
{
void throwNumbersTooFarApart()
{
    throw InputError ("device",
                      "has dimensions or material constants of such different size that its modes cannot be computed");
}

double bendingWaveNumber (const BeamSection& section, double angularFrequency)
{
    return std::sqrt (angularFrequency * std::sqrt (section.massPerLength / section.bendingStiffness));
}

double angularFrequencyOfHalfWaves (const ElementChain& chain, double halfWaves)
{
    const auto ratio = halfWaves / halfWavesAt (chain, 1);
    return ratio * ratio;
}

double halfWavesAt (const ElementChain& chain, double angularFrequency)
{
    double phase = 0;

    for (const auto& element : chain.elements)
        phase += bendingWaveNumber (element.section, angularFrequency) * element.length;

    return phase / std::numbers::pi;
}

ElementChain subdivided (const ElementChain& chain, double angularFrequency)
{
    constexpr double largestPhase = 2.4; // rad

    constexpr double absurdPhase = 1e6; // rad
    ElementChain result { {}, chain.start, chain.end, chain.stretches };

    for (const auto& element : chain.elements)
    {
        const auto phase = bendingWaveNumber (element.section, angularFrequency) * element.length;

        // Written so that it catches a phase that is not a number, too.
        if (! (phase < absurdPhase && std::isfinite (element.section.bendingStiffness)))
            throwNumbersTooFarApart();

        const auto parts = static_cast<int> (std::ceil (std::max (phase / largestPhase, 1.0)));
        auto part = element;
        part.length = element.length / parts;

        for (int i = 0; i < parts; ++i)
        {
            part.start = element.start + i * part.length;
            result.elements.push_back (part);
        }
    }

    return result;
}
} // namespace antinode
