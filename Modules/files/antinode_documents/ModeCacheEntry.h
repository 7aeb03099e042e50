#pragma once

#include <antinode_model/ModalModel.h>

#include <string>
#include <string_view>

namespace antinode
{
/** A file of the mode cache: magic, its own length, the key, all fields of the model, and an XXH3 checksum over all of
   it. [worker] Docs/FileFormats.md. */
std::string encodeModeCacheEntry (std::string_view key, const ModalModel&);

/** The model of an entry, the same to the bit.
    @param bytes  from anywhere: nothing in them is believed
    @throws InputError  when they are no entry, damaged, of another key, or hold no valid model
    [worker] */
ModalModel decodeModeCacheEntry (std::string_view bytes, std::string_view key);
} // namespace antinode
