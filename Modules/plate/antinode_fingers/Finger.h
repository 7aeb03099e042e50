#pragma once

#include <antinode_model/Surface.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace antinode
{
/** A finger that rests on the surface: a mass, a damper and a spring to ground, spread evenly over a disc. A model of a
   fingertip pressed along the normal, not of a person; nothing measured is known from 1 to 50 kHz. */
struct Finger
{
    std::string name;                         ///< For tables and messages: "medium", "thumb".
    double x = 0, y = 0;                      ///< Middle of the contact, m.
    double radius = 0.005;                    ///< Of the contact, m; 0: a point.
    double mass = 1e-4;                       ///< kg that moves with the surface.
    double damping = 1.5;                     ///< N s/m
    double stiffness = 600;                   ///< N/m
    bool isKnown = true;                      ///< False: it is on the plate, but no design knows of it.
    std::optional<double> pressingForce = {}; ///< N, static: it lifts off where the surface pulls more; none: never.

    bool operator== (const Finger&) const = default;
};

/** From where to where the literature leaves a property open. */
struct FingerRange
{
    double least = 0, most = 0;
};

/** A built-in finger. Docs/Theory.md, section 1.12, has the sources. */
struct FingerKind
{
    const char* name = "";
    double radius = 0, mass = 0, damping = 0, stiffness = 0; ///< m, kg, N s/m, N/m
};

inline constexpr std::array fingerKinds { FingerKind { "light", 0.004, 0.5e-4, 0.5, 300 },
                                          FingerKind { "medium", 0.005, 1.0e-4, 1.5, 600 },
                                          FingerKind { "firm", 0.006, 1.5e-4, 5.0, 1000 } };

/** What the literature leaves open around all of them, in SI units. */
inline constexpr FingerRange openFingerMass { 0.5e-4, 2e-4 }, openFingerDamping { 0.5, 10 },
    openFingerStiffness { 300, 2000 };

/** A built-in finger at a place of the surface.
    @param kind  light, medium or firm
    @param x, y  m
    @throws InputError  when there is no such kind [any] */
Finger builtInFinger (const std::string& kind, double x, double y);

/** Checks fingers on a surface: finite numbers, none below 0, the middle of each contact on the surface, and no two of
   them nearer than the sum of their radii, which no surface can tell apart.
    @throws InputError  naming the finger and the first thing that is wrong. [any] */
void validate (const std::vector<Finger>&, const Surface&);
} // namespace antinode
