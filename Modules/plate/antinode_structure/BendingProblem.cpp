#include "BendingProblem.h"

#include <antinode_outline/PathBuilder.h>

#include <array>
#include <cmath>

namespace antinode
{
namespace
{
/** e^-x I0 (x) to 2e-7, which is asked for at every place of a cell. Abramowitz and Stegun, 9.8.1 and 9.8.2. */
double besselWithoutGrowth (double x)
{
    constexpr double border = 3.75;
    constexpr std::array small { 1.0, 3.5156229, 3.0899424, 1.2067492, 0.2659732, 0.0360768, 0.0045813 };
    constexpr std::array large { 0.39894228,  0.01328592, 0.00225319,  -0.00157565, 0.00916281,
                                 -0.02057706, 0.02635537, -0.01647633, 0.00392377 };
    const auto polynomial = [] (const auto& coefficients, double t)
    {
        double sum = 0;

        for (auto c = coefficients.rbegin(); c != coefficients.rend(); ++c)
            sum = sum * t + *c;

        return sum;
    };
    const auto t = x / border;
    return x < border ? polynomial (small, t * t) * std::exp (-x) : polynomial (large, 1 / t) / std::sqrt (x);
}
} // namespace

double bondedShare (double offset, double half, double length)
{
    if (! (length > 0))
        return 1;

    // cosh (offset / length) / cosh (half / length), where both may be beyond all numbers.
    const auto decay = std::exp ((std::abs (offset) - half) / length);
    return 1 - decay * (1 + std::exp (-2 * std::abs (offset) / length)) / (1 + std::exp (-2 * half / length));
}

double bondedShareOfDisc (double distance, double radius, double length)
{
    if (! (length > 0))
        return 1;

    return 1
           - std::exp ((distance - radius) / length) * besselWithoutGrowth (distance / length)
                 / besselWithoutGrowth (radius / length);
}

BondedStiffness BondedStiffness::of (const Eigen::Matrix3d& stiffness)
{
    const auto coupling = stiffness (0, 1);
    const auto alone = [&] (Eigen::Index axis, Eigen::Index other)
    { return stiffness (axis, axis) - (coupling != 0 ? coupling * coupling / stiffness (other, other) : 0); };
    const auto first = alone (0, 1), second = alone (1, 0);
    return { first, second, stiffness (0, 0) - first, stiffness (1, 1) - second, coupling, stiffness (2, 2) };
}

BondedPart scaledPart (BondedPart part, double length, double stiffness)
{
    part.stiffness /= stiffness;
    part.curvaturePerVolt *= stiffness;

    for (auto* const lengths : { &part.centre, &part.half, &part.lengths, &part.shearLengths })
        *lengths /= length;

    return part;
}

Eigen::Matrix3d BondedPart::stiffnessAt (const Eigen::Vector2d& place) const
{
    const Eigen::Vector2d offset = place - centre;
    double axis = angle, first = 1, second = 1, shear = 1;

    if (isRound)
    {
        const auto distance = offset.norm();
        axis = std::atan2 (offset.y(), offset.x());
        const auto shareOf = [&] (double length)
        {
            return half.y() > 0 ? bondedShare (distance - (half.x() + half.y()) / 2, (half.x() - half.y()) / 2, length)
                                : bondedShareOfDisc (distance, half.x(), length);
        };
        first = shareOf (lengths.x());
        shear = shareOf (shearLengths.x());
    }
    else
    {
        const auto cosine = std::cos (angle), sine = std::sin (angle);
        const auto along = cosine * offset.x() + sine * offset.y(), across = cosine * offset.y() - sine * offset.x();
        first = bondedShare (along, half.x(), lengths.x());
        second = bondedShare (across, half.y(), lengths.y());
        shear = bondedShare (along, half.x(), shearLengths.x()) * bondedShare (across, half.y(), shearLengths.y());
    }

    const auto whole = turnedSection ({ stiffness }, -axis).stiffness;
    const auto parts = BondedStiffness::of (whole);
    const auto both = first * second;
    Eigen::Matrix3d there = both * whole; // What fibres couple needs both, too.
    there (0, 0) = parts.first * first + parts.bothFirst * both;
    there (1, 1) = parts.second * second + parts.bothSecond * both;
    there (2, 2) = parts.shear * shear;
    return turnedSection ({ there }, axis).stiffness;
}

BendingSection turnedSection (const BendingSection& section, double angle)
{
    // Curvatures along the material's axes from those along x and y; energies are the same in both.
    const auto c = std::cos (angle), s = std::sin (angle);
    Eigen::Matrix3d curvatures;
    curvatures << c * c, s * s, c * s, s * s, c * c, -c * s, -2 * c * s, 2 * c * s, c * c - s * s;
    return { curvatures.transpose() * section.stiffness * curvatures, section.massPerArea, section.rotaryInertia };
}

Eigen::Matrix3d BendingPatch::stiffnessAt (const Eigen::Vector2d& place) const
{
    return bonded ? Eigen::Matrix3d (added.stiffness + bonded->stiffnessAt (place)) : added.stiffness;
}

Eigen::Vector3d BendingPatch::momentAt (const Eigen::Vector2d& place) const
{
    return bonded ? Eigen::Vector3d (moment + bonded->momentAt (place)) : moment;
}

double eigenvalueUnit (const BendingProblem& problem)
{
    return problem.section.stiffness.diagonal().maxCoeff() / problem.section.massPerArea
           / std::pow (extentOf (problem.outline).size().maxCoeff(), 4);
}

namespace
{
/** Vanishes on a circle with a slope of 1 across it. @param side  1: positive within it, -1: outside */
KinkFunction circleKink (const Eigen::Vector2d& centre, double radius, double side, double width, int edge)
{
    return { centre, Eigen::Vector2d::Zero(), side * radius / 2, -side / radius, edge, width };
}
} // namespace

BendingPatch rectanglePatch (const Eigen::Vector2d& centre, const Eigen::Vector2d& size, double angle)
{
    BendingPatch patch;
    patch.outline.paths = { rectanglePath (centre, size, angle, { 0, 0, 0, 0 }, 0) };

    for (const auto& piece : patch.outline.paths.front())
    {
        const Eigen::Vector2d inward = Eigen::Vector2d (-piece.cosine.y(), piece.cosine.x()).normalized();
        patch.kinks.push_back ({ piece.start, inward, 0, 0, piece.edge, inward.dot (centre - piece.start) });
    }

    return patch;
}

BendingPatch discPatch (const Eigen::Vector2d& centre, double radius)
{
    BendingPatch patch;
    patch.outline.paths = { circlePath (centre, radius, 0) };
    patch.kinks = { circleKink (centre, radius, 1, radius, 0) };
    return patch;
}

BendingPatch ringPatch (const Eigen::Vector2d& centre, double radius, double innerRadius)
{
    auto patch = discPatch (centre, radius);
    patch.outline.paths.push_back (circlePath (centre, innerRadius, 1));
    patch.kinks.push_back (circleKink (centre, innerRadius, -1, radius - innerRadius, 1));
    return patch;
}
} // namespace antinode
