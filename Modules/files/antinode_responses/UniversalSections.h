#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace antinode
{
/** A data set of a universal file as bytes: what stands between its two lines of -1. */
struct UniversalSection
{
    int number = 0;                       ///< Its kind, for example 58.
    std::string_view records;             ///< Its text behind the line of the number, with all line ends.
    std::optional<std::string_view> data; ///< Of a 58b: the bytes behind the text.
    bool isBigEndian = false;             ///< Of a 58b.
    std::size_t firstLine = 0; ///< Number of the first record's line, from 1; lines behind binary data are not counted.
};

/** Cuts a file into its data sets. Text outside of sets is ignored. The end of binary data is where a line of -1
   begins: looked for where the numbers of the header say, with a line's end more or less, else from there on, because
   headers are often wrong.
    @param source  how errors name the file
    @throws InputError  when there is no set, one is not closed, or its number cannot be read
    [worker] */
std::vector<UniversalSection> universalSections (std::string_view file, const std::string& source);
} // namespace antinode
