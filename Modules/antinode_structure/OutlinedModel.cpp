#include "OutlinedModel.h"

#include <antinode_base/InputError.h>

namespace antinode
{
ModalModel solveOutlinedPlate (const std::string& name, const OutlinedPlate&, std::optional<int>)
{
    throw InputError ("device '" + name + "'", "has an outline, which is not solved yet");
}
} // namespace antinode
