#pragma once

#include <antinode_model/ModalModel.h>
#include <antinode_structure/DeviceDescription.h>

namespace antinode
{
/** A device as tracks are designed for it and as it judges them: with half as many modes again, where it is solved. */
struct TrackModels
{
    ModalModel known, judge;
};

/** @param usesCache  of solved devices @throws InputError  where the device cannot be solved [worker] */
TrackModels trackModels (const DeviceDescription&, bool usesCache);
} // namespace antinode
