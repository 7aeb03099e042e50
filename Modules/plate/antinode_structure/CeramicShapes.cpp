#include "CeramicShapes.h"

#include <antinode_outline/OutlineShapes.h>

#include <numbers>

namespace antinode
{
double faceArea (const CeramicDescription& ceramic)
{
    if (ceramic.carrier)
        return std::numbers::pi / 4 * ceramic.carrier->electrodeDiameter * ceramic.carrier->electrodeDiameter;

    const auto rectangle = ceramic.sizeX * ceramic.sizeY;

    if (ceramic.shape == CeramicShape::rectangle)
        return rectangle;

    const auto hole = ceramic.shape == CeramicShape::ring ? ceramic.innerDiameter * ceramic.innerDiameter : 0;
    return std::numbers::pi / 4 * (rectangle - hole);
}

bool fillsItsRectangle (const CeramicDescription& ceramic)
{
    return ceramic.shape == CeramicShape::rectangle && ceramic.angle == 0;
}

Outline ceramicOutline (const CeramicDescription& ceramic)
{
    const auto centre = ceramic.centre();

    switch (ceramic.shape)
    {
        case CeramicShape::rectangle:
            return { { rectanglePath (centre, { ceramic.sizeX, ceramic.sizeY }, ceramic.angle, { 0, 0, 0, 0 }, 0) } };
        case CeramicShape::disc:
            return { { circlePath (centre, ceramic.sizeX / 2, 0) } };
        case CeramicShape::ring:
            return { { circlePath (centre, ceramic.sizeX / 2, 0), circlePath (centre, ceramic.innerDiameter / 2, 1) } };
    }

    return {};
}

OutlineExtent ceramicExtent (const CeramicDescription& ceramic)
{
    if (fillsItsRectangle (ceramic))
        return { { ceramic.x, ceramic.y }, { ceramic.x + ceramic.sizeX, ceramic.y + ceramic.sizeY } };

    return extentOf (ceramicOutline (ceramic));
}
} // namespace antinode
