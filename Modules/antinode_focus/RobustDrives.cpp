#include "RobustDrives.h"

#include "Transients.h"

namespace antinode
{
DriveList fasterDrives (const ModalModel& model, const std::vector<int>& modes, double focusTime,
                        const TransientChoice& choice)
{
    constexpr auto times = 3.0;
    DriveList drives;

    if (! choice.growth.empty())
        return drives;

    auto faster = choice;

    for (const auto& drive : driveModes (model, modes, focusTime, choice))
        faster.growth.push_back (times * drive.growth);

    for (const auto& drive : driveModes (model, modes, focusTime, faster))
        drives.push_back (drive.oscillations);

    return drives;
}
} // namespace antinode
