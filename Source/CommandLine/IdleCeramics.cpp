#include "IdleCeramics.h"

#include <antinode_base/InputError.h>

namespace antinode
{
void checkIdleCeramics (const std::vector<int>& idle, const ModalModel& model)
{
    for (const auto ceramic : idle)
        if (ceramic < 1 || ceramic > model.actuators())
            throw InputError ("--idle-ceramic", "is " + std::to_string (ceramic) + "; allowed: 1 to "
                                                    + std::to_string (model.actuators()));
}

ModalModel withoutDrive (ModalModel model, const std::vector<int>& idle)
{
    for (const auto ceramic : idle)
        model.participation.col (ceramic - 1).setZero();

    return model;
}
} // namespace antinode
