#include "Finger.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_model/Surface.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
std::string numberedFinger (std::size_t index)
{
    return "finger " + std::to_string (index + 1);
}

void requireFinite (const Finger& finger, const std::string& where)
{
    const auto check = [&] (const char* what, double value)
    {
        if (! (std::isfinite (value) && value >= 0))
            throw InputError (where + " " + what, "is " + inWords (value) + "; allowed: 0 or more");
    };
    if (! std::isfinite (finger.x) || ! std::isfinite (finger.y))
        throw InputError (where, "has a place that is not finite; allowed: mm on the surface");

    check ("radius", finger.radius);
    check ("mass", finger.mass);
    check ("damping", finger.damping);
    check ("stiffness", finger.stiffness);
}
} // namespace

Finger builtInFinger (const std::string& kind, double x, double y)
{
    const auto* const found =
        std::find_if (fingerKinds.begin(), fingerKinds.end(), [&] (const auto& each) { return kind == each.name; });

    if (found == fingerKinds.end())
        throw InputError ("finger '" + kind + "'", "is not known; allowed: light, medium, firm");

    Finger finger;
    finger.name = kind;
    finger.x = x;
    finger.y = y;
    finger.radius = found->radius;
    finger.mass = found->mass;
    finger.damping = found->damping;
    finger.stiffness = found->stiffness;
    return finger;
}

void validate (const std::vector<Finger>& fingers, const Surface& surface)
{
    for (std::size_t i = 0; i < fingers.size(); ++i)
    {
        const auto& finger = fingers[i];
        const auto where = numberedFinger (i);
        requireFinite (finger, where);
        requireOnSurface (surface, finger.x, finger.y, where);

        for (std::size_t j = 0; j < i; ++j)
            if (const auto distance = std::hypot (finger.x - fingers[j].x, finger.y - fingers[j].y);
                distance < std::max (finger.radius + fingers[j].radius, 1e-6))
                throw InputError (where, "is " + inWords (distance * milli) + " mm from " + numberedFinger (j)
                                             + "; allowed: at least "
                                             + inWords ((finger.radius + fingers[j].radius) * milli)
                                             + " mm, where their contacts meet");
    }
}
} // namespace antinode
