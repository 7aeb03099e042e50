#include "ElementChain.h"

#include "CeramicBond.h"
#include "DescriptionChecks.h"

#include <antinode_base/InputError.h>
#include <antinode_numerics/Quadrature.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

namespace antinode
{
namespace
{
/** A layer across a beam, its middle counted from that of the substrate. */
struct BeamLayer
{
    double youngsModulus = 0, shearModulus = 0, density = 0, width = 0, thickness = 0, middle = 0;

    double stretching() const { return youngsModulus * width * thickness; }
    double mass() const { return density * width * thickness; }
};

using BeamLayers = std::vector<BeamLayer>; ///< From the bottom up.

constexpr double shearFactor = 5.0 / 6; ///< Of a rectangle.

/** Where the neutral axis is: how far a ceramic on one side moves it out of the substrate's mid-plane, z_n. */
double neutralAxis (const BeamLayers& layers)
{
    double stretching = 0, coupling = 0;

    for (const auto& layer : layers)
    {
        stretching += layer.stretching();
        coupling += layer.stretching() * layer.middle;
    }

    return coupling / stretching;
}

/** The energy of the shear stress that balances a bending moment as it grows along the beam (Jourawski), as a
   stiffness: 5/6 G A of a rectangle. */
double shearStiffness (const BeamLayers& layers, double axis, double bendingStiffness)
{
    const auto rule = gaussLobattoRule (4); // Of a polynomial of the fourth degree.
    double below = 0, compliance = 0;

    for (const auto& layer : layers)
    {
        const auto bottom = layer.middle - layer.thickness / 2 - axis;
        const Eigen::ArrayXd height = layer.thickness / 2 * (rule.places.array() + 1);
        const Eigen::ArrayXd flow =
            below
            + layer.youngsModulus * layer.width * height * (bottom + height / 2); // Of a curvature of 1 per length.
        compliance +=
            (rule.weights.array() * flow.square()).sum() * layer.thickness / 2 / (layer.shearModulus * layer.width);
        below += layer.stretching() * (layer.middle - axis);
    }

    return bendingStiffness * bendingStiffness / compliance;
}

BeamSection sectionOf (const BeamLayers& layers, BendingTheory theory)
{
    BeamSection section;
    const auto axis = neutralAxis (layers);

    for (const auto& layer : layers)
    {
        const auto square = (layer.middle - axis) * (layer.middle - axis) + layer.thickness * layer.thickness / 12;
        section.massPerLength += layer.mass();
        section.bendingStiffness += layer.stretching() * square;
        section.axialStiffness += layer.stretching();

        if (theory == BendingTheory::thick)
            section.rotaryInertia += layer.mass() * square;
    }

    if (theory == BendingTheory::thick)
        section.shearStiffness = shearStiffness (layers, axis, section.bendingStiffness);

    return section;
}

double glueThickness (const CeramicDescription& ceramic)
{
    return ceramic.glue ? ceramic.glue->thickness : 0;
}

/** From the substrate's mid-plane to that of a ceramic, d. */
double midPlaneDistance (const StructureCommon& common, const CeramicDescription& ceramic)
{
    return (common.thickness + ceramic.thickness) / 2 + glueThickness (ceramic);
}

BeamLayer substrateLayer (const StructureCommon& common, double width)
{
    return { common.material.youngsModulus1,
             common.material.shearModulus,
             common.material.density,
             width,
             common.thickness,
             0 };
}

BeamLayer ceramicLayer (const StructureCommon& common, const CeramicDescription& ceramic, int side)
{
    return { ceramic.material.youngsModulus,
             ceramic.material.shearModulus(),
             ceramic.material.density,
             ceramic.sizeY,
             ceramic.thickness,
             side * midPlaneDistance (common, ceramic) };
}

BeamLayers layersOf (const StructureCommon& common, double width, const CeramicDescription& ceramic,
                     bool withCeramics = true)
{
    BeamLayers layers { substrateLayer (common, width) };

    for (const auto side : { 1, -1 })
    {
        if (side < 0 && ceramic.mounting == CeramicMounting::oneSide)
            break;

        const auto add = [&] (const BeamLayer& layer)
        { layers.insert (side > 0 ? layers.end() : layers.begin(), layer); };

        if (const auto& glue = ceramic.glue)
            add ({ glue->material.youngsModulus1, glue->material.shearModulus, glue->material.density, ceramic.sizeY,
                   glue->thickness, side * (common.thickness + glue->thickness) / 2 });

        if (withCeramics)
            add (ceramicLayer (common, ceramic, side));
    }

    return layers;
}
} // namespace

BeamSection bareSection (const StructureCommon& common, double width)
{
    return sectionOf ({ substrateLayer (common, width) }, common.theory);
}

BeamSection ceramicSection (const StructureCommon& common, double width, const CeramicDescription& ceramic)
{
    return sectionOf (layersOf (common, width, ceramic), common.theory);
}

BeamSection looseSection (const StructureCommon& common, double width, const CeramicDescription& ceramic)
{
    const auto whole = ceramicSection (common, width, ceramic);
    auto section = sectionOf (layersOf (common, width, ceramic, false), common.theory);
    const auto layer = ceramicLayer (common, ceramic, 1);
    const auto count = ceramic.mounting == CeramicMounting::oneSide ? 1 : 2;
    section.massPerLength = whole.massPerLength;
    section.rotaryInertia = whole.rotaryInertia;
    section.bendingStiffness += count * layer.stretching() * layer.thickness * layer.thickness / 12;
    section.shearStiffness += count * shearFactor * layer.shearModulus * layer.width * layer.thickness;
    return section;
}

double bondLength (const StructureCommon& common, double width, const CeramicDescription& ceramic)
{
    const auto compliance = bondCompliance (ceramic, common.theory) / ceramic.sizeY;
    const auto yields = 1 / (ceramic.material.youngsModulus * ceramic.sizeY * ceramic.thickness)
                        + (ceramic.mounting == CeramicMounting::oneSide
                               ? 1 / (common.material.youngsModulus1 * width * common.thickness)
                               : 0.0);
    const auto stiffening = ceramicSection (common, width, ceramic).bendingStiffness
                            / looseSection (common, width, ceramic).bendingStiffness;
    const auto length = std::sqrt (compliance / yields / stiffening);

    if (! (length > 0))
        return 0;

    return length * std::tanh (ceramic.sizeX / (2 * length));
}

double momentPerVolt (const StructureCommon& common, double width, const CeramicDescription& ceramic)
{
    const auto& material = ceramic.material;
    const auto fieldTimesThickness =
        material.fibres ? ceramic.thickness / material.fibres->electrodeDistance : 1.0; // Per volt.
    const auto forcePerVolt =
        ceramic.polarity * material.d31 * material.youngsModulus * ceramic.sizeY * fieldTimesThickness;
    const auto distance = midPlaneDistance (common, ceramic);

    if (ceramic.mounting == CeramicMounting::oneSide)
        return forcePerVolt * (distance - neutralAxis (layersOf (common, width, ceramic)));

    const auto ceramicsAtFullVoltage = ceramic.wiring == CeramicWiring::parallel ? 2.0 : 1.0;
    return ceramicsAtFullVoltage * forcePerVolt * distance;
}

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

namespace
{
/** Puts the stretches of a line one after the other; edges closer than the tolerance become one. */
class LineElements
{
public:
    LineElements (const StructureCommon& commonToUse, double widthToUse, double length)
        : common (commonToUse), width (widthToUse), position (-length / 2), end (length / 2)
    {
    }

