#include "Support/ErrorText.h"
#include "Support/TemporaryFolder.h"

#include <antinode_base/WholeFile.h>

#include <catch2/catch.hpp>

#include <fstream>

#include <sys/stat.h>

using namespace antinode;

namespace
{
std::string refusal (const std::filesystem::path& path, std::uintmax_t maximumBytes = 1 << 20)
{
    return errorText ([&] { readWholeFile (path, { "a drawing", maximumBytes, "is not there" }); });
}
} // namespace

TEST_CASE ("A whole file has all its bytes", "[base]")
{
    const TemporaryFolder folder;
    const auto path = folder.path() / "bytes";

    for (const std::size_t size : { 0, 1, 65535, 65536, 65537, 300000 })
    {
        std::string bytes (size, '\0');

        for (std::size_t i = 0; i < size; ++i)
            bytes[i] = static_cast<char> (i * 2654435761U >> 13);

        std::ofstream (path, std::ios::binary) << bytes;
        CHECK (readWholeFile (path, {}) == bytes);
        CHECK (readWholeFile (path, { "a file", std::max<std::size_t> (size, 1) }) == bytes);
    }
}

TEST_CASE ("A file whose size the system gives as 0 is read to its end", "[base]")
{
    std::ifstream stream ("/proc/self/maps");
    std::string line;
    std::getline (stream, line);
    const auto text = readWholeFile ("/proc/self/maps", {});
    CHECK (text.substr (0, text.find ('\n')) == line);
    CHECK (text.back() == '\n');
}

TEST_CASE ("What is no plain file, or too large a one, is refused in a sentence", "[base]")
{
    const TemporaryFolder folder;
    const auto path = folder.path() / "file";
    const auto name = path.string();
    CHECK (refusal (path) == name + ": is not there");
    CHECK (refusal (folder.path()) == folder.path().string() + ": is a directory; allowed: a drawing");

    REQUIRE (mkfifo (path.c_str(), 0600) == 0); // Nobody writes: to wait for a first byte would be for ever.
    CHECK (refusal (path) == name + ": is a pipe or socket; allowed: a drawing");
    std::filesystem::remove (path);

    std::ofstream (path).close();
    std::filesystem::resize_file (path, (1 << 20) + 1); // Sparse.
    CHECK (refusal (path) == name + ": is too large; allowed: up to 1 MiB");
    std::filesystem::resize_file (path, 1 << 20);
    CHECK (refusal (path).empty());
    CHECK (refusal (path / "below") == (path / "below").string() + ": is not there");

    std::filesystem::resize_file (path, (std::uintmax_t { 4 } << 30) + 1);
    CHECK (refusal (path, std::uintmax_t { 4 } << 30) == name + ": is too large; allowed: up to 4 GiB");
    CHECK (refusal ("/dev/zero", std::uintmax_t { 4 } << 30) == "/dev/zero: is too large; allowed: up to 64 MiB");
    CHECK (refusal ("/proc/self/mem").starts_with ("/proc/self/mem: cannot be read: "));
}
