#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace antinode::test
{
using Packet = std::vector<std::byte>;

/** The bytes of a text, zeros within it included: packets as the specifications print them. */
inline Packet toPacket (std::string_view text)
{
    const auto* first = reinterpret_cast<const std::byte*> (text.data());
    return { first, first + text.size() };
}

/** Writes OSC messages and bundles, independently of the reader. */
class OscWriter
{
public:
    template <typename... Arguments>
    static Packet message (std::string_view address, const Arguments&... arguments)
    {
        OscWriter values;
        std::string tags = ",";
        ((tags += typeTag (arguments), values.add (arguments)), ...);
        OscWriter all;
        all.add (std::string (address));
        all.add (tags);
        all.bytes.insert (all.bytes.end(), values.bytes.begin(), values.bytes.end());
        return all.bytes;
    }

    static Packet bundle (const std::vector<Packet>& elements)
    {
        OscWriter writer;
        writer.add (std::string ("#bundle"));
        writer.add (std::int32_t { 0 });
        writer.add (std::int32_t { 1 });

        for (const auto& element : elements)
        {
            writer.add (static_cast<std::int32_t> (element.size()));
            writer.bytes.insert (writer.bytes.end(), element.begin(), element.end());
        }

        return writer.bytes;
    }

private:
    static char typeTag (std::int32_t) { return 'i'; }
    static char typeTag (float) { return 'f'; }
    static char typeTag (double) { return 'd'; }
    static char typeTag (std::int64_t) { return 'h'; }
    static char typeTag (const std::string&) { return 's'; }

    void addWord (std::uint32_t word)
    {
        for (int shift = 24; shift >= 0; shift -= 8)
            bytes.push_back (static_cast<std::byte> (word >> shift & 0xff));
    }

    void addLongWord (std::uint64_t word)
    {
        addWord (static_cast<std::uint32_t> (word >> 32));
        addWord (static_cast<std::uint32_t> (word));
    }

    void add (std::int32_t value) { addWord (static_cast<std::uint32_t> (value)); }
    void add (float value) { addWord (std::bit_cast<std::uint32_t> (value)); }
    void add (double value) { addLongWord (std::bit_cast<std::uint64_t> (value)); }
    void add (std::int64_t value) { addLongWord (static_cast<std::uint64_t> (value)); }

    void add (const std::string& text)
    {
        for (const auto character : text)
            bytes.push_back (static_cast<std::byte> (character));

        do
            bytes.push_back (std::byte { 0 });
        while (bytes.size() % 4 != 0);
    }

    Packet bytes;
};
} // namespace antinode::test
