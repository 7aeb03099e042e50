#pragma once

#include <antinode_model/ModalModel.h>

#include <memory>
#include <vector>

namespace antinode
{
/** A device whose ceramics are also limited by what amplifiers give. @param volts  of a full-scale sample of each
    ceramic; 0 or missing: the device's [any] */
std::shared_ptr<const ModalModel> withAmplifiers (const std::shared_ptr<const ModalModel>&,
                                                  const std::vector<double>& volts);
} // namespace antinode
