#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace antinode
{
/** An element of an XML file, without the text between elements. */
struct XmlNode
{
    std::string name; ///< With its prefix, as written.
    long line = 0;
    std::vector<std::pair<std::string, std::string>> attributes;
    std::vector<XmlNode> children;

    /** Its value; nothing where there is none, as for an empty one. [any] */
    std::string_view attribute (std::string_view name) const;
};

/** The root element. No file or address that it names is read.
    @throws InputError  source, line, what is wrong
    [worker] */
XmlNode readXml (std::string_view bytes, const std::string& source);
} // namespace antinode
