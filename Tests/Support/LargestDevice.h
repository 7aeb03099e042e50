#pragma once

#include <antinode_documents/Library.h>

#include <nlohmann/json.hpp>

#include <string>

namespace antinode::test
{
inline nlohmann::json ceramicAt (int row, int column)
{
    return { { "name", "C" + std::to_string (8 * row + column + 1) },
             { "x_mm", 4 + 24.5 * column },
             { "y_mm", 3 + 14.5 * row },
             { "size_x_mm", 20 },
             { "size_y_mm", 11 },
             { "thickness_mm", 0.5 },
             { "material", "NCE51" },
             { "mounting", "both_sides" },
             { "wiring", "parallel" } };
}

/** A plate with 64 ceramics and 500 modes, as a document. @param quality  another one is in no cache */
inline nlohmann::json largestDevice (double quality)
{
    auto json = loadDocument (LibraryKind::device, "aluminium-200x120");
    json["ceramics"] = nlohmann::json::array();

    for (int i = 0; i < 64; ++i)
        json["ceramics"].push_back (ceramicAt (i / 8, i % 8));

    json["modes"]["count"] = 500;
    json["quality_factor"] = quality;
    return json;
}
} // namespace antinode::test
