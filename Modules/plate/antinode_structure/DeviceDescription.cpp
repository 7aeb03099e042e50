#include "DeviceDescription.h"

#include "DescribedModel.h"

#include <antinode_base/InputError.h>

#include <string>

namespace antinode
{
namespace
{
struct KindWord
{
    const char* operator() (const BeamDescription&) const { return "beam"; }
    const char* operator() (const StapleDescription&) const { return "staple"; }
    const char* operator() (const PlateDescription&) const { return "plate"; }
    const char* operator() (const OutlinedPlate&) const { return "plate"; }
    const char* operator() (const ModalModel&) const { return "modal"; }
    const char* operator() (const MeasuredDevice& measured) const { return deviceKind (*measured.drawing); }
};
} // namespace

bool isComputed (const DeviceDescription& device)
{
    return std::visit (
        [] (const auto& body)
        {
            return requires
            {
                body.common;
            };
        },
        device.body);
}

const char* deviceKind (const DeviceDescription& device)
{
    return std::visit (KindWord {}, device.body);
}

void requirePlateModes (int count)
{
    if (count < 1 || count > maximumPlateModes)
        throw InputError ("device", "number of modes is " + std::to_string (count) + "; allowed: 1 to "
                                        + std::to_string (maximumPlateModes));
}

namespace
{
struct Extent
{
    Surface operator() (const BeamDescription& beam) const { return line (beam.length); }
    Surface operator() (const StapleDescription& staple) const { return line (staple.topLength); }
    Surface operator() (const ModalModel& model) const { return model.surface; }
    Surface operator() (const MeasuredDevice& measured) const { return deviceExtent (*measured.drawing); }

    Surface operator() (const PlateDescription& plate) const
    {
        Surface surface;
        surface.kind = SurfaceKind::plate;
        surface.xMaximum = plate.lengthX;
        surface.yMaximum = plate.lengthY;
        surface.held = { isHeld (plate.left), isHeld (plate.right), isHeld (plate.bottom), isHeld (plate.top) };
        return surface;
    }

    Surface operator() (const OutlinedPlate& plate) const { return outlinedSurface (plate); }

    static Surface line (double length)
    {
        Surface surface;
        surface.xMinimum = -length / 2;
        surface.xMaximum = length / 2;
        return surface;
    }
};
} // namespace

Surface deviceExtent (const DeviceDescription& device)
{
    return std::visit (Extent {}, device.body);
}
} // namespace antinode
