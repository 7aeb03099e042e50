#include "OutlinedModel.h"

#include "DescribedModel.h"
#include "DescriptionChecks.h"
#include "DeviceDescription.h"
#include "OutlinedGrid.h"
#include "OutlinedProblem.h"
#include "PlateWaves.h"

#include "StaticShare.h"
#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_outline/PathBuilder.h>

#include <algorithm>
#include <utility>

namespace antinode
{
namespace
{
GridAxis inMetres (const GridAxis& axis, double unit)
{
    return { axis.places * unit, axis.weights * unit, axis.edges * unit, axis.first };
}

Surface surfaceOf (const OutlinedPlate& plate, const OutlinedProblem& scaled, const OutlinedGrid& grid)
{
    const auto unit = scaled.length;
    auto surface = outlinedSurface (plate);
    surface.points = grid.points() * unit;
    surface.areas = grid.areas() * unit * unit;
    surface.masses = grid.masses() * scaled.massPerArea * unit * unit;
    surface.grid = PlateGrid { inMetres (grid.x(), unit), inMetres (grid.y(), unit) };
    return surface;
}

/** Of each ceramic what its patches do together, N kg^-1/2 / V. */
Eigen::MatrixXd participationOf (const OutlinedPlate& plate, const OutlinedSolution& solution)
{
    const auto& scaled = solution.scaled;
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero (solution.modes.eigenvalues.size(),
                                                 static_cast<Eigen::Index> (plate.common.ceramics.size()));

    for (std::size_t p = 0; p < scaled.ceramicOfPatch.size(); ++p)
        sum.col (static_cast<Eigen::Index> (scaled.ceramicOfPatch[p])) +=
            scaled.shapeUnit() * solution.modes.participation.col (static_cast<Eigen::Index> (p));

    return sum;
}

void addDamping (ModalModel& model, const Eigen::VectorXd& more)
{
    model.dampingRatios += more;

    for (Eigen::Index k = 0; k < more.size(); ++k)
        if (! (model.dampingRatios[k] < 1))
            throw InputError ("device", "damps mode " + std::to_string (k + 1) + " with a ratio of "
                                            + inWords (model.dampingRatios[k])
                                            + "; allowed: below 1, so choose smaller losses or dashpots");
}

/** Where the curvature of the plate is unbounded, cells cannot be small enough for everything. */
void warnOfOutlinedErrors (ModalModel& model)
{
    constexpr double tolerable = 5e-3;
    const auto largest = model.frequencyErrors.maxCoeff();

    if (largest > tolerable)
        model.warnings.push_back ("Frequencies are estimated to be wrong by up to " + inWords (100 * largest)
                                  + " %. More modes than needed make the lower ones more accurate.");
}

/** The model of a solution on a grid.
    @param solved  the plate of one section that the solution is of */
ModalModel onGrid (const std::string& name, const OutlinedPlate& plate, const OutlinedPlate& solved,
                   const OutlinedSolution& solution, const OutlinedGrid& grid)
{
    const auto shapes = grid.shapes (solution.modes);
    ModalModel model;
    model.surface = surfaceOf (plate, solution.scaled, grid);
    model.angularFrequencies = solution.angularFrequencies;
    model.rigidBodyModes = solution.modes.rigidBodyModes;
    model.unknowns = static_cast<int> (solution.modes.space.unknowns());
    model.warnings = thicknessWarnings (solved.common, solution.angularFrequencies);
    model.participation = participationOf (plate, solution);
    model.shapes = shapes * solution.scaled.shapeUnit();
    describe (model, name, plate.common);
    addDamping (model, dampingOfSupports (solved, solution, grid, shapes));
    correctFrequencies (model, solved.common);
    settleEqualFrequencies (model);
    settleSigns (model);
    validate (model);
    return model;
}
} // namespace

OutlinedPlate asSolved (const OutlinedPlate& plate, std::optional<int> modeCount)
{
    const auto count = modeCount.value_or (plate.common.modeCount.value_or (defaultPlateModes));
    const auto scaled = outlinedProblem (plate);
    auto solved = plate;
    solved.common =
        asSolved (plate.common,
                  expectedWaveNumber (scaled.problem, std::clamp (count, 1, maximumPlateModes) / 2) / scaled.length);
    return solved;
}

ModalModel solveOutlinedPlate (const std::string& name, const OutlinedPlate& plate, std::optional<int> modeCount)
{
    requireSolvable (plate);
    const auto solved = asSolved (plate, modeCount);
    const auto solution = solveOutlinedModes (solved, modeCount);
    const OutlinedGrid grid (solution.scaled.problem, solution.waveNumber);
    auto model = onGrid (name, plate, solved, solution, grid);
    model.frequencyErrors = frequencyErrors (solution);
    warnOfOutlinedErrors (model);
    return model;
}

ModalModel solveOutlinedCoarsely (const std::string& name, const OutlinedPlate& plate, int modeCount)
{
    constexpr double error = 0.02; // What most are below: Tests/Structure/CoarseModelTests.cpp.
    requireSolvable (plate);
    const auto solved = asSolved (plate, modeCount);
    const auto solution = solveOutlinedModes (solved, modeCount, ModeAccuracy::coarse);
    const OutlinedGrid grid (solution.scaled.problem, solution.waveNumber, ModeAccuracy::coarse);
    auto model = onGrid (name, plate, solved, solution, grid);
    model.frequencyErrors = Eigen::VectorXd::Constant (model.modes(), error);
    return model;
}

ModalModel solveOutlinedWithStaticShare (const std::string& name, const OutlinedPlate& plate,
                                         std::optional<int> modeCount)
{
    requireSolvable (plate);
    const auto solved = asSolved (plate, modeCount);
    auto solution = solveOutlinedModes (solved, modeCount);
    const OutlinedGrid grid (solution.scaled.problem, solution.waveNumber);
    const auto warnings = thicknessWarnings (solved.common, solution.angularFrequencies);
    solution.modes = withStaticRest (solution.scaled.problem, std::move (solution.modes));
    solution.angularFrequencies = (solution.modes.eigenvalues * solution.scaled.eigenvalueUnit()).cwiseSqrt();
    auto model = onGrid (name, plate, solved, solution, grid);
    model.warnings = warnings; // of the modes: the shapes behind them are no waves
    return model;
}

ModalModel solveOutlinedOnPointsOfFewer (const std::string& name, const OutlinedPlate& plate, int fewer)
{
    requireSolvable (plate);
    const auto solved = asSolved (plate, fewer);
    const auto first = solveOutlinedModes (solved, fewer);
    const OutlinedGrid grid (first.scaled.problem, first.waveNumber);
    return onGrid (name, plate, solved, solveOutlinedModes (solved, {}), grid);
}

OutlinedPlate outlinedPlate (const PlateDescription& plate)
{
    const Eigen::Vector2d size (plate.lengthX, plate.lengthY);
    OutlinedPlate outlined;
    outlined.common = plate.common;
    outlined.outline.paths.push_back (rectanglePath (size / 2, size, 0, { 0, 0, 0, 0 }, 0));

    for (const auto condition : { plate.bottom, plate.right, plate.top, plate.left })
        outlined.edges.push_back ({ condition });

    return outlined;
}
} // namespace antinode
