#pragma once

#include <antinode_model/ModalModel.h>

#include <vector>

namespace antinode
{
/** Refuses ceramics that a device does not have. @param idle  counted from 1 @throws InputError [any] */
void checkIdleCeramics (const std::vector<int>& idle, const ModalModel&);
} // namespace antinode
