#pragma once

#include <filesystem>
#include <random>
#include <string>

namespace antinode
{
/** An empty folder that is gone at the end of its scope. */
class TemporaryFolder
{
public:
    TemporaryFolder()
    {
        std::random_device random;

        do
            folder = std::filesystem::temp_directory_path() / ("antinode-test-" + std::to_string (random()));
        while (! std::filesystem::create_directory (folder));
    }

    ~TemporaryFolder()
    {
        std::error_code ignored;
        std::filesystem::remove_all (folder, ignored);
    }

    TemporaryFolder (const TemporaryFolder&) = delete;
    TemporaryFolder& operator= (const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return folder; }

private:
    std::filesystem::path folder;
};
} // namespace antinode
