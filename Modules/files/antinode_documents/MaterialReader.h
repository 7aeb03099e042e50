#pragma once

#include <antinode_structure/DeviceDescription.h>
#include <antinode_text/JsonReader.h>

namespace antinode
{
/** A substrate's material: the name of a built-in one, or its constants. @throws InputError [worker] */
ElasticMaterial readElasticMaterial (const JsonValue&);

/** A ceramic's material: the name of a built-in one, or its constants. @throws InputError [worker] */
PiezoelectricMaterial readPiezoelectricMaterial (const JsonValue&);

/** A layer's material, elastic or viscoelastic: the name of a built-in one, or its constants. @throws InputError
    [worker] */
std::variant<ElasticMaterial, ViscoelasticMaterial> readLayerMaterial (const JsonValue&);
} // namespace antinode
