#include "MaterialReader.h"

#include <antinode_base/MessageText.h>
#include <antinode_structure/Materials.h>
#include <antinode_text/PhysicalRanges.h>

#include <cmath>

namespace antinode
{
namespace
{
constexpr double pascalsPerGigapascal = 1e9;
constexpr NumberRange modulusGigapascal { 1e-6, 1e4 };
constexpr NumberRange density { 1, 50000 };
constexpr NumberRange poissonRatio { -0.99, 0.5 };
constexpr NumberRange orthotropicPoissonRatio { -10, 10 };
constexpr NumberRange d31 { -1e-6, 1e-6 };
constexpr NumberRange permittivity { 1, 1e6 };

double readModulus (const JsonObject& material, std::string_view key)
{
    return material.required (key).number (modulusGigapascal) * pascalsPerGigapascal;
}

ElasticMaterial readIsotropic (const JsonValue& value)
{
    const auto material = value.object ({ "youngs_modulus_GPa", "poisson_ratio", "density_kg_m3" });
    const auto modulus = readModulus (material, "youngs_modulus_GPa");
    const auto poisson = material.required ("poisson_ratio").number (poissonRatio);
    return { modulus, modulus, modulus / (2 * (1 + poisson)), poisson,
             material.required ("density_kg_m3").number (density) };
}

ElasticMaterial readOrthotropic (const JsonValue& value)
{
    const auto object = value.object ({ "E1_GPa", "E2_GPa", "G12_GPa", "nu12", "density_kg_m3" });
    ElasticMaterial material;
    material.youngsModulus1 = readModulus (object, "E1_GPa");
    material.youngsModulus2 = readModulus (object, "E2_GPa");
    material.shearModulus = readModulus (object, "G12_GPa");
    material.poissonRatio12 = object.required ("nu12").number (orthotropicPoissonRatio);
    material.density = object.required ("density_kg_m3").number (density);

    // nu12 nu21 < 1, or bending it would set energy free.
    const auto limit = std::sqrt (material.youngsModulus1 / material.youngsModulus2);

    if (! (std::abs (material.poissonRatio12) < limit))
        object.required ("nu12").number ({ -limit, limit, true, true });

    return material;
}

template <typename Material>
Material builtIn (const JsonValue& value, const std::optional<Material>& found, const std::vector<std::string>& names)
{
    if (found)
        return *found;

    const std::vector<std::string_view> words (names.begin(), names.end());
    value.fail (value.description() + didYouMean (value.text (ranges::maximumNameBytes), words) + "; allowed: one of "
                + listed (words) + ", or an object with the constants of the material");
}
} // namespace

ElasticMaterial readElasticMaterial (const JsonValue& value)
{
    if (value.isString())
        return builtIn (value, findElasticMaterial (value.text (ranges::maximumNameBytes)), elasticMaterialNames());

    return value.find ("E1_GPa") ? readOrthotropic (value) : readIsotropic (value);
}

PiezoelectricMaterial readPiezoelectricMaterial (const JsonValue& value)
{
    if (value.isString())
        return builtIn (value, findPiezoelectricMaterial (value.text (ranges::maximumNameBytes)),
                        piezoelectricMaterialNames());

    const auto object = value.object (
        { "youngs_modulus_GPa", "poisson_ratio", "density_kg_m3", "d31_m_per_V", "permittivity_relative" });
    PiezoelectricMaterial material;
    material.youngsModulus = readModulus (object, "youngs_modulus_GPa");
    material.poissonRatio = object.required ("poisson_ratio").number (poissonRatio);
    material.density = object.required ("density_kg_m3").number (density);
    material.d31 = object.required ("d31_m_per_V").number (d31);

    if (const auto given = object.optional ("permittivity_relative"))
        material.permittivityRelative = given->number (permittivity);

    return material;
}
} // namespace antinode
