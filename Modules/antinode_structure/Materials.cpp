#include "Materials.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace antinode
{
namespace
{
template <typename Material>
struct NamedMaterial
{
    std::string_view name;
    Material material;
};

constexpr ElasticMaterial isotropic (double youngsModulus, double poissonRatio, double density)
{
    return { youngsModulus, youngsModulus, youngsModulus / (2 * (1 + poissonRatio)), poissonRatio, density };
}

/** Round values of the handbooks; glass is soda-lime float glass. */
constexpr std::array<NamedMaterial<ElasticMaterial>, 3> elasticMaterials { {
    { "aluminium", isotropic (70e9, 0.33, 2700) },
    { "steel", isotropic (200e9, 0.3, 7800) },
    { "glass", isotropic (70e9, 0.22, 2500) },
} };

/** NCE51 after its maker's data sheet: s11 = 16e-12 1/Pa, s12 = -5.0e-12 1/Pa, so E = 1/s11 and nu = -s12/s11 = .31. */
constexpr std::array<NamedMaterial<PiezoelectricMaterial>, 1> piezoelectricMaterials { {
    { "NCE51", { 62.5e9, 0.31, 7800, -195e-12, 1850 } },
} };

template <typename Table>
auto findByName (const Table& table, std::string_view name) -> std::optional<decltype (table.front().material)>
{
    const auto found =
        std::find_if (table.begin(), table.end(), [name] (const auto& entry) { return entry.name == name; });

    if (found == table.end())
        return std::nullopt;

    return found->material;
}

template <typename Table>
std::vector<std::string> collectNames (const Table& table)
{
    std::vector<std::string> names;
    std::transform (table.begin(), table.end(), std::back_inserter (names),
                    [] (const auto& entry) { return std::string (entry.name); });
    return names;
}
} // namespace

std::optional<ElasticMaterial> findElasticMaterial (std::string_view name)
{
    return findByName (elasticMaterials, name);
}

std::vector<std::string> elasticMaterialNames()
{
    return collectNames (elasticMaterials);
}

std::optional<PiezoelectricMaterial> findPiezoelectricMaterial (std::string_view name)
{
    return findByName (piezoelectricMaterials, name);
}

std::vector<std::string> piezoelectricMaterialNames()
{
    return collectNames (piezoelectricMaterials);
}
} // namespace antinode
