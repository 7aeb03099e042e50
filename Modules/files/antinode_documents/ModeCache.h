#pragma once

#include <antinode_model/ModalModel.h>
#include <antinode_structure/DeviceDescription.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace antinode
{
/** What a device is solved for. */
enum class SolvedShapes
{
    modes,           ///< As solveStructure.
    withStaticShare, ///< As solveWithStaticShare.
    onPointsOfFewer ///< As solveOutlinedOnPointsOfFewer: all that an outlined plate asks for, on the points of so many.
};

/** Everything that the modes of a described device depend on, as bytes: equal where the modes are. None for a device
   that gives its modes itself.

    It holds the name, the body with all its ceramics, the wanted count, what it is solved for,
   the program's version, a fingerprint of the
   sources that solve, and the format of the cache. The description's free text has no part in the modes. [worker] */
std::optional<std::string> modeCacheKey (const DeviceDescription&, std::optional<int> modeCount, SolvedShapes);

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

/** A file of the mode cache: magic, its own length, the key, all fields of the model, and an XXH3 checksum over all of
   it. [worker] Docs/FileFormats.md. */
std::string encodeModeCacheEntry (std::string_view key, const ModalModel&);

/** The model of an entry, the same to the bit.
    @param bytes  from anywhere: nothing in them is believed
    @throws InputError  when they are no entry, damaged, of another key, or hold no valid model
    [worker] */
ModalModel decodeModeCacheEntry (std::string_view bytes, std::string_view key);
} // namespace antinode
