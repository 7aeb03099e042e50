#include "XmlTree.h"

#include <antinode_base/InputError.h>

#include <expat.h>

#include <algorithm>
#include <cstdint>
#include <memory>

namespace antinode
{
namespace
{
/** What the parser is in. */
struct XmlWay
{
    XML_Parser parser = nullptr;
    XmlNode root;              ///< Its first child is the file's root.
    std::vector<XmlNode*> way; ///< The elements that are open.
    bool isTooDeep = false;
};

constexpr std::size_t deepest = 200;

/** The line that is read now; expat 2.9 deprecates the call that older versions have. */
std::uint64_t lineOf (XML_Parser parser)
{
#if XML_MAJOR_VERSION > 2 || XML_MINOR_VERSION >= 9
    return XML_GetCurrentLineNumber64 (parser);
#else
    return XML_GetCurrentLineNumber (parser);
#endif
}

void onStart (void* data, const XML_Char* name, const XML_Char** attributes)
{
    auto& xml = *static_cast<XmlWay*> (data);

    if (xml.way.size() > deepest)
    {
        xml.isTooDeep = true;
        XML_StopParser (xml.parser, XML_FALSE);
        return;
    }

    auto& node = xml.way.back()->children.emplace_back();
    node.name = name;
    node.line = static_cast<long> (lineOf (xml.parser));

    for (; *attributes != nullptr; attributes += 2)
        node.attributes.emplace_back (attributes[0], attributes[1]);

    xml.way.push_back (&node);
}

void onEnd (void* data, const XML_Char*)
{
    static_cast<XmlWay*> (data)->way.pop_back();
}
} // namespace

std::string_view XmlNode::attribute (std::string_view wanted) const
{
    const auto found =
        std::find_if (attributes.begin(), attributes.end(), [&] (const auto& each) { return each.first == wanted; });
    return found == attributes.end() ? std::string_view {} : std::string_view { found->second };
}

XmlNode readXml (std::string_view bytes, const std::string& source)
{
    constexpr std::size_t most = std::size_t { 1 } << 30;
    const std::unique_ptr<XML_ParserStruct, decltype (&XML_ParserFree)> parser (XML_ParserCreate (nullptr),
                                                                                XML_ParserFree);
    XmlWay xml;
    xml.parser = parser.get();
    xml.way.push_back (&xml.root);
    XML_SetUserData (xml.parser, &xml);
    XML_SetElementHandler (xml.parser, onStart, onEnd);

    if (bytes.size() > most
        || XML_Parse (xml.parser, bytes.data(), static_cast<int> (bytes.size()), 1) == XML_STATUS_ERROR)
        throw InputError (source + ": line " + std::to_string (lineOf (xml.parser)),
                          xml.isTooDeep ? "has more than " + std::to_string (deepest) + " elements in each other"
                                        : "is not XML (" + std::string (XML_ErrorString (XML_GetErrorCode (xml.parser)))
                                              + "); allowed: a whole XML file");

    return std::move (xml.root.children.front());
}
} // namespace antinode
