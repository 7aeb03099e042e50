#include "Support/ErrorText.h"

#include <antinode_base/WholeFile.h>
#include <antinode_documents/DeviceFile.h>
#include <antinode_documents/FocusFile.h>
#include <antinode_structure/Materials.h>

#include <nlohmann/json.hpp>

#include <catch2/catch.hpp>

#include <regex>

using namespace antinode;

namespace
{
std::string page (const std::string& name)
{
    return readWholeFile (std::string (ANTINODE_TEST_DATA) + "/../../Docs/" + name, {});
}
} // namespace

TEST_CASE ("Each allocation method is in the page of file formats and in the glossary", "[files]")
{
    for (const auto& [word, method] : allocationMethodWords)
    {
        INFO (word);
        CHECK (page ("FileFormats.md").find ("\"" + std::string (word) + "\"") != std::string::npos);
        CHECK (page ("Glossary.md").find ("`" + std::string (word) + "`") != std::string::npos);
    }
}

TEST_CASE ("Each kind of device is in the page of file formats", "[files]")
{
    const auto message = errorText (
        [] {
            readDevice ({ { "schema", "antinode.device/1" }, { "kind", "none" } }, "device");
        });
    const std::regex quoted ("'([a-z]+)'");
    const auto kinds = message.substr (message.find ("allowed: "));
    int count = 0;

    for (std::sregex_iterator word (kinds.begin(), kinds.end(), quoted), end; word != end; ++word, ++count)
        CHECK (page ("FileFormats.md").find ("\"kind\": \"" + (*word)[1].str() + "\"") != std::string::npos);

    CHECK (count >= 4);
}

TEST_CASE ("Each built-in material is in the page of materials", "[files]")
{
    const auto materials = page ("Materials.md");

    for (const auto& list : { elasticMaterialNames(), piezoelectricMaterialNames(), viscoelasticMaterialNames() })
        for (const auto& name : list)
        {
            INFO (name);
            CHECK (materials.find ("| `" + name + "` |") != std::string::npos);
        }
}
