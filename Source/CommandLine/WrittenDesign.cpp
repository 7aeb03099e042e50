#include "WrittenDesign.h"

#include "FocusOnDevice.h"

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
void requirePlayback (const CommonOptions& options, const std::string& file, Playback designed)
{
    const auto asked = options.playback();

    if (asked.sampleRate != designed.sampleRate || asked.reconstruction != designed.reconstruction)
        throw InputError (file, "has samples of " + inWords (designed.sampleRate) + " Hz, "
                                    + wordOf (designed.reconstruction) + ", and " + inWords (asked.sampleRate) + " Hz, "
                                    + wordOf (asked.reconstruction)
                                    + " are asked for; allowed: as it was designed, or a new design");
}
} // namespace

void completeFrom (CommonOptions& options, const std::string& designFile)
{
    const auto origin = readDesignOrigin (readJsonFile (designFile), designFile);

    for (const auto& assignment : options.assignments)
        if (assignment.starts_with ("focus."))
            throw InputError ("--set " + assignment, "changes a focus that is designed already; allowed with --design: "
                                                     "device.KEY=VALUE, or a new design");

    if (options.device.empty())
        options.device = origin.device;

    if (! options.rate)
        options.rate = origin.playback.sampleRate;

    if (! options.reconstruction)
        options.reconstruction = wordOf (origin.playback.reconstruction);

    if (origin.isSampled)
        requirePlayback (options, designFile, origin.playback);
}

WideDesign writtenDesign (const CommonOptions& options, const std::string& designFile)
{
    const auto document = readJsonFile (designFile);
    const auto focus = readDesignOrigin (document, designFile).focus;
    const auto model = modelFrom (options);
    auto wide = playedUnderFingers (wideFrom (options, model), focus.fingers);
    auto design = readDesign (document, designFile, designedModel (wide));
    return { std::move (wide), std::move (design) };
}
} // namespace antinode
