#include "SubstrateReader.h"

#include "FileUnits.h"
#include "SharedFields.h"

#include <antinode_base/MessageText.h>
#include <antinode_structure/Materials.h>
#include <antinode_structure/PlateWaves.h>
#include <antinode_text/JsonReader.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
constexpr std::size_t maximumLayers = 50;
// Epoxy as it is usually applied.
constexpr double usualGlueThickness = 50e-6, usualGlueModulus = 2.5e9, usualGluePoissonRatio = 0.36,
                 usualGlueDensity = 1150;
constexpr NumberRange glueModulusGigapascal { 1e-6, 1e3 };

constexpr WordList<BendingTheory, 3> plateTheoryWords {
    { { "mindlin", BendingTheory::thick }, { "kirchhoff", BendingTheory::thin }, { "thin", BendingTheory::thin } }
}; // As in older files.
constexpr WordList<BendingTheory, 2> beamTheoryWords { { { "timoshenko", BendingTheory::thick },
                                                         { "euler_bernoulli", BendingTheory::thin } } };

GlueLayer glueOf (double thickness, double modulus)
{
    return { thickness,
             { modulus, modulus, modulus / (2 * (1 + usualGluePoissonRatio)), usualGluePoissonRatio,
               usualGlueDensity } };
}

double readThickness (const JsonObject& object)
{
    return fromMillimetres (object.required ("thickness_mm").number (ranges::lengthMillimetre));
}

void readLayers (StructureCommon& common, const JsonValue& list)
{
    for (const auto& item : list.items (1, maximumLayers))
    {
        const auto object = item.object ({ "material", "thickness_mm" });
        common.layers.push_back ({ readThickness (object), readLayerMaterial (object.required ("material")) });
        common.thickness += common.layers.back().thickness;
    }

    const auto stiff = std::find_if (common.layers.begin(), common.layers.end(),
                                     [] (const LayerDescription& layer)
                                     { return std::holds_alternative<ElasticMaterial> (layer.material); });

    if (stiff == common.layers.end())
        list.fail ("has soft layers only; allowed: at least one layer of an elastic material");

    common.material = std::get<ElasticMaterial> (stiff->material);
}
} // namespace

void readSubstrate (StructureCommon& common, const JsonObject& body)
{
    if (const auto layers = body.optional (layersKey))
    {
        for (const auto key : { "thickness_mm", "material" })
            if (const auto given = body.optional (key))
                given->fail ("is given with 'layers', which define it");

        readLayers (common, *layers);
    }
    else
    {
        common.thickness = readThickness (body);
        common.material = readElasticMaterial (body.required ("material"));
    }

    common.theory = hasSoftLayers (common) ? BendingTheory::thin : BendingTheory::thick;

    if (const auto theory = body.optional (theoryKey))
    {
        const auto isLine = body.has ("width_mm"); // Beams and staples have one.
        common.theory = isLine ? theory->choice (beamTheoryWords) : theory->choice (plateTheoryWords);

        if (common.theory == BendingTheory::thick && hasSoftLayers (common))
            theory->fail ("is 'mindlin', but a laminate with soft layers shears in these; allowed: 'kirchhoff'");
    }

    if (! hasSoftLayers (common) || body.has ("damping_ratio") || body.has ("quality_factor"))
        common.dampingRatios = readDampingRatios (body);
}

std::optional<GlueLayer> readGlue (const JsonObject& ceramic)
{
    const auto given = ceramic.optional ("glue");

    if (! given)
        return glueOf (usualGlueThickness, usualGlueModulus);

    if (given->isString())
    {
        given->choice (WordList<bool, 1> { { { "rigid", true } } });
        return {};
    }

    const auto object = given->object ({ "thickness_mm", "youngs_modulus_GPa" });
    constexpr double pascals = 1e9;
    const auto modulus = pascals * object.required ("youngs_modulus_GPa").number (glueModulusGigapascal);
    return glueOf (readThickness (object), modulus);
}

CarrierDisc readCarrier (const JsonValue& carrier, double ceramicDiameter)
{
    const auto object = carrier.object ({ "diameter_mm", "thickness_mm", "material", "electrode_diameter_mm" });
    CarrierDisc disc { readThickness (object), readElasticMaterial (object.required ("material")), ceramicDiameter,
                       ceramicDiameter };

    if (const auto electrode = object.optional ("electrode_diameter_mm"))
        disc.electrodeDiameter =
            fromMillimetres (electrode->number ({ ranges::lengthMillimetre.minimum, toMillimetres (ceramicDiameter) }));

    return disc;
}

double readCarrierDiameter (const JsonValue& carrier, double ceramicDiameter)
{
    const NumberRange allowed { toMillimetres (ceramicDiameter), ranges::lengthMillimetre.maximum, true };
    return fromMillimetres (carrier.required ("diameter_mm").number (allowed));
}

