#include "IdleCeramicsOption.h"

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
} // namespace antinode
