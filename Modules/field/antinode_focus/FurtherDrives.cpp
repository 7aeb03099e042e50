#include "FurtherDrives.h"

#include "Transients.h"

#include <numbers>

namespace antinode
{
namespace
{
/** The drives of driveModes with other growths than it would choose. */
std::vector<ModeDrive> steeperDrives (const ModalModel& model, const std::vector<int>& modes, double focusTime,
                                      const TransientChoice& choice)
{
    constexpr auto times = 3.0;
    auto steeper = choice;

    for (const auto& drive : driveModes (model, modes, focusTime, choice))
        steeper.growth.push_back (times * drive.growth);

    return driveModes (model, modes, focusTime, steeper);
}

/** An offset-free drive that is a quarter period later; empty if it would begin before the trigger. */
std::vector<Oscillation> shifted (const ModeDrive& drive, DriveStart start)
{
    auto oscillation = drive.oscillations.front();
    const auto quarter = 0.5 * std::numbers::pi / oscillation.angularFrequency;
    oscillation.start += drive.cycles > 0 ? quarter : -quarter;

    if (oscillation.start < 0)
        return {};

    return playedDrive ({ oscillation }, start);
}

void append (DriveList& list, const std::vector<ModeDrive>& drives)
{
    for (const auto& drive : drives)
        list.push_back (drive.oscillations);
}

void appendShifted (DriveList& list, const std::vector<ModeDrive>& drives, DriveStart start)
{
    for (const auto& drive : drives)
        if (auto other = shifted (drive, start); ! other.empty())
            list.push_back (std::move (other));
}
} // namespace

DriveList fasterDrives (const ModalModel& model, const std::vector<int>& modes, double focusTime,
                        const TransientChoice& choice)
{
    DriveList drives;

    if (choice.growth.empty())
        append (drives, steeperDrives (model, modes, focusTime, choice));

    return drives;
}

DriveList furtherDrives (const ModalModel& model, const std::vector<int>& modes, double focusTime,
                         const TransientChoice& choice)
{
    auto drives = fasterDrives (model, modes, focusTime, choice);
    const auto start = driveStart (model);
    appendShifted (drives, driveModes (model, modes, focusTime, choice), start);

    if (choice.growth.empty())
        appendShifted (drives, steeperDrives (model, modes, focusTime, choice), start);

    return drives;
}
} // namespace antinode
