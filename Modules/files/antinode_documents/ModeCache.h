#pragma once

#include "ModeCacheKey.h"

#include <cstdint>
#include <filesystem>
#include <optional>

namespace antinode
{
/** Solved modes, kept in a folder from one run of the program to the next. Docs/FileFormats.md.

    It never gets in the way: what cannot be read is not there, what cannot be written is not kept. Several threads and
    processes may share a folder; an entry appears under its name only when it is complete.
*/
class ModeCache
{
public:
    /** @param folder        made where it is missing, when something is stored; for its user only
        @param maximumBytes  what the entries may take together [any] */
    explicit ModeCache (std::filesystem::path folder, std::uintmax_t maximumBytes = 1000000000);

    /** The model that was stored for this description and count, the same to the bit; none if there is none that can be
        trusted, or the device gives its modes itself. [worker] */
    std::optional<ModalModel> find (const DeviceDescription&, std::optional<int> modeCount,
                                    SolvedShapes shapes = SolvedShapes::modes) const;

    /** Keeps what was solved for this description and count, and removes what was not used for the longest
       time until all entries are within the limit. [worker] */
    void store (const DeviceDescription&, std::optional<int> modeCount, const ModalModel&,
                SolvedShapes shapes = SolvedShapes::modes) const;

private:
    void removeOldest() const;

    std::filesystem::path folder;
    std::uintmax_t maximumBytes;
};

/** The folder of cached modes: $XDG_CACHE_HOME/antinode/modes, else $HOME/.cache/antinode/modes; none if neither is
   set. [any] */
std::optional<std::filesystem::path> userCacheFolder();

/** solveStructure or solveWithStaticShare, unless the cache has it already.
    @param cache  none: always solved
    @throws InputError, Cancelled  as solveStructure [worker] */
ModalModel solveCached (const DeviceDescription&, std::optional<int> modeCount, const ModeCache* cache,
                        SolvedShapes shapes = SolvedShapes::modes);
} // namespace antinode
