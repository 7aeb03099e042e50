#pragma once

#include <Eigen/Core>

#include <array>
#include <complex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace antinode
{
/** An elastic material in plane stress. Isotropic: E1 = E2, G12 = E / (2 (1 + nu)). */
struct ElasticMaterial
{
    double youngsModulus1 = 0, youngsModulus2 = 0; ///< Pa, along x and y.
    double shearModulus = 0;                       ///< Pa
    double poissonRatio12 = 0;
    double density = 0; ///< kg/m^3
};

/** What a composite of piezoelectric fibres has beyond an isotropic ceramic: fibres run along the ceramic's length. */
struct FibreComposite
{
    double youngsModulus2 = 0;    ///< Pa, across the fibres.
    double shearModulus = 0;      ///< Pa
    double d32 = 0;               ///< m/V, strain across the fibres per field.
    double electrodeDistance = 0; ///< m: the field is the voltage over this, not over the thickness.
};

/** A piezoelectric ceramic, isotropic in its plane and poled through its thickness unless it is a composite of fibres.
 */
struct PiezoelectricMaterial
{
    double youngsModulus = 0;                ///< Pa, 1/s11E; along the fibres.
    double poissonRatio = 0;                 ///< -s12E/s11E
    double density = 0;                      ///< kg/m^3
    double d31 = 0;                          ///< m/V, negative for the usual ones; along the fibres.
    double permittivityRelative = 0;         ///< eps33T/eps0, 0 if not given
    std::optional<FibreComposite> fibres {}; ///< Of a macro-fibre composite.

    double shearModulus() const { return fibres ? fibres->shearModulus : youngsModulus / (2 * (1 + poissonRatio)); }
};

/** One term of Prony's series: a spring that relaxes. */
struct RelaxationTerm
{
    double shearModulus = 0; ///< Pa
    double time = 0;         ///< s
};

/** Shear modulus and loss factor at one frequency. */
struct ShearAtFrequency
{
    double frequency = 0;    ///< Hz
    double shearModulus = 0; ///< Pa, the real part.
    double lossFactor = 0;
};

/** A soft material whose shear modulus depends on frequency and is complex: a table, which holds beyond its ends and of
   which one row is a constant, or Prony's series. */
struct ViscoelasticMaterial
{
    std::vector<ShearAtFrequency> table; ///< Ascending in frequency; empty: Prony's series.
    double slowShearModulus = 0;         ///< Pa, of Prony's series at rest.
    std::vector<RelaxationTerm> relaxation;
    double poissonRatio = 0.49;
    double density = 0; ///< kg/m^3
};

/** A layer of a plate, from the bottom up. */
struct LayerDescription
{
    double thickness = 0; ///< m
    std::variant<ElasticMaterial, ViscoelasticMaterial> material;
};

/** Glue between a ceramic and the plate. It takes room, stiffens, and shears. Docs/Theory.md, section 1.16. */
struct GlueLayer
{
    double thickness = 0; ///< m
    ElasticMaterial material;
};

/** The metal disc of a bender, by which it is glued to the plate; the ceramic on it is smaller. */
struct CarrierDisc
{
    double thickness = 0; ///< m
    ElasticMaterial material;
    double ceramicDiameter = 0;   ///< m
    double electrodeDiameter = 0; ///< m, at most that of the ceramic: what is driven, and has the capacitance.
};

/** Where soft layers are taken for one section of all modes. */
struct SectionReference
{
    double waveNumber = 1;       ///< rad/m
    double angularFrequency = 1; ///< rad/s
};

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

/** The complex shear modulus of a viscoelastic material, Pa: real part and real part times loss factor. Between rows of
   a table the modulus is interpolated as a power of frequency, the loss factor over its logarithm; beyond its ends the
   table holds.
    @param angularFrequency  rad/s, above 0
    [any] Docs/Theory.md, section 1.15. */
std::complex<double> shearModulusAt (const ViscoelasticMaterial&, double angularFrequency);
} // namespace antinode
