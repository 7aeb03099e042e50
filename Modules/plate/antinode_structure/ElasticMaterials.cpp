#include "Materials.h"

namespace antinode
{
namespace
{
constexpr ElasticMaterial isotropic (double youngsModulus, double poissonRatio, double density)
{
    return { youngsModulus, youngsModulus, youngsModulus / (2 * (1 + poissonRatio)), poissonRatio, density };
}

constexpr std::string_view handbooks = "round values of handbooks";
constexpr std::string_view woodHandbook = "Wood Handbook, FPL-GTR-282, tables 5-1 to 5-3: Sitka spruce, radial across";

constexpr std::array<NamedElasticMaterial, 18> elasticTable { {
    { { "aluminium", { "aluminum" }, "alloys: E 68 to 73 GPa", handbooks }, isotropic (70e9, 0.33, 2700) },
    { { "steel", {}, "E 195 to 212 GPa", handbooks }, isotropic (200e9, 0.3, 7800) },
    { { "stainless-steel", {}, "austenitic; E 190 to 200 GPa, with rolling direction", handbooks },
      isotropic (193e9, 0.29, 8000) },
    { { "brass", {}, "E 97 to 115 GPa, with zinc and temper", handbooks }, isotropic (103e9, 0.34, 8500) },
    { { "glass", { "soda-lime", "soda-lime-glass", "float-glass" }, "E 69 to 74 GPa", handbooks },
      isotropic (70e9, 0.22, 2500) },
    { { "borosilicate", { "borosilicate-glass" }, "E 62 to 65 GPa", "data sheet of Schott Borofloat 33" },
      isotropic (64e9, 0.2, 2230) },
    { { "aluminosilicate",
        { "aluminosilicate-glass" },
        "cover glasses: E 69 to 78 GPa, density 2390 to 2480 kg/m3",
        "data sheet of Corning Gorilla Glass 2" },
      isotropic (71.5e9, 0.21, 2420) },
    { { "PMMA",
        { "acrylic", "plexiglas" },
        "E 2.7 to 3.4 GPa in static tests; above 100 Hz 20 to 50 % more; -1.5 %/K; loss factor 0.04 to 0.08",
        "data sheet of Plexiglas GS and XT" },
      isotropic (3.3e9, 0.37, 1190) },
    { { "polycarbonate", { "PC" }, "E 2.2 to 2.6 GPa; loss factor 0.01 to 0.02", "data sheet of Makrolon" },
      isotropic (2.4e9, 0.37, 1200) },
    { { "FR4", {}, "with cloth, resin and copper 20 %; x along the warp", "IPC-4101 laminates, typical" },
      { 24e9, 21e9, 4e9, 0.13, 1850 } },
    { { "plywood",
        { "birch-plywood" },
        "9 mm, 7 plies, x along the face grain; thinner: 16 and 1 GPa (3 plies); 10 % with moisture",
        "Handbook of Finnish Plywood, mean values in bending" },
      { 11.4e9, 6.1e9, 0.62e9, 0.05, 680 } },
    { { "wood-along",
        { "wood", "spruce" },
        "quarter-sawn, grain along x; 20 to 30 % between boards, 2 % per 1 % of moisture",
        woodHandbook },
      { 11e9, 0.86e9, 0.7e9, 0.37, 420 } },
    { { "wood-across", { "spruce-across" }, "quarter-sawn, grain along y; as wood-along", woodHandbook },
      { 0.86e9, 11e9, 0.7e9, 0.37 * 0.86 / 11, 420 } },
    { { "beech-along",
        { "beech" },
        "grain along x; 20 % between boards",
        "Wood Handbook: American beech; radial across" },
      { 13e9, 2e9, 1.3e9, 0.4, 700 } },
    { { "MDF", {}, "E 2.5 to 4 GPa with density", handbooks }, isotropic (3e9, 0.25, 750) },
    { { "carbon-laminate",
        { "CFRP", "carbon" },
        "quasi-isotropic, standard fibre, 60 % by volume; E 45 to 55 GPa",
        handbooks },
      isotropic (50e9, 0.31, 1550) },
    { { "carbon-unidirectional",
        { "carbon-UD" },
        "standard fibre along x, 60 % by volume; E1 120 to 150 GPa",
        handbooks },
      { 135e9, 9e9, 5e9, 0.3, 1550 } },
    { { "epoxy", {}, "cured glue; E 1 to 4 GPa", handbooks }, isotropic (2.5e9, 0.36, 1150) },
} };
} // namespace

std::span<const NamedElasticMaterial> elasticMaterials()
{
    return elasticTable;
}
} // namespace antinode
