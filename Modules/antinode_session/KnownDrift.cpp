#include "KnownDrift.h"

#include <antinode_model/IdleCeramics.h>

#include <utility>

namespace antinode
{
ModalModel TrackedDevice::asDriven (ModalModel model) const
{
    if (drift != nullptr)
        model = retunedModel (model, drift->tracked.estimate, drift->layout);

    return withoutDrive (std::move (model), idle);
}
} // namespace antinode
