#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace antinode
{
/** A folder into which files are written so that each appears under its name only when it is complete.

    Files are written to a hidden temporary folder inside the target folder; commit() renames each into place (one
   atomic rename a file, summary.json last). Without commit(), or after a kill, nothing appears and nothing old is lost;
   a stale temporary folder of a killed run is removed by the next.
*/
class OutputFolder
{
public:
    /** Makes the folder where it is missing. @throws InputError when it cannot be made or written, or is a file.
        [worker] */
    explicit OutputFolder (const std::filesystem::path& target);
    ~OutputFolder();
    OutputFolder (const OutputFolder&) = delete;
    OutputFolder& operator= (const OutputFolder&) = delete;

    /** Where to write a file of this name before commit().
        @throws InputError  when it is not a plain file name [worker] */
    std::filesystem::path pathFor (const std::string& fileName);

    /** Writes a whole file. @throws InputError when the disk is full or not writable. [worker] */
    void write (const std::string& fileName, std::string_view content);

    /** All files appear; no more can be added. @throws InputError when one is missing or cannot be renamed. [worker] */
    void commit();

private:
    std::filesystem::path target;
    std::filesystem::path temporary; ///< Inside the target, so that renaming is atomic.
    std::vector<std::string> fileNames;
    bool madeTarget = false;
};

/** Removes what processes that are dead have left in a folder while they wrote to it: temporary folders as above. A
   folder that is missing is left so. [worker] */
void removeAbandoned (const std::filesystem::path& folder);

/** Writes one file, which appears under its name only when it is complete. Folders on the way are made; a link is
   followed.
    @throws InputError  when it cannot be written, or its name is that of a folder or of anything else that is no plain
   file [worker] */
void writeWholeFile (const std::filesystem::path&, std::string_view content);
} // namespace antinode
