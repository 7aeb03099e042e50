#include "IdleCeramics.h"

namespace antinode
{
ModalModel withoutDrive (ModalModel model, const std::vector<int>& idle)
{
    for (const auto ceramic : idle)
        model.participation.col (ceramic - 1).setZero();

    return model;
}
} // namespace antinode
