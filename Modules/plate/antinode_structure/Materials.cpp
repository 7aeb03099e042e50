#include "Materials.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <numbers>

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

namespace
{
std::complex<double> lossy (double shearModulus, double lossFactor)
{
    return { shearModulus, shearModulus * lossFactor };
}

std::complex<double> fromTable (const std::vector<ShearAtFrequency>& table, double frequency)
{
    const auto above =
        std::upper_bound (table.begin(), table.end(), frequency,
                          [] (double value, const ShearAtFrequency& row) { return value < row.frequency; });

    if (above == table.begin())
        return lossy (table.front().shearModulus, table.front().lossFactor);

    if (above == table.end())
        return lossy (table.back().shearModulus, table.back().lossFactor);

    const auto& below = *std::prev (above);
    const auto share = std::log (frequency / below.frequency) / std::log (above->frequency / below.frequency);
    return lossy (below.shearModulus * std::pow (above->shearModulus / below.shearModulus, share),
                  std::lerp (below.lossFactor, above->lossFactor, share));
}
} // namespace

std::complex<double> shearModulusAt (const ViscoelasticMaterial& material, double angularFrequency)
{
    if (! material.table.empty())
        return fromTable (material.table, angularFrequency / (2 * std::numbers::pi));

    std::complex<double> modulus = material.slowShearModulus;

    for (const auto& term : material.relaxation)
    {
        const std::complex<double> phase (0, angularFrequency * term.time);
        modulus += term.shearModulus * phase / (1.0 + phase);
    }

    return modulus;
}

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
