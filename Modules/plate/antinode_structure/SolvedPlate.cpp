#include "SolvedPlate.h"

#include "DescribedModel.h"
#include "DescriptionChecks.h"
#include "DeviceDescription.h"
#include "ElementChain.h"
#include "PlateWaves.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/DenseKernels.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace antinode
{
int placesForPhase (double phase, int fewest)
{
    constexpr double tolerance = 3e-5; // of the amplitude
    double error = 1;
    auto count = 0;

    // The error of interpolation through n places is about (phase / 4)^n / n!.
    while (error > tolerance || count < fewest)
        error *= phase / 4 / ++count;

    return count;
}

namespace
{
GridAxis makeGridAxis (const Eigen::VectorXd& lines, double unit, double waveNumber)
{
    const Eigen::VectorXd edges = lines * unit;
    constexpr int fewestPlaces = 3;
    Eigen::VectorXi counts (edges.size() - 1);

    for (Eigen::Index s = 0; s < counts.size(); ++s)
        counts[s] = placesForPhase (waveNumber * (edges[s + 1] - edges[s]), fewestPlaces);

    return gridAxis (edges, counts);
}

/** The mass per area in each segment of a grid, x by y. */
Eigen::MatrixXd massPerArea (const PlateDescription& plate, const PlateLayout& layout)
{
    Eigen::MatrixXd masses = Eigen::MatrixXd::Constant (layout.linesX.size() - 1, layout.linesY.size() - 1,
                                                        bareSection (plate.common).massPerArea);

    for (std::size_t i = 0; i < layout.patches.size(); ++i)
    {
        const auto& patch = layout.patches[i];
        masses.block (patch.left, patch.bottom, patch.right - patch.left, patch.top - patch.bottom)
            .setConstant (ceramicSection (plate.common, plate.common.ceramics[i]).massPerArea);
    }

    return masses;
}

void weigh (Surface& surface, const Eigen::MatrixXd& masses)
{
    const auto& grid = surface.grid.value();
    const auto countX = grid.x.places.size();
    surface.masses = surface.areas;

    for (Eigen::Index t = 0; t < masses.cols(); ++t)
        for (auto j = grid.y.first[t]; j < grid.y.first[t + 1]; ++j)
            for (Eigen::Index s = 0; s < masses.rows(); ++s)
                surface.masses.segment (j * countX + grid.x.first[s], grid.x.first[s + 1] - grid.x.first[s]) *=
                    masses (s, t);
}

Eigen::MatrixXd computeParticipation (const PlateDescription& plate, const PlateSolution& solution)
{
    const auto& layout = solution.layout;
    Eigen::MatrixXd participation (solution.coefficients.cols(), static_cast<Eigen::Index> (layout.patches.size()));

    for (std::size_t i = 0; i < layout.patches.size(); ++i)
    {
        checkWatch();
        const auto load = ceramicLoad (solution.problem, plate.common, onLines (plate, layout, i), layout.unit);
        participation.col (static_cast<Eigen::Index> (i)) = solution.coefficients.transpose() * load;
    }

    return participation;
}

/** Where ceramics lie out of line the splines have to be coarse. */
void warnOfErrors (ModalModel& model)
{
    constexpr double tolerable = 5e-3;
    const auto largest = model.frequencyErrors.maxCoeff();

    if (largest <= tolerable)
        return;

    std::array<char, 200> text {};
    std::snprintf (
        text.data(), text.size(),
        "Frequencies are estimated to be up to %.1f %% too high. Fewer modes, or ceramics with aligned edges, "
        "allow a finer solution.",
        100 * largest);
    model.warnings.emplace_back (text.data());
}
} // namespace

Eigen::MatrixXd shapesOn (const PlateGrid& grid, const PlateProblem& problem, double unit,
                          const Eigen::MatrixXd& coefficients)
{
    const auto splinesX = problem.x().at (grid.x.places / unit, 0);
    const auto splinesY = problem.y().at (grid.y.places / unit, 0);
    Eigen::MatrixXd shapes = Eigen::MatrixXd::Zero (splinesX.rows() * splinesY.rows(), coefficients.cols());
    Eigen::MatrixXd half;

    for (Eigen::Index k = 0; k < shapes.cols(); ++k)
    {
        half.setZero (splinesX.rows(), splinesY.cols());
        addProduct (half, 1, splinesX, problem.coefficients (coefficients.col (k)));
        addTransposedRight (Eigen::Map<Eigen::MatrixXd> (shapes.col (k).data(), splinesX.rows(), splinesY.rows()), 1,
                            half, splinesY);
    }

    return shapes;
}

ModalModel makeModel (const PlateDescription& plate, const PlateSolution& solution)
{
    const auto& layout = solution.layout;
    const PlateGrid grid { makeGridAxis (layout.linesX, layout.unit, solution.waveNumber),
                           makeGridAxis (layout.linesY, layout.unit, solution.waveNumber) };
    ModalModel model;
    placeOnGrid (model.surface, grid);
    weigh (model.surface, massPerArea (plate, layout));
    model.surface.held = { isHeld (plate.left), isHeld (plate.right), isHeld (plate.bottom), isHeld (plate.top) };
    model.angularFrequencies = solution.angularFrequencies;
    model.frequencyErrors = solution.frequencyErrors;
    model.rigidBodyModes = solution.rigidBodyModes;
    model.unknowns = static_cast<int> (solution.problem.unknowns());
    model.warnings = thicknessWarnings (plate.common, solution.angularFrequencies);
    warnOfErrors (model);
    model.participation = computeParticipation (plate, solution);

    if (! model.participation.allFinite())
        throwNumbersTooFarApart();

    model.shapes = shapesOn (grid, solution.problem, layout.unit, solution.coefficients);
    settleEqualFrequencies (model);
    settleSigns (model);
    return model;
}

PlateDescription asSolved (const PlateDescription& plate, std::optional<int> modeCount)
{
    const auto count = modeCount.value_or (plate.common.modeCount.value_or (defaultPlateModes));
    auto solved = plate;
    solved.common = asSolved (plate.common, expectedWaveNumber (plate, std::clamp (count, 1, maximumPlateModes) / 2));
    return solved;
}

ModalModel solvePlate (const std::string& name, const PlateDescription& plate, std::optional<int> modeCount)
{
    requireSolvable (plate);
    const auto solved = asSolved (plate, modeCount);
    auto model = makeModel (solved, solvePlateModes (solved, modeCount));
    describe (model, name, plate.common);
    correctFrequencies (model, solved.common);
    validate (model);
    return model;
}
} // namespace antinode
