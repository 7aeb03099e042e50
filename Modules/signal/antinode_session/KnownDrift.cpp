#include "KnownDrift.h"

#include <antinode_model/ModalModel.h>

#include <utility>

namespace antinode
{
ModalModel DriftedDevice::asDriven (ModalModel model) const
{
    if (drift != nullptr)
        model = retunedModel (model, drift->sensed.estimate, drift->layout);

    return withoutDrive (std::move (model), idle);
}

std::shared_ptr<const ModalModel> DriftedDevice::asDriven (const std::shared_ptr<const ModalModel>& model) const
{
    const auto isAsDescribed = drift == nullptr && idle.empty();
    return isAsDescribed ? model : std::make_shared<const ModalModel> (asDriven (*model));
}
} // namespace antinode
