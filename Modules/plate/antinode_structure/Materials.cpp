#include "Materials.h"

#include <algorithm>
#include <cctype>
#include <iterator>

namespace antinode
{
namespace
{
/** A name without what does not distinguish it. */
std::string plain (std::string_view name)
{
    std::string text;

    for (const auto byte : name)
        if (const auto letter = static_cast<unsigned char> (byte); letter != '-' && letter != '_' && letter != ' ')
            text += static_cast<char> (std::tolower (letter));

    return text;
}

bool isCalled (const MaterialNotes& notes, const std::string& plainName)
{
    return plain (notes.name) == plainName
           || std::any_of (notes.otherNames.begin(), notes.otherNames.end(),
                           [&] (std::string_view other) { return ! other.empty() && plain (other) == plainName; });
}

template <typename Entry>
auto findByName (std::span<const Entry> table, std::string_view name) -> std::optional<decltype (Entry::material)>
{
    const auto found =
        std::find_if (table.begin(), table.end(),
                      [wanted = plain (name)] (const Entry& entry) { return isCalled (entry.notes, wanted); });

    if (found == table.end())
        return std::nullopt;

    return found->material;
}

template <typename Entry>
std::vector<std::string> collectNames (std::span<const Entry> table)
{
    std::vector<std::string> names;
    std::transform (table.begin(), table.end(), std::back_inserter (names),
                    [] (const Entry& entry) { return std::string (entry.notes.name); });
    return names;
}
} // namespace

std::optional<ElasticMaterial> findElasticMaterial (std::string_view name)
{
    return findByName (elasticMaterials(), name);
}

std::optional<PiezoelectricMaterial> findPiezoelectricMaterial (std::string_view name)
{
    return findByName (piezoelectricMaterials(), name);
}

std::optional<ViscoelasticMaterial> findViscoelasticMaterial (std::string_view name)
{
    return findByName (viscoelasticMaterials(), name);
}

std::vector<std::string> elasticMaterialNames()
{
    return collectNames (elasticMaterials());
}

std::vector<std::string> piezoelectricMaterialNames()
{
    return collectNames (piezoelectricMaterials());
}

std::vector<std::string> viscoelasticMaterialNames()
{
    return collectNames (viscoelasticMaterials());
}
} // namespace antinode
