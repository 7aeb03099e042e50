#include "BendingExamples.h"

#include <algorithm>
#include <numbers>
#include <random>

using namespace antinode;
using namespace antinode::examples;

namespace
{
ClosedPath rectangle (double sizeX, double sizeY, double radius = 0)
{
    return rectanglePath ({ sizeX / 2, sizeY / 2 }, { sizeX, sizeY }, 0, { radius, radius, radius, radius }, 0);
}

std::vector<Eigen::Vector2d> cornersOf (bool isNotch)
{
    if (isNotch)
        return { { 0, 0 }, { 1, 0 }, { 1, 0.5 }, { 0.6, 0.5 }, { 0.6, 0.2 }, { 0.4, 0.2 }, { 0.4, 0.5 }, { 0, 0.5 } };

    return { { 0, 0 }, { 1, 0 }, { 1, 0.5 }, { 0.5, 0.5 }, { 0.5, 1 }, { 0, 1 } };
}

/** Each of some values has one of the frequencies beside it: those of modes that do not move at a point are more. */
double largestDistance (const Eigen::VectorXd& found, const std::vector<double>& values)
{
    double largest = 0;

    for (const auto value : values)
        largest = std::max (largest, (found.array() / value - 1).abs().minCoeff());

    return largest;
}
} // namespace

TEST_CASE ("Free plates with rounded corners, with and without a hole, to 1e-5", "[immersed][plate]")
{
    const auto& references = outlineReferences()["rounded"];
    const auto corner = rectangle (1, 0.5, 1.0 / 15);
    const auto plain = unitPlate (0.22, { corner }, { 4, freeEdge });
    CHECK (deviationFrom (frequencies (plain, 20), references["rounded_rect"]["values"]) < 1e-5);
    const auto pierced = unitPlate (0.22, { corner, circlePath ({ 0.7, 1.0 / 3 }, 0.0266667, 4) }, { 5, freeEdge });
    CHECK (deviationFrom (frequencies (pierced, 20), references["rounded_rect_hole"]["values"]) < 1e-5);
}

TEST_CASE ("An L and a notch have their modes to 2e-4", "[immersed][plate]")
{
    const auto isNotch = GENERATE (false, true);
    const auto isClamped = GENERATE (false, true);
    const auto corners = cornersOf (isNotch);
    auto problem = unitPlate (0.3, { polygonPath (corners, 0) }, { corners.size(), freeEdge });

    if (isClamped)
        problem.edges.back() = clampedEdge;

    const auto name = std::string (isNotch ? "notch" : "L") + (isClamped ? "_clamped_x0" : "_free");
    CAPTURE (name);
    CHECK (deviationFrom (frequencies (problem, 20), outlineReferences()["reentrant"][name]["values"]) < 5e-5);
}

TEST_CASE ("Rectangles on springs to 1e-6", "[immersed][plate]")
{
    const auto& references = outlineReferences()["rect_elastic"];

    for (const auto& [translation, rotation, name] : { std::tuple (0.0, 0.0, "kT0_kR0"),
                                                       { 10.0, 0.0, "kT10_kR0" },
                                                       { 100.0, 0.0, "kT100_kR0" },
                                                       { 1000.0, 5.0, "kT1000_kR5" } })
    {
        CAPTURE (name);
        const EdgeSupport springs { false, false, translation, rotation };
        const auto all = unitPlate (0.22, { rectangle (1, 0.5) }, { 4, springs });
        CHECK (deviationFrom (frequencies (all, 20), references["all4_" + std::string (name)]["values"]) < 1e-6);
        const auto levy = unitPlate (0.22, { rectangle (1, 0.5) }, { springs, supportedEdge, springs, supportedEdge });
        CHECK (deviationFrom (frequencies (levy, 20), references["levy_x_ss_y_" + std::string (name)]["values"])
               < 1e-6);
    }

    const auto uneven =
        unitPlate (0.22, { rectangle (1, 0.5) },
                   { { false, false, 3, 0 }, freeEdge, { false, false, 70, 1 }, { false, false, 1000, 5 } });
    CHECK (deviationFrom (frequencies (uneven, 20), references["uneven"]["values"]) < 1e-6);
}