namespace
{
constexpr double pascalsPerGigapascal = 1e9, pascalsPerMegapascal = 1e6;
constexpr NumberRange modulusGigapascal { 1e-6, 1e4 };
constexpr NumberRange density { 1, 50000 };
constexpr NumberRange poissonRatio { -0.99, 0.5 };
constexpr NumberRange orthotropicPoissonRatio { -10, 10 };
constexpr NumberRange viscoelasticPoissonRatio { 0, 0.5, false, true };
constexpr NumberRange shearModulusMegapascal { 1e-6, 1e5 };
constexpr NumberRange viscoelasticLoss { 0, 5 };
constexpr NumberRange relaxationTime { 1e-9, 1e6 };
constexpr std::size_t maximumRows = 1000;
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

/** The orthotropic constants of an object. */
ElasticMaterial readElastic (const JsonObject& object)
{
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

[[noreturn]] void failName (const JsonValue& value, const std::vector<std::string>& names)
{
    const std::vector<std::string_view> words (names.begin(), names.end());
    value.fail (value.description() + didYouMean (value.text (ranges::maximumNameBytes), words) + "; allowed: one of "
                + listed (words) + ", or an object with the constants of the material");
}

template <typename Material>
Material builtIn (const JsonValue& value, const std::optional<Material>& found, const std::vector<std::string>& names)
{
    if (found)
        return *found;

    failName (value, names);
}

/** A piezoelectric composite of fibres. */
PiezoelectricMaterial readFibreComposite (const JsonValue& value)
{
    const auto object = value.object ({ "E1_GPa", "E2_GPa", "G12_GPa", "nu12", "density_kg_m3", "d31_m_per_V",
                                        "d32_m_per_V", "electrode_distance_mm" });
    const auto elastic = readElastic (object);
    PiezoelectricMaterial material;
    material.youngsModulus = elastic.youngsModulus1;
    material.poissonRatio = elastic.poissonRatio12;
    material.density = elastic.density;
    material.d31 = object.required ("d31_m_per_V").number (d31);
    material.fibres = { elastic.youngsModulus2, elastic.shearModulus, object.required ("d32_m_per_V").number (d31),
                        fromMillimetres (object.required ("electrode_distance_mm").number (ranges::lengthMillimetre)) };
    return material;
}

double readShearModulus (const JsonObject& object, std::string_view key)
{
    return object.required (key).number (shearModulusMegapascal) * pascalsPerMegapascal;
}

std::vector<ShearAtFrequency> readShearTable (const JsonValue& list)
{
    std::vector<ShearAtFrequency> table;

    for (const auto& item : list.items (1, maximumRows))
    {
        const auto row = item.object ({ "frequency_Hz", "shear_modulus_MPa", "loss_factor" });
        table.push_back ({ row.required ("frequency_Hz").number (ranges::frequencyHz),
                           readShearModulus (row, "shear_modulus_MPa"),
                           row.required ("loss_factor").number (viscoelasticLoss) });

        if (table.size() > 1 && ! (table.back().frequency > table[table.size() - 2].frequency))
            item.fail ("has no higher frequency than the row before; allowed: ascending frequencies");
    }

    return table;
}

void readProny (ViscoelasticMaterial& material, const JsonValue& value)
{
    const auto prony = value.object ({ "slow_shear_modulus_MPa", "terms" });
    material.slowShearModulus = readShearModulus (prony, "slow_shear_modulus_MPa");

    for (const auto& item : prony.required ("terms").items (1, maximumRows))
    {
        const auto term = item.object ({ "shear_modulus_MPa", "time_s" });
        material.relaxation.push_back (
            { readShearModulus (term, "shear_modulus_MPa"), term.required ("time_s").number (relaxationTime) });
    }
}

ViscoelasticMaterial readViscoelastic (const JsonValue& value)
{
    const auto object =
        value.object ({ "shear_modulus_MPa", "loss_factor", "table", "prony", "poisson_ratio", "density_kg_m3" });
    ViscoelasticMaterial material;
    material.density = object.required ("density_kg_m3").number (density);

    if (const auto ratio = object.optional ("poisson_ratio"))
        material.poissonRatio = ratio->number (viscoelasticPoissonRatio);

    if (object.has ("table") + object.has ("prony") + object.has ("shear_modulus_MPa") != 1)
        object.fail ("needs one of 'shear_modulus_MPa' (with 'loss_factor'), 'table' and 'prony'");

    if (const auto table = object.optional ("table"))
        material.table = readShearTable (*table);
    else if (const auto prony = object.optional ("prony"))
        readProny (material, *prony);
    else
        material.table = { { 1, readShearModulus (object, "shear_modulus_MPa"),
                             object.required ("loss_factor").number (viscoelasticLoss) } };

    if (object.has ("loss_factor") && ! object.has ("shear_modulus_MPa"))
        object.required ("loss_factor").fail ("is given with 'table' or 'prony', which define the loss factor");

    return material;
}
} // namespace

ElasticMaterial readElasticMaterial (const JsonValue& value)
{
    if (value.isString())
        return builtIn (value, findElasticMaterial (value.text (ranges::maximumNameBytes)), elasticMaterialNames());

    return value.find ("E1_GPa")
               ? readElastic (value.object ({ "E1_GPa", "E2_GPa", "G12_GPa", "nu12", "density_kg_m3" }))
               : readIsotropic (value);
}

PiezoelectricMaterial readPiezoelectricMaterial (const JsonValue& value)
{
    if (value.isString())
        return builtIn (value, findPiezoelectricMaterial (value.text (ranges::maximumNameBytes)),
                        piezoelectricMaterialNames());

    if (value.find ("E1_GPa"))
        return readFibreComposite (value);

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

std::variant<ElasticMaterial, ViscoelasticMaterial> readLayerMaterial (const JsonValue& value)
{
    if (! value.isString())
    {
        if (value.find ("E1_GPa") || value.find ("youngs_modulus_GPa"))
            return readElasticMaterial (value);

        return readViscoelastic (value);
    }

    const auto name = value.text (ranges::maximumNameBytes);

    if (const auto elastic = findElasticMaterial (name))
        return *elastic;

    if (const auto viscoelastic = findViscoelasticMaterial (name))
        return *viscoelastic;

    auto names = viscoelasticMaterialNames();
    const auto elasticNames = elasticMaterialNames();
    names.insert (names.end(), elasticNames.begin(), elasticNames.end());
    failName (value, names);
}
} // namespace antinode
