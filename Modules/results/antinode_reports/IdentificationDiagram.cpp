#include "IdentificationDiagram.h"

#include "DiagramData.h"

#include <antinode_diagram.h>

#include <nlohmann/json.hpp>

#include <stdexcept>
#include <string_view>

namespace antinode
{
namespace
{
/** What stands in the page for something else. */
void replaceMark (std::string& page, std::string_view mark, const std::string& content)
{
    const auto place = page.find (mark);

    if (place == std::string::npos)
        throw std::logic_error ("the page of the diagram has no " + std::string (mark));

    page.replace (place, mark.size(), content);
}

bool endsWith (std::string_view name, std::string_view ending)
{
    return name.size() >= ending.size() && name.substr (name.size() - ending.size()) == ending;
}

/** All files of a kind, one after the other. */
std::string filesOfKind (std::string_view ending)
{
    std::string all;

    for (const auto& file : diagram::files())
        if (endsWith (file.name, ending))
            all += file.text();

    return all;
}

/** JSON that cannot end the element it is in, whatever names say. */
std::string forScript (const nlohmann::json& data)
{
    std::string text;

    for (const auto character : data.dump (-1, ' ', false, nlohmann::json::error_handler_t::replace))
        if (character == '<')
            text += "\\u003c";
        else
            text += character;

    return text;
}
} // namespace

std::string identificationDiagram (const IdentificationResult& result, const std::string& reportName)
{
    auto data = diagramData (result);
    data["report"] = reportName;
    auto page = filesOfKind (".html");
    replaceMark (page, "@style@", filesOfKind (".css"));
    replaceMark (page, "@script@", filesOfKind (".js"));
    replaceMark (page, "@data@", forScript (data));
    return page;
}
} // namespace antinode