TEST_CASE ("Masses and springs at points to 1e-5", "[immersed][plate]")
{
    const std::vector<std::pair<std::string, PointAttachment>> cases { { "mass", { { 0.3, 0.25 }, 0, 0.05 } },
                                                                       { "spring", { { 0.3, 0.25 }, 300, 0 } },
                                                                       { "both", { { 0.42, 0.51 }, 80, 0.02 } } };

    for (const auto& [name, point] : cases)
    {
        CAPTURE (name);
        auto problem = unitPlate (0.3, { rectangle (1, 0.7) }, { 4, supportedEdge });
        problem.points = { point };
        CHECK (largestDistance (frequencies (problem, 30),
                                outlineReferences()["point"][name]["values"].get<std::vector<double>>())
               < 1e-5);
    }
}

TEST_CASE ("A foundation adds k/m to every eigenvalue, rigid motions included", "[immersed][plate]")
{
    auto problem = unitPlate (0.3, { ellipsePath ({ 0, 0 }, { 1, 0.6 }, 0.4, 0) }, { freeEdge });
    const auto bare = frequencies (problem, 12);
    problem.foundation = 200;
    const auto held = frequencies (problem, 15);

    for (Eigen::Index k = 0; k < 15; ++k)
        CHECK (held[k] == Approx (std::sqrt (200 + (k < 3 ? 0 : bare[k - 3] * bare[k - 3]))).epsilon (1e-6));

    // The same as a pad over a part that is nearly all.
    problem.foundation = 0;
    BendingPatch pad;
    pad.outline.paths = { ellipsePath ({ 0, 0 }, { 0.9999, 0.5999 }, 0.4, 0) };
    pad.foundation = 200;
    problem.patches.push_back (pad);
    CHECK (frequencies (problem, 3)[2] == Approx (std::sqrt (200)).epsilon (1e-3));
}

TEST_CASE ("Turned by any angle a plate has the same modes", "[immersed][plate]")
{
    std::mt19937 random (3);
    std::uniform_real_distribution<> any (0, 1);
    const auto edge = GENERATE (freeEdge, supportedEdge, clampedEdge);
    const auto straight = unitPlate (0.22, { rectangle (1, 0.6, 0.1) }, { 4, edge });
    const auto expected = frequencies (straight, 30, ModeAccuracy::high);

    for (int i = 0; i < 4; ++i)
    {
        auto turned = straight;
        turned.outline = moved (straight.outline, 2 * std::numbers::pi * any (random), { any (random), any (random) });
        CAPTURE (i);
        CHECK ((frequencies (turned, 30).array() / expected.array() - 1).abs().maxCoeff() < 1e-4);
    }
}

TEST_CASE ("Where a smooth edge is clamped from one place on, modes hold to 3e-3 at any angle", "[immersed][plate]")
{
    // Moments are as unbounded there as at a crack's tip.
    const auto straight =
        unitPlate (0.22, { rectangle (1, 0.6, 0.1) }, { clampedEdge, freeEdge, supportedEdge, freeEdge });
    const auto expected = frequencies (straight, 20, ModeAccuracy::high);

    for (const auto angle : { 0.3, 1.1, 2.5, 4.0 })
    {
        auto turned = straight;
        turned.outline = moved (straight.outline, angle, { 0.2, 0.1 });
        CAPTURE (angle);
        CHECK ((frequencies (turned, 20).array() / expected.array() - 1).abs().maxCoeff() < 3e-3);
    }
}

TEST_CASE ("An orthotropic plate turned with its material has the same modes", "[immersed][plate]")
{
    auto straight = unitPlate (0.3, { rectangle (1, 0.6) }, { 4, freeEdge });
    straight.section.stiffness << 3, 0.2, 0, 0.2, 1, 0, 0, 0, 0.4;
    auto turned = straight;
    turned.outline = moved (straight.outline, 0.5, { 0, 0 });
    turned.section = turnedSection (straight.section, 0.5);
    CHECK ((frequencies (turned, 30).array() / frequencies (straight, 30).array() - 1).abs().maxCoeff() < 1e-6);
}

TEST_CASE ("A motion that nothing holds is known exactly", "[immersed][plate]")
{
    // Hinged along one edge it turns; on two springs it turns about the line through them; on three it is held.
    auto problem = unitPlate (0.3, { rectangle (1, 0.6) }, { supportedEdge, freeEdge, freeEdge, freeEdge });
    const auto rigidModes = [&]
    { return bendingModes (problem, 5, resolutionFor (problem, 5, ModeAccuracy::usual)).rigidBodyModes; };
    CHECK (rigidModes() == 1);
    problem.edges[0] = freeEdge;
    problem.points = { { { 0.2, 0.2 }, 50, 0 }, { { 0.8, 0.5 }, 50, 0 } };
    CHECK (rigidModes() == 1);
    problem.points.push_back ({ { 0.8, 0.1 }, 50, 0 });
    CHECK (rigidModes() == 0);
}
