#pragma once

#include "Design.h"

namespace antinode
{
/** What of the playback a request leaves open. */
struct LeftOpen
{
    bool sampleRate = false, reconstruction = false;
};

/** A design that was written before, on the device of the request, or, where that is left open, on the one that it
   names.
    @param assignments  values of keys of the device
    @throws InputError  for a file that cannot be read, for a playback that it cannot be played by, and for overridden
                        keys of a focus, which is designed already
    [worker] */
DesignedFocus writtenDesign (FocusRequest, const LeftOpen&, const std::filesystem::path& file,
                             const std::string& device, const std::vector<std::string>& assignments);
} // namespace antinode
