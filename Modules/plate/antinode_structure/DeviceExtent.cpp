#include "DescribedModel.h"

namespace antinode
{
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
