#pragma once

#include <string>
#include <vector>

namespace antinode
{
/** A name with # for each of its numbers, and these. A sign belongs to a number at the beginning. */
struct NumberedName
{
    std::string form;
    std::vector<std::string> numbers;
};

/** [any] */
NumberedName numberedName (const std::string&);

/** Names in the order of their numbers where they differ in nothing else, P2 before P10; else as they are. [any] */
std::vector<std::string> inNaturalOrder (std::vector<std::string> names);

/** The remark that files are read in another order than they were given; empty where it is the same. [any] */
std::string orderRemark (const std::vector<std::string>& given, const std::vector<std::string>& read);
} // namespace antinode
