#include "CeramicPatches.h"

#include "CeramicBond.h"

#include "PatchShapes.h"

namespace antinode
{
namespace
{
BendingPatch patchOf (const CeramicDescription& ceramic)
{
    switch (ceramic.shape)
    {
        case CeramicShape::rectangle:
            return rectanglePatch (ceramic.centre(), { ceramic.sizeX, ceramic.sizeY }, ceramic.angle);
        case CeramicShape::disc:
            return discPatch (ceramic.centre(), ceramic.sizeX / 2);
        case CeramicShape::ring:
            return ringPatch (ceramic.centre(), ceramic.sizeX / 2, ceramic.innerDiameter / 2);
    }

    return {};
}

/** What one section has more than another. */
BendingSection difference (const LayeredSection& with, const LayeredSection& without)
{
    return { (with.stiffness - without.stiffness).real(), with.massPerArea - without.massPerArea };
}
} // namespace

BendingSection bendingSection (const PlateSection& section)
{
    BendingSection result;
    result.stiffness << section.d11, section.d12, 0, section.d12, section.d22, 0, 0, 0, section.d66;
    result.massPerArea = section.massPerArea;
    return result;
}

std::vector<BendingPatch> ceramicPatches (const StructureCommon& common, const CeramicDescription& ceramic)
{
    const auto with = sectionWith (common, ceramic, ceramic.angle);
    auto patch = patchOf (ceramic);

    if (! ceramic.carrier)
    {
        const auto bond = ceramicBond (common, ceramic, ceramic.angle);
        const auto& everywhere = bond ? bond->loose : with;
        patch.added = difference (everywhere, bareStack (common));
        patch.added.rotaryInertia = addedRotaryInertia (common, ceramic);
        patch.moment = everywhere.momentPerVolt.real();

        if (bond)
            patch.bonded = bond->part;

        return { patch };
    }

    // With larger cells than on other patches frequencies change by 1e-5, and there may be dozens of benders.
    constexpr double coarser = 1.4;
    const auto carrier = sectionWith (common, ceramic, 0, { false, true });
    const auto bond = ceramicBond (common, ceramic, 0, false);
    auto inner = discPatch (ceramic.centre(), ceramic.carrier->ceramicDiameter / 2);
    auto driven = discPatch (ceramic.centre(), ceramic.carrier->electrodeDiameter / 2);
    patch.added = difference (bond ? bond->loose : carrier, bareStack (common));
    patch.added.rotaryInertia = addedRotaryInertia (common, ceramic, false);
    inner.added = difference (with, carrier);
    inner.added.rotaryInertia = addedRotaryInertia (common, ceramic) - patch.added.rotaryInertia;

    if (bond)
        patch.bonded = bond->part;

    patch.kinks.front().width = inner.kinks.front().width = coarser * ceramic.sizeX / 2;
    driven.moment = with.momentPerVolt.real();
    driven.kinks.clear(); // Only what stiffens bends a mode.
    return { patch, inner, driven };
}
} // namespace antinode
