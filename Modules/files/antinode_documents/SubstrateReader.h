#pragma once

#include <antinode_structure/DeviceDescription.h>
#include <antinode_text/JsonReader.h>

namespace antinode
{
/** The keys of a substrate beyond thickness and material: layers of a plate, the theory of its bending. */
inline constexpr std::string_view layersKey = "layers", theoryKey = "theory";

/** What a device is made of without its ceramics: thickness and material, or layers from the bottom up; the theory of
    its bending; damping, which a laminate with soft layers need not have.
    @param body  of a device; only those of plates know layers
    @throws InputError [worker] */
void readSubstrate (StructureCommon&, const JsonObject& body);

/** The glue of a ceramic, where it has any. @throws InputError [worker] */
std::optional<GlueLayer> readGlue (const JsonObject& ceramic);

/** The metal disc of a disc bender, by the diameter of its ceramic, m. @throws InputError [worker] */
CarrierDisc readCarrier (const JsonValue& carrier, double ceramicDiameter);

/** Its diameter, m. @throws InputError  where it is not larger than the ceramic [worker] */
double readCarrierDiameter (const JsonValue& carrier, double ceramicDiameter);

/** A substrate's material: the name of a built-in one, or its constants. @throws InputError [worker] */
ElasticMaterial readElasticMaterial (const JsonValue&);

/** A ceramic's material: the name of a built-in one, or its constants. @throws InputError [worker] */
PiezoelectricMaterial readPiezoelectricMaterial (const JsonValue&);

/** A layer's material, elastic or viscoelastic: the name of a built-in one, or its constants. @throws InputError
    [worker] */
std::variant<ElasticMaterial, ViscoelasticMaterial> readLayerMaterial (const JsonValue&);
} // namespace antinode
