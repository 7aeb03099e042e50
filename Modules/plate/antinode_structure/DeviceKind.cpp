#include "DeviceKind.h"

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
} // namespace antinode
