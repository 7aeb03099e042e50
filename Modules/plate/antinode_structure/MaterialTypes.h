#pragma once

#include <Eigen/Core>

#include <optional>
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
} // namespace antinode
