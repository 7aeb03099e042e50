#include "TouchFoci.h"

#include "Amplifiers.h"
#include "NoteBank.h"
#include "WrittenDesign.h"

#include <antinode_base/Watch.h>
#include <antinode_focus/WideDesign.h>
#include <antinode_library/Library.h>

#include <utility>

namespace antinode
{
void TouchFoci::load (std::shared_ptr<const FocusDocument> focus)
{
    const std::lock_guard lock (mutex);
    wanted = std::move (focus);
}

std::shared_ptr<const FocusDocument> TouchFoci::focus() const
{
    const std::lock_guard lock (mutex);
    return wanted;
}

DesignProgress TouchFoci::progress() const
{
    const std::lock_guard lock (mutex);
    return designs;
}

void TouchFoci::serve (TouchPath& path, const std::shared_ptr<const DeviceDocument>& device,
                       const std::vector<double>& amplifiers, bool isPathNew)
{
    if (const auto now = focus(); std::exchange (served, now) != now || isPathNew)
    {
        error.clear();
        meaning = NoteMeaning::nothing;

        try
        {
            if (served != nullptr)
                request (path, device, amplifiers);
        }
        catch (const Cancelled&)
        {
            throw;
        }
        catch (const std::exception& failure)
        {
            error = failure.what();
        }
    }

    auto now = served != nullptr && error.empty() ? path.foci().progress() : DesignProgress {};

    if (! error.empty())
        now.liveError = error;

    const std::lock_guard lock (mutex);
    designs = std::move (now);
}

void TouchFoci::request (TouchPath& path, const std::shared_ptr<const DeviceDocument>& device,
                         const std::vector<double>& amplifiers)
{
    if (std::exchange (solvedDevice, device) != device)
        solved = std::make_shared<const ModalModel> (solveDevice (device->description, {}, true));

    const auto& description = served->description;
    const auto model = withAmplifiers (solved, amplifiers);
    const auto rate = path.sampleRate();
    auto written = writtenFor (*served, description);
    const auto& spot = description.targets.front();
    auto places = written != nullptr ? std::vector<std::pair<double, double>>()
                                     : spreadNotes (model->surface, { spot.x, spot.y });
    auto designed = model;

    if (! description.fingers.empty())
        designed = std::make_shared<const ModalModel> (
            *loadedByFingers ({ *model, model->modes(), {}, {} }, description.fingers).designed);

    path.foci().request ({ designed,
                           description,
                           std::move (places),
                           { spotNote },
                           { Reconstruction::bandLimited, rate },
                           description.fingers.empty() ? modesBeyond (device, model, rate) : nullptr,
                           written });
    meaning = written != nullptr ? NoteMeaning::spotOnly : NoteMeaning::spread;
}
} // namespace antinode
