#include "Materials.h"

namespace antinode
{
namespace
{
constexpr std::string_view general =
    "E 5 %, d31 and permittivity 10 to 20 % between batches; they grow with field and fall with age";
constexpr std::string_view clevite = "Jaffe, Cook, Jaffe, Piezoelectric Ceramics (1971); Morgan TP-226";
constexpr std::string_view erturk = "Erturk and Inman, Piezoelectric Energy Harvesting (2011), table E.1";
constexpr std::string_view smartMaterial = "Smart Material, MFC properties at low field";

constexpr FibreComposite fibres (double d32, double electrodeDistance)
{
    return { 15.857e9, 5.515e9, d32, electrodeDistance };
}

/** E = 1/s11, nu = -s12/s11. NCE51: s11 = 16e-12 1/Pa, s12 = -5.0e-12 1/Pa. Constants of a macro-fibre composite refer
   to its whole thickness of 0.3 mm, and its capacitance follows from no permittivity. */
constexpr std::array<NamedPiezoelectricMaterial, 10> piezoelectricTable { {
    { { "NCE51", { "NC51" }, general, "data sheet of Noliac" }, { 62.5e9, 0.31, 7800, -195e-12, 1850 } },
    { { "PZT-4", { "Navy-I" }, general, clevite }, { 81.3e9, 0.329, 7500, -123e-12, 1300 } },
    { { "PZT-5A", { "Navy-II" }, general, erturk }, { 61.0e9, 0.35, 7750, -171e-12, 1700 } },
    { { "PZT-5H", { "Navy-VI" }, general, erturk }, { 60.6e9, 0.29, 7500, -274e-12, 3400 } },
    { { "PZT-8", { "Navy-III" }, general, clevite }, { 87e9, 0.32, 7600, -97e-12, 1000 } },
    { { "PIC151", {}, general, "catalogue of PI Ceramic" }, { 66.7e9, 0.34, 7800, -210e-12, 2400 } },
    { { "PIC255", {}, general, "catalogue of PI Ceramic" }, { 62.1e9, 0.34, 7800, -180e-12, 1750 } },
    { { "PVDF",
        {},
        "biaxially drawn film: d31 5 to 10 pm/V; drawn along x only it has 20 pm/V there and 3 across",
        "handbooks; typical" },
      { 2.5e9, 0.35, 1780, 8e-12, 12 } },
    { { "MFC-P1",
        { "MFC" },
        "d33 grows by 15 % to high field; fibres along x, voltage between fingers",
        smartMaterial },
      { 30.336e9, 0.31, 5440, 400e-12, 0, fibres (-170e-12, 0.5e-3) } },
    { { "MFC-P2",
        {},
        "d31 grows with field; fibres along x, voltage through 0.18 mm; across the fibres as along them",
        smartMaterial },
      { 30.336e9, 0.31, 5440, -170e-12, 0, fibres (-170e-12, 0.18e-3) } },
} };
} // namespace

std::span<const NamedPiezoelectricMaterial> piezoelectricMaterials()
{
    return piezoelectricTable;
}
} // namespace antinode
