#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace antinode
{
/** A variable of a MATLAB file: an array of numbers, or text. Fields of structures are variables "structure.field"; of
   arrays of structures and cells, "structure(2).field" and "cells{2}". */
struct MatlabVariable
{
    std::string name;
    std::vector<std::size_t> sizes; ///< Two or more.
    std::vector<double> real,
        imaginary;         ///< As many as the product of the sizes, the first index fastest; imaginary empty if real.
    std::string text;      ///< Of characters, whose numbers are empty.
    std::string className; ///< Of an object such as `frd`, of which nothing can be read; then all else is empty.
};

/** The name in lower case without the structures and the place in an array that it is in. [any] */
std::string shortName (const MatlabVariable&);

/** Whether these bytes begin with a matrix of level 4, which has no other mark. [any] */
bool isMatlabLevel4 (std::string_view bytes);

/** Variables of a MATLAB file of level 5 (versions 5 to 7, compressed or not, either byte order) or level 4. Arrays of
   numbers and text are read, with those in structures and cells; objects are named with their class; what else there is
   is left out. Files are read by our own code, not by libmatio, which takes memory by what a file says of itself
   (Docs/Design/measurement.md).
    @param source  how errors name the file
    @throws InputError  when it is no such file or is damaged, or unpacks to more than 16 times its size and 16 MB
    [worker] MATLAB, MAT-File Format, The MathWorks. */
std::vector<MatlabVariable> readMatlabFile (std::string_view bytes, const std::string& source);
} // namespace antinode
