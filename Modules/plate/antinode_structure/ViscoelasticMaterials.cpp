#include "Materials.h"

namespace antinode
{
namespace
{
constexpr std::string_view temperature =
    "a factor of 2 to 3 with product, and of 2 with 5 K; measure it where damping matters";

/** Rows of a table: a power of frequency at an even loss factor, as such polymers have at room temperature. */
ViscoelasticMaterial polymer (std::vector<ShearAtFrequency> table, double density)
{
    ViscoelasticMaterial material;
    material.table = std::move (table);
    material.density = density;
    return material;
}

const std::array<NamedViscoelasticMaterial, 4>& softTable()
{
    static const std::array<NamedViscoelasticMaterial, 4> table { {
        { { "OCA", { "optically-clear-adhesive" }, temperature, "acrylic adhesives at 20 degrees Celsius, typical" },
          polymer (
              { { 1, 50e3, 0.3 }, { 10, 90e3, 0.5 }, { 100, 200e3, 0.8 }, { 1000, 600e3, 1.0 }, { 10000, 2e6, 1.0 } },
              1000) },
        { { "damping-polymer", { "ISD112" }, temperature, "3M ISD 112 at 20 degrees Celsius, typical" },
          polymer ({ { 10, 0.25e6, 0.8 }, { 100, 0.8e6, 1.0 }, { 1000, 2.8e6, 1.0 }, { 10000, 9e6, 0.8 } }, 1000) },
        { { "foam-tape", { "VHB" }, temperature, "3M VHB 4910 and 4950, typical" },
          polymer ({ { 1, 0.15e6, 0.4 }, { 10, 0.3e6, 0.7 }, { 100, 0.6e6, 1.0 }, { 1000, 2e6, 1.0 } }, 800) },
        { { "PVB", {}, "20 degrees Celsius; 0.5 MPa at 50 degrees Celsius", "interlayer of laminated glass, typical" },
          polymer ({ { 1, 30e6, 0.4 }, { 10, 70e6, 0.4 }, { 100, 130e6, 0.3 }, { 1000, 200e6, 0.25 } }, 1070) },
    } };
    return table;
}
} // namespace

std::span<const NamedViscoelasticMaterial> viscoelasticMaterials()
{
    return softTable();
}
} // namespace antinode