    void addCeramic (int index)
    {
        const auto& ceramic = common.ceramics[static_cast<std::size_t> (index)];
        const auto right = ceramic.x + ceramic.sizeX, last = end - right > edgeTolerance ? right : end;
        const auto bond = bondLength (common, width, ceramic);
        addBareTo (ceramic.x);

        if (bond > edgeTolerance)
            add (position + bond, looseSection (common, width, ceramic), {});

        add (last - bond, ceramicSection (common, width, ceramic), index);

        if (bond > edgeTolerance)
            add (last, looseSection (common, width, ceramic), {});
    }

    std::vector<ChainElement> finish()
    {
        addBareTo (end);
        return std::move (elements);
    }

private:
    void addBareTo (double right)
    {
        if (right - position > edgeTolerance)
            add (right, bareSection (common, width), {});
    }

    void add (double right, const BeamSection& section, std::optional<int> ceramic)
    {
        elements.push_back ({ position, right - position, 1, 0, section, true, ceramic });
        position = right;
    }

    const StructureCommon& common;
    double width, position, end;
    std::vector<ChainElement> elements;
};

std::vector<ChainElement> lineElements (const StructureCommon& common, double width, double length)
{
    std::vector<int> order (common.ceramics.size());
    std::iota (order.begin(), order.end(), 0);
    const auto left = [&] (int index) { return common.ceramics[static_cast<std::size_t> (index)].x; };
    std::stable_sort (order.begin(), order.end(), [&] (int a, int b) { return left (a) < left (b); });

    LineElements line (common, width, length);

    for (const auto index : order)
        line.addCeramic (index);

    return line.finish();
}

Restraint toRestraint (EdgeCondition condition)
{
    const auto clamped = condition == EdgeCondition::clamped;
    return { clamped, clamped || condition == EdgeCondition::simplySupported,
             clamped || condition == EdgeCondition::guided };
}
} // namespace

ElementChain makeChain (const BeamDescription& beam)
{
    return { lineElements (beam.common, beam.width, beam.length), toRestraint (beam.left), toRestraint (beam.right),
             false, beam.common.theory == BendingTheory::thick };
}

ElementChain makeChain (const StapleDescription& staple)
{
    const auto clamped = toRestraint (EdgeCondition::clamped);
    ElementChain chain { lineElements (staple.common, staple.width, staple.topLength), clamped, clamped, true,
                         staple.common.theory == BendingTheory::thick };
    ChainElement leg { 0, staple.legLength, 0, 1, bareSection (staple.common, staple.width), false, {} };
    chain.elements.insert (chain.elements.begin(), leg);
    leg.sine = -1;
    chain.elements.push_back (leg);
    return chain;
}
} // namespace antinode
