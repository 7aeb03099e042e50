#include "FingerFile.h"

#include "FileUnits.h"
#include "FocusFile.h"

#include <antinode_text/JsonReader.h>

#include <nlohmann/json.hpp>

namespace antinode
{
namespace
{
constexpr NumberRange fingerMillimetres { 0, 20 };
constexpr NumberRange fingerGrams { 0, 10 };
constexpr NumberRange fingerDamping { 0, 1000 }; // N s/m
constexpr NumberRange fingerNewtonsPerMillimetre { 0, 100 };
constexpr NumberRange pressingNewtons { 0, 100 };
} // namespace

Finger readFinger (const JsonObject& object, double x, double y)
{
    const auto kind = object.optional ("kind");
    auto finger = builtInFinger (kind ? kind->choice (fingerKindWords) : "medium", x, y);

    if (const auto radius = object.optional ("radius_mm"))
        finger.radius = fromMillimetres (radius->number (fingerMillimetres));

    if (const auto mass = object.optional ("mass_g"))
        finger.mass = fromGrams (mass->number (fingerGrams));

    if (const auto damping = object.optional ("damping_N_s_per_m"))
        finger.damping = damping->number (fingerDamping);

    if (const auto stiffness = object.optional ("stiffness_N_per_mm"))
        finger.stiffness = fromNewtonsPerMillimetre (stiffness->number (fingerNewtonsPerMillimetre));

    if (const auto known = object.optional ("known"))
        finger.isKnown = known->boolean();

    if (const auto force = object.optional ("pressing_force_N"))
        finger.pressingForce = force->number (pressingNewtons);

    return finger;
}

Finger readFinger (const JsonValue& value, double x, double y)
{
    return value.isString() ? builtInFinger (value.choice (fingerKindWords), x, y)
                            : readFinger (value.object ({ fingerKeys.begin(), fingerKeys.end() }), x, y);
}

nlohmann::ordered_json fingerToJson (const Finger& finger)
{
    nlohmann::ordered_json object { { "x_mm", toMillimetres (finger.x) },
                                    { "y_mm", toMillimetres (finger.y) },
                                    { "kind", finger.name },
                                    { "radius_mm", toMillimetres (finger.radius) },
                                    { "mass_g", toGrams (finger.mass) },
                                    { "damping_N_s_per_m", finger.damping },
                                    { "stiffness_N_per_mm", toNewtonsPerMillimetre (finger.stiffness) },
                                    { "known", finger.isKnown } };

    if (finger.pressingForce)
        object["pressing_force_N"] = *finger.pressingForce;

    return object;
}
} // namespace antinode
