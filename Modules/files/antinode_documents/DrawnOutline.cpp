#include "DrawnOutline.h"

#include <antinode_outline/Drawing.h>
#include <antinode_text/JsonReader.h>
#include <antinode_text/PhysicalRanges.h>

namespace antinode
{
namespace
{
constexpr WordList<double, 8> drawingUnits { { { "mm", 1e-3 },
                                               { "cm", 1e-2 },
                                               { "m", 1 },
                                               { "in", 0.0254 },
                                               { "ft", 0.3048 },
                                               { "mil", 25.4e-6 },
                                               { "pt", 0.0254 / 72 },
                                               { "px", 0.0254 / 96 } } };
} // namespace

Outline readDrawnOutline (const std::filesystem::path& drawing, const nlohmann::json& keys)
{
    const auto object = JsonValue (keys, "outline").object ({ "file", "layer", "unit" });
    DrawingChoice choice;

    if (const auto layer = object.optional ("layer"))
        choice.layer = layer->text (ranges::maximumNameBytes);

    if (const auto unit = object.optional ("unit"))
        choice.unit = unit->choice (drawingUnits);

    return readOutlineFile (drawing, choice);
}
} // namespace antinode
