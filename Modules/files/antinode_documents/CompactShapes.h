#pragma once

#include <antinode_text/JsonReader.h>

#include <Eigen/Core>

namespace antinode
{
/** Numbers as base64 of little-endian 4-byte floating point: a quarter of what they take as text, to 7 digits. [any] */
std::string compactNumbers (const Eigen::VectorXd&);

/** The same back. @throws InputError  where it is not that, has another count, or a number is not finite [worker] */
Eigen::VectorXd readCompactNumbers (const JsonValue&, Eigen::Index count);
} // namespace antinode
