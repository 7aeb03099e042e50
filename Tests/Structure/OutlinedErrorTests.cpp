#include "PlateExamples.h"

#include "Immersed/BendingExamples.h"
#include "Support/CircularPlates.h"

#include <antinode_outline/PathBuilder.h>
#include <antinode_structure/OutlinedModel.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

using namespace antinode;
using namespace antinode::examples;

namespace
{
constexpr int modesWithErrors = 40;

/** Isotropic, 1 mm thick, nu 0.3. */
OutlinedPlate bareOutlined (std::vector<ClosedPath> paths, std::vector<PlateEdge> edges)
{
    OutlinedPlate plate;
    plate.common = barePlate ("FFFF", 0.1, 0.1).common;
    plate.outline.paths = std::move (paths);
    plate.edges = std::move (edges);
    return plate;
}

double bendingStiffness (const OutlinedPlate& plate)
{
    const auto& material = plate.common.material;
    return material.youngsModulus1 * std::pow (plate.common.thickness, 3)
           / (12 * (1 - material.poissonRatio12 * material.poissonRatio12));
}

double massPerArea (const OutlinedPlate& plate)
{
    return plate.common.material.density * plate.common.thickness;
}

PlateEdge edgeOf (EdgeCondition condition)
{
    PlateEdge edge;
    edge.condition = condition;
    return edge;
}

tests::CircularEdge circularEdge (EdgeCondition condition)
{
    return { condition == EdgeCondition::free ? 0 : tests::rigid,
             condition == EdgeCondition::clamped ? tests::rigid : 0 };
}

/** The largest of true errors over estimated ones. */
double worstRatio (const ModalModel& model, const std::vector<double>& expected)
{
    double worst = 0;

    for (Eigen::Index k = 0; k < model.modes(); ++k)
        worst = std::max (worst, std::abs (model.angularFrequencies[k] / expected[static_cast<std::size_t> (k)] - 1)
                                     / model.frequencyErrors[k]);

    return worst;
}

/** Of a disc, or of a ring with a free hole. */
void checkRound (EdgeCondition outer, double radius, double hole, int count)
{
    std::vector<ClosedPath> paths { circlePath ({ 0, 0 }, radius, 0) };
    std::vector<PlateEdge> edges { edgeOf (outer) };

    if (hole > 0)
    {
        paths.push_back (circlePath ({ 0, 0 }, hole, 1));
        edges.push_back (edgeOf (EdgeCondition::free));
    }

    const auto plate = bareOutlined (paths, edges);
    const auto model = solveOutlinedPlate ("round", plate, count);
    std::vector<double> expected;

    for (const auto& mode : tests::circularModes (
             { hole, { { radius, bendingStiffness (plate), 0.3, massPerArea (plate) } }, {}, circularEdge (outer) },
             count))
        expected.push_back (mode.angularFrequency);

    const auto ratio = worstRatio (model, expected);
    INFO ("edge " << static_cast<int> (outer) << ", hole " << hole << ", " << count << " modes");
    CAPTURE (ratio, model.frequencyErrors.maxCoeff());
    CHECK (ratio < 5);
    CHECK (model.frequencyErrors.maxCoeff() < 5e-3); // And says something.
}
} // namespace

TEST_CASE ("Frequencies of discs and rings are off by less than five times their estimated errors",
           "[structure][outlined][errors]")
{
    for (const auto outer : { EdgeCondition::free, EdgeCondition::simplySupported, EdgeCondition::clamped })
    {
        checkRound (outer, 0.1, 0, 40);
        checkRound (outer, 0.1, 0.03, 40);

        // Others than those from which what a penalty leaves was measured; the free one of 80 gave what rounding
        // leaves.
        checkRound (outer, 0.073, 0, 15);
        checkRound (outer, 0.073, 0.041, 15);
        checkRound (outer, 0.1, 0, 80);
    }
}

TEST_CASE ("Frequencies of a turned square are off by less than five times their estimated errors",
           "[structure][outlined][errors]")
{
    constexpr double side = 0.1;

    for (const auto angle : { 0.2, 0.5 })
    {
        const auto plate = bareOutlined ({ rectanglePath ({ 0, 0 }, { side, side }, angle, { 0, 0, 0, 0 }, 0) },
                                         std::vector<PlateEdge> (4, edgeOf (EdgeCondition::simplySupported)));
        const auto model = solveOutlinedPlate ("square", plate, modesWithErrors);
        std::vector<double> expected;

        // Navier's: sin (m pi x / a) sin (n pi y / a).
        for (int m = 1; m < 20; ++m)
            for (int n = 1; n < 20; ++n)
                expected.push_back (std::pow (std::numbers::pi / side, 2) * (m * m + n * n)
                                    * std::sqrt (bendingStiffness (plate) / massPerArea (plate)));

        std::sort (expected.begin(), expected.end());
        INFO ("turned by " << angle);
        CHECK (worstRatio (model, expected) < 5);
    }
}
