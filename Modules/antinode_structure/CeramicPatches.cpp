#include "CeramicPatches.h"

#include <antinode_immersed/PatchShapes.h>

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
    const auto section = ceramicSection (common, ceramic);
    const auto bare = bendingSection (bareSection (common)), with = bendingSection (section);
    auto patch = patchOf (ceramic);
    patch.added.stiffness = with.stiffness - bare.stiffness;
    patch.added.massPerArea = with.massPerArea - bare.massPerArea;
    patch.moment << section.momentX, section.momentY, 0;
    return { patch };
}
} // namespace antinode
