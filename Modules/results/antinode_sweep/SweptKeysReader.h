#pragma once

#include "SweepPlan.h"

#include <antinode_text/JsonReader.h>

#include <string>

namespace antinode
{
/** A key as --set has it, or one of a deviation. @param value  whose place errors name
    @throws InputError  when it is neither [worker] */
std::string readSweptKey (const JsonValue& value, const std::string& key);

/** A value of a key: no list and no object, which would change the document's shape.
    @throws InputError  when it is one [worker] */
const nlohmann::json& readScalar (const JsonValue&, const nlohmann::json& json);

/** An entry of "vary". @param json  the same value @throws InputError  as readSweepPlan [worker] */
SweptKeys readSweptKeys (const JsonValue&, const nlohmann::json& json);
} // namespace antinode
