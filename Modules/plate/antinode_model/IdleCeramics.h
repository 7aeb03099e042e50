#pragma once

#include "ModalModel.h"

#include <vector>

namespace antinode
{
/** A device whose idle ceramics move nothing: they listen.
    @param idle  counted from 1; each is on the device
    [any] */
ModalModel withoutDrive (ModalModel, const std::vector<int>& idle);
} // namespace antinode
