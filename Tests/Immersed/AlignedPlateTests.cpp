#include "BendingExamples.h"
#include "Structure/PlateExamples.h"

#include <antinode_structure/PlateSection.h>

using namespace antinode;
using namespace antinode::examples;

namespace
{
EdgeSupport supportOf (EdgeCondition condition)
{
    return condition == EdgeCondition::clamped ? clampedEdge
           : condition == EdgeCondition::free  ? freeEdge
                                               : supportedEdge;
}
} // namespace

TEST_CASE ("Bare rectangles have the modes of the aligned solver to 1e-6", "[immersed][plate]")
{
    const auto* const edges = GENERATE ("FFFF", "SSSS", "CCCC", "SCSC");
    CAPTURE (edges);
    const auto plate = barePlate (edges, 0.2, 0.12);
    const auto aligned = solved (plate, 300); // Its cells follow the number of modes.
    const auto section = bareSection (plate.common);
    BendingProblem problem;
    problem.section.stiffness << section.d11, section.d12, 0, section.d12, section.d22, 0, 0, 0, section.d66;
    problem.section.massPerArea = section.massPerArea;
    problem.outline.paths = { rectanglePath ({ 0.1, 0.06 }, { 0.2, 0.12 }, 0, { 0, 0, 0, 0 }, 0) };
    problem.edges = { supportOf (plate.bottom), supportOf (plate.right), supportOf (plate.top),
                      supportOf (plate.left) };
    const auto immersed = frequencies (problem, 30, ModeAccuracy::high);
    CHECK ((immersed.array() / aligned.angularFrequencies.head (30).array() - 1).abs().maxCoeff() < 1e-6);
}
