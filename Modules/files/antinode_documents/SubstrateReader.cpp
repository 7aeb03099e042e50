#include "SubstrateReader.h"

#include "DampingReader.h"
#include "FileUnits.h"
#include "MaterialReader.h"

#include <antinode_structure/SoftLayers.h>
#include <antinode_text/PhysicalRanges.h>

#include <algorithm>

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
} // namespace antinode
