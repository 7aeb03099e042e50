#pragma once

#include <antinode_model/ModalModel.h>

#include <vector>

namespace antinode
{
/** Refuses ceramics that a device does not have. @param idle  counted from 1 @throws InputError [any] */
void checkIdleCeramics (const std::vector<int>& idle, const ModalModel&);

/** A device whose idle ceramics move nothing: they listen. [any] */
ModalModel withoutDrive (ModalModel, const std::vector<int>& idle);
} // namespace antinode
