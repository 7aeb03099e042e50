#pragma once

#include "DeviceDescription.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace antinode
{
/** A built-in material of substrates by its name, or nothing if there is none of that name. [any] */
std::optional<ElasticMaterial> findElasticMaterial (std::string_view name);

/** The names of all built-in materials of substrates. [any] */
std::vector<std::string> elasticMaterialNames();

/** A built-in ceramic by its name, or nothing if there is none of that name. [any] */
std::optional<PiezoelectricMaterial> findPiezoelectricMaterial (std::string_view name);

/** The names of all built-in ceramics. [any] */
std::vector<std::string> piezoelectricMaterialNames();
} // namespace antinode
