#pragma once

#include "DeviceDescription.h"

namespace antinode
{
/** Brings modes into ascending order. [any] */
void sortByFrequency (std::vector<MeasuredMode>&);

/** The model of a drawn device of which modes were measured: shapes as they are drawn, all else as it was measured.
    @param drawn  what the drawing's solution gives
    @param share  how many of its last shapes are the static share of modes beyond: they stay, each ceramic's as much
                  larger as its participations are
    @throws InputError  where it has not all the modes or ceramics
    [worker] */
ModalModel measuredModel (const MeasuredDevice&, const ModalModel& drawn, Eigen::Index share = 0);

/** What of a drawn device has changed from one model to another, as what was measured of it.
    @param before  as solveStructure gives it for the device
    @return        none where the device was not drawn, or has other shapes or points now
    [worker] */
std::optional<MeasuredDevice> measuredChanges (const DeviceDescription&, const ModalModel& before,
                                               const ModalModel& now);
} // namespace antinode
