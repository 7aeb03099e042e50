#pragma once

#include "MaterialTypes.h"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace antinode
{
/** What a built-in material has besides its constants: by which other words it is known, what scatters between
   samples, and where the constants are from. */
struct MaterialNotes
{
    std::string_view name;
    std::array<std::string_view, 3> otherNames; ///< Empty ones are none.
    std::string_view scatter;
    std::string_view source;
};

struct NamedElasticMaterial
{
    MaterialNotes notes;
    ElasticMaterial material;
};

struct NamedPiezoelectricMaterial
{
    MaterialNotes notes;
    PiezoelectricMaterial material;
};

struct NamedViscoelasticMaterial
{
    MaterialNotes notes;
    ViscoelasticMaterial material;
};

// All built-in materials, in the order in which they are listed. Docs/Materials.md. [any]

std::span<const NamedElasticMaterial> elasticMaterials();
std::span<const NamedPiezoelectricMaterial> piezoelectricMaterials();
std::span<const NamedViscoelasticMaterial> viscoelasticMaterials();

// A built-in material by one of its names, or nothing if there is none of that name. Case, hyphens and blanks do not
// count: "PZT-5A", "pzt5a" and "PZT 5A" are one. [any]

std::optional<ElasticMaterial> findElasticMaterial (std::string_view name);
std::optional<PiezoelectricMaterial> findPiezoelectricMaterial (std::string_view name);
std::optional<ViscoelasticMaterial> findViscoelasticMaterial (std::string_view name);

// Their names. [any]

std::vector<std::string> elasticMaterialNames();
std::vector<std::string> piezoelectricMaterialNames();
std::vector<std::string> viscoelasticMaterialNames();
} // namespace antinode
