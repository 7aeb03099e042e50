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
    // EI k^4 - (I + mu EI / S) omega^2 k^2 - mu omega^2 (1 - I omega^2 / S) = 0, of a thin section with S infinite.
    const auto square = angularFrequency * angularFrequency;
    const auto mass = section.massPerLength * square, inertia = section.rotaryInertia * square;
    const auto bending = section.bendingStiffness, shear = section.shearStiffness;
    const auto b = inertia + mass * (bending / shear), c = mass * (1 - inertia / shear);
    return std::sqrt ((b + std::sqrt (b * b + 4 * bending * c)) / (2 * bending));
}

double angularFrequencyOfHalfWaves (const ElementChain& chain, double halfWaves)
{
    constexpr double exact = 1e-3; // It is an estimate.
    double low = 0, high = 1;

    while (halfWavesAt (chain, high) < halfWaves)
        high *= 2;

    while (high - low > exact * high)
    {
        const auto middle = (low + high) / 2;
        (halfWavesAt (chain, middle) < halfWaves ? low : high) = middle;
    }

    return high;
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
    ElementChain result { {}, chain.start, chain.end, chain.stretches, chain.shears };

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
