#include "WrittenDesign.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>
#include <antinode_documents/DesignFile.h>
#include <antinode_library/Inputs.h>
#include <antinode_text/JsonText.h>

#include <nlohmann/json.hpp>

#include <utility>

namespace antinode
{
namespace
{
std::string wordOf (Reconstruction reconstruction)
{
    return reconstruction == Reconstruction::bandLimited ? "band_limited" : "zero_order_hold";
}

/** Samples do what they were designed for in one way only. */
void requirePlayback (Playback asked, const std::string& file, Playback designed)
{
    if (asked.sampleRate != designed.sampleRate || asked.reconstruction != designed.reconstruction)
        throw InputError (file, "has samples of " + inWords (designed.sampleRate) + " Hz, "
                                    + wordOf (designed.reconstruction) + ", and " + inWords (asked.sampleRate) + " Hz, "
                                    + wordOf (asked.reconstruction)
                                    + " are asked for; allowed: as it was designed, or a new design");
}
} // namespace

DesignedFocus writtenDesign (FocusRequest request, const LeftOpen& opens, const std::filesystem::path& path,
                             const std::string& device, const std::vector<std::string>& assignments)
{
    const auto file = path.string();
    const auto document = readJsonFile (file);
    const auto origin = readDesignOrigin (document, file);

    for (const auto& assignment : assignments)
        if (assignment.starts_with ("focus."))
            throw InputError ("--set " + assignment, "changes a focus that is designed already; allowed with --design: "
                                                     "device.KEY=VALUE, or a new design");

    checkAssignments (assignments);
    request.device = loadDevice (device.empty() ? origin.device : device, assignments);

    if (opens.sampleRate)
        request.sampleRate = origin.playback.sampleRate;

    if (opens.reconstruction)
        request.reconstruction = wordOf (origin.playback.reconstruction);

    const auto playback = playbackOf (request);

    if (origin.isSampled)
        requirePlayback (playback, file, origin.playback);

    auto wide = playedUnderFingers (setUp (request.device, playback, request.usesCache).wide, origin.focus.fingers);
    auto design = readDesign (document, file, designedModel (wide));
    return { { std::move (wide), std::move (design) }, playback, request.repetitions, request.thresholdFile };
}
} // namespace antinode
