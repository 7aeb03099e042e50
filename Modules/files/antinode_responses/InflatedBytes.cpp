#include "InflatedBytes.h"

#include <zlib.h>

#include <algorithm>
#include <limits>
#include <memory>

namespace antinode
{
std::optional<std::string> inflatedBytes (std::string_view packed, std::size_t maximum)
{
    constexpr std::size_t step = 1 << 16;
    z_stream stream {};

    if (packed.size() > std::numeric_limits<uInt>::max() || inflateInit (&stream) != Z_OK)
        return std::nullopt;

    const std::unique_ptr<z_stream, int (*) (z_stream*)> closing (&stream, inflateEnd);
    std::string bytes;
    stream.next_in =
        reinterpret_cast<Bytef*> (const_cast<char*> (packed.data())); // zlib's interface: it is not written to.
    stream.avail_in = static_cast<uInt> (packed.size());

    while (true)
    {
        const auto before = bytes.size();
        const auto room = std::min (step, maximum - before);

        if (room == 0)
            return std::nullopt;

        bytes.resize (before + room);
        stream.next_out = reinterpret_cast<Bytef*> (bytes.data() + before);
        stream.avail_out = static_cast<uInt> (room);
        const auto status = inflate (&stream, Z_NO_FLUSH);
        bytes.resize (before + room - stream.avail_out);

        if (status == Z_STREAM_END)
            return bytes;

        if (status != Z_OK || bytes.size() == before)
            return std::nullopt;
    }
}
} // namespace antinode
