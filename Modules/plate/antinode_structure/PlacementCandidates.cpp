#include "PlacementCandidates.h"

#include "DescribedCeramic.h"
#include "DescribedModel.h"
#include "DescriptionChecks.h"
#include "ElementChain.h"
#include "OutlinedGrid.h"
#include "OutlinedModel.h"
#include "OutlinedProblem.h"
#include "PlaneCutter.h"
#include "PlateWaves.h"
#include "SolvedPlate.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>
#include <antinode_model/ShapeInterpolation.h>
#include <antinode_numerics/DenseKernels.h>
#include <antinode_outline/OutlineChecks.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
[[noreturn]] void throwTooLarge()
{
    throw InputError ("placement: ceramic size", "is larger than the device; allowed: up to the size of the device");
}

/** Positions between two ends: a margin is kept from free ones, as far as there is room, and as an edge distance asks.
 */
std::vector<double> positionsBetween (double from, double to, EdgeCondition low, EdgeCondition high,
                                      const CandidateGrid& grid)
{
    const auto most = std::min (grid.freeEdgeMargin, grid.edgeDistance.value_or (grid.freeEdgeMargin));
    const auto free = (low == EdgeCondition::free ? 1 : 0) + (high == EdgeCondition::free ? 1 : 0);
    const auto margin = free > 0 ? std::min (most, std::max (0.0, to - from) / free) : 0.0;
    return candidatePositions (low == EdgeCondition::free ? from + margin : from,
                               high == EdgeCondition::free ? to - margin : to, grid.step);
}

/** The candidates of a plate, row by row. */
std::vector<CeramicDescription> onPlate (const PlateDescription& plate, const CeramicDescription& like,
                                         const CandidateGrid& grid)
{
    if (like.sizeX > plate.lengthX + edgeTolerance || like.sizeY > plate.lengthY + edgeTolerance)
        throwTooLarge();

    std::vector<CeramicDescription> ceramics;
    const auto xs = positionsBetween (0, plate.lengthX - like.sizeX, plate.left, plate.right, grid);

    for (const auto y : positionsBetween (0, plate.lengthY - like.sizeY, plate.bottom, plate.top, grid))
        for (const auto x : xs)
        {
            auto ceramic = like;
            ceramic.x = x;
            ceramic.y = y;
            const auto toEdge = std::min ({ x, y, plate.lengthX - x - like.sizeX, plate.lengthY - y - like.sizeY });

            if (! grid.edgeDistance || toEdge <= *grid.edgeDistance + edgeTolerance)
                ceramics.push_back (ceramic);
        }

    return ceramics;
}

struct CandidateFinder
{
    const DeviceDescription& device;
    const CeramicDescription& like;
    const CandidateGrid& grid;

    PlacementCandidates operator() (const PlateDescription& plate) const
    {
        if (! fillsItsRectangle (like))
            return (*this) (outlinedPlate (plate));

        PlacementCandidates candidates;
        candidates.ceramics = onPlate (plate, like, grid);
        requireFewCandidates (candidates.ceramics.size());
        const auto solved = asSolved (plate, grid.modes);
        const auto solution = solvePlateModes (solved, grid.modes);
        candidates.angularFrequencies = solution.angularFrequencies;
        candidates.dampingRatios = dampingOfModes (plate.common.dampingRatios, grid.modes);
        const auto unit = solution.layout.unit;
        candidates.participation.resize (grid.modes, static_cast<Eigen::Index> (candidates.ceramics.size()));

        for (std::size_t i = 0; i < candidates.ceramics.size(); ++i)
        {
            checkWatch();
            const auto& c = candidates.ceramics[i];
            candidates.participation.col (static_cast<Eigen::Index> (i)) =
                solution.coefficients.transpose() * ceramicLoad (solution.problem, solved.common, c, unit);
        }

        correctCandidates (candidates, solved.common, like);
        return candidates;
    }

    PlacementCandidates operator() (const BeamDescription& beam) const
    {
        return onLine (beam, beam.length, beam.left, beam.right);
    }

    PlacementCandidates operator() (const StapleDescription& staple) const
    {
        return onLine (staple, staple.topLength, EdgeCondition::clamped, EdgeCondition::clamped); // both go on as legs
    }

    PlacementCandidates operator() (const OutlinedPlate& plate) const { return outlinedCandidates (plate, like, grid); }

    PlacementCandidates operator() (const ModalModel&) const { throwGiven ("is of kind modal"); }
    PlacementCandidates operator() (const MeasuredDevice&) const { throwGiven ("has measured modes"); }

private:
    [[noreturn]] void throwGiven (const std::string& what) const
    {
        throw InputError ("device '" + device.name + "'", what + "; allowed: " + computedKinds);
    }

    template <typename Body>
    PlacementCandidates onLine (const Body& body, double length, EdgeCondition left, EdgeCondition right) const
    {
        if (like.sizeX > length + edgeTolerance || like.sizeY > body.width + edgeTolerance)
            throwTooLarge();

        PlacementCandidates candidates;
        const auto model = solveStructure (device, grid.modes);
        candidates.angularFrequencies = model.angularFrequencies;
        candidates.dampingRatios = model.dampingRatios;
        const auto moment = momentPerVolt (body.common, body.width, like);
        const auto bond = bondLength (body.common, body.width, like);
        const auto lefts = positionsBetween (-length / 2, length / 2 - like.sizeX, left, right, grid);
        candidates.participation.resize (grid.modes, static_cast<Eigen::Index> (lefts.size()));

        for (std::size_t i = 0; i < lefts.size(); ++i)
        {
            checkWatch();
            auto ceramic = like;
            ceramic.x = lefts[i];
            ceramic.y = -like.sizeY / 2;
            candidates.ceramics.push_back (ceramic);
            const auto slopeAt = [&] (double x)
            { return slopesOnLine (model.surface.points.col (0), model.shapes, model.slopes, x); };
            candidates.participation.col (static_cast<Eigen::Index> (i)) =
                moment * (slopeAt (ceramic.x + ceramic.sizeX - bond) - slopeAt (ceramic.x + bond)).transpose();
        }

        return candidates;
    }
};
} // namespace

bool PlacementCandidates::overlap (Eigen::Index a, Eigen::Index b) const
{
    const auto& first = ceramics[static_cast<std::size_t> (a)];
    const auto& second = ceramics[static_cast<std::size_t> (b)];
    const Eigen::Vector2d offset = second.centre() - first.centre();

    if (first.shape != CeramicShape::rectangle)
        return offset.norm() < first.sizeX - edgeTolerance;

    // All of them are turned alike.
    const auto cosine = std::cos (first.angle), sine = std::sin (first.angle);
    return std::abs (cosine * offset.x() + sine * offset.y()) < first.sizeX - edgeTolerance
           && std::abs (cosine * offset.y() - sine * offset.x()) < first.sizeY - edgeTolerance;
}

DeviceDescription withCeramics (DeviceDescription device, const std::vector<CeramicDescription>& ceramics)
{
    const auto set = [&] (auto& body)
    {
        if constexpr (requires { body.common; })
            body.common.ceramics = ceramics;
    };
    std::visit (set, device.body);
    return device;
}

PlacementCandidates placementCandidates (const DeviceDescription& device, const CeramicDescription& like,
                                         const CandidateGrid& grid)
{
    const auto bare = withCeramics (device, {});
    return std::visit (CandidateFinder { bare, like, grid }, bare.body);
}

namespace
{
constexpr std::size_t maximumCandidates = 5000;

/** Whether a ceramic lies within a plate, with a distance from its edges. */
bool liesWithin (const Outline& plate, CeramicDescription ceramic, double distance)
{
    ceramic.x -= distance;
    ceramic.y -= distance;
    ceramic.sizeX += 2 * distance;
    ceramic.sizeY += 2 * distance;
    ceramic.innerDiameter = std::max (0.0, ceramic.innerDiameter - 2 * distance);

    if (const auto centre = ceramic.centre(); ! plate.contains (centre.x(), centre.y()))
        return false;

    // The hole of a ring is no place for a hole of the plate.
    if (ceramic.shape == CeramicShape::ring)
        ceramic.shape = CeramicShape::disc;

    try
    {
        checkParts (plate, { { "ceramic", ceramicOutline (ceramic) } });
        return true;
    }
    catch (const InputError&)
    {
        return false;
    }
}

/** Whether a ceramic lies on something that is fastened to the plate: a foot, a screw, a mass. */
bool coversPoint (const CeramicDescription& ceramic, const std::vector<PlatePoint>& points)
{
    const auto outline = ceramicOutline (ceramic);
    return std::any_of (points.begin(), points.end(),
                        [&] (const PlatePoint& point) { return outline.contains (point.x, point.y); });
}

/** How far the nearest edge of the plate is from what a ceramic covers. */
double distanceToEdge (const Outline& plate, const CeramicDescription& ceramic)
{
    auto nearest = distanceToBoundary (plate, ceramic.centre().x(), ceramic.centre().y());

    if (ceramic.shape != CeramicShape::rectangle)
        return nearest - ceramic.sizeX / 2;

    const auto covered = ceramicOutline (ceramic);

    for (const auto& piece : covered.paths.front())
        for (const auto share : { 0.0, 0.25, 0.5, 0.75 })
        {
            const auto place = piece.at (share);
            nearest = std::min (nearest, distanceToBoundary (plate, place.x(), place.y()));
        }

    return nearest;
}

std::vector<CeramicDescription> positionsOn (const OutlinedPlate& plate, const CeramicDescription& like,
                                             const CandidateGrid& grid, double margin)
{
    const auto extent = extentOf (plate.outline);
    const auto covered = ceramicExtent (like);
    const Eigen::Vector2d before = like.centre() - covered.least, after = covered.largest - like.centre();
    std::vector<CeramicDescription> ceramics;
    const auto xs = candidatePositions (extent.least.x() + before.x(), extent.largest.x() - after.x(), grid.step);

    for (const auto y : candidatePositions (extent.least.y() + before.y(), extent.largest.y() - after.y(), grid.step))
        for (const auto x : xs)
        {
            checkWatch();
            auto ceramic = like;
            ceramic.x = x - like.sizeX / 2;
            ceramic.y = y - like.sizeY / 2;

            if (! liesWithin (plate.outline, ceramic, margin) || coversPoint (ceramic, plate.points)
                || (grid.edgeDistance && distanceToEdge (plate.outline, ceramic) > *grid.edgeDistance + edgeTolerance))
                continue;

            ceramics.push_back (ceramic);
            requireFewCandidates (ceramics.size());
        }

    return ceramics;
}

std::vector<CeramicDescription> positionsOn (const OutlinedPlate& plate, const CeramicDescription& like,
                                             const CandidateGrid& grid)
{
    const auto isFree = [] (const PlateEdge& edge) { return edge.condition == EdgeCondition::free; };
    const auto most = std::min (grid.freeEdgeMargin, grid.edgeDistance.value_or (grid.freeEdgeMargin));
    const auto isAnyFree = std::any_of (plate.edges.begin(), plate.edges.end(), isFree);

    for (const auto margin : { isAnyFree ? most : 0.0, 0.0 })
        if (auto ceramics = positionsOn (plate, like, grid, margin); ! ceramics.empty())
            return ceramics;

    throw InputError ("placement: ceramic size", "leaves no position on the device; allowed: ceramics that lie within "
                                                 "its outline, at positions that the step gives");
}

/** The participation of a patch, per mode, in units of the problem but for its moment.
    @param patch  its outline in units of the problem, the rest in SI */
Eigen::VectorXd participationOf (const BendingPatch& patch, const OutlinedSolution& solution)
{
    const auto degree = patch.bonded ? 15 : 7; // Near its edges what is bonded varies fast.
    const auto& [space, eigenvalues, coefficients, ofPatches, rigid] = solution.modes;
    const auto extent = extentOf (patch.outline);
    const PlaneCutter cutter (patch.outline, {});
    const auto points =
        cutter.points ({ extent.least.x(), extent.largest.x(), extent.least.y(), extent.largest.y() }, degree, {});
    const auto number = static_cast<Eigen::Index> (points.places.size());
    Eigen::MatrixX2d places (number, 2);
    Eigen::MatrixX3d moments (number, 3);

    for (Eigen::Index i = 0; i < number; ++i)
    {
        const auto& place = points.places[static_cast<std::size_t> (i)];
        places.row (i) = place.transpose();
        moments.row (i) =
            points.weights[static_cast<std::size_t> (i)] * patch.momentAt (place * solution.scaled.length).transpose();
    }

    Eigen::VectorXd result = space.evaluate (places, coefficients, 2, 0).transpose() * moments.col (0)
                             + space.evaluate (places, coefficients, 0, 2).transpose() * moments.col (1);

    if (! moments.col (2).isZero (0))
        result += 2 * space.evaluate (places, coefficients, 1, 1).transpose() * moments.col (2);

    return result;
}
} // namespace

std::vector<double> candidatePositions (double from, double to, double step)
{
    if (! (step > 0))
        throw InputError ("placement: step", "is not a positive number; allowed: above 0 mm");

    const auto length = std::max (to - from, 0.0);
    const auto wanted = std::ceil (length / step - 1e-9);

    if (! (wanted < static_cast<double> (maximumCandidates)))
        throw InputError ("placement: step",
                          "gives more than " + std::to_string (maximumCandidates) + " positions; choose a larger step");

    std::vector<double> result;

    const auto intervals = static_cast<int> (wanted);

    for (int i = 0; i <= intervals; ++i)
        result.push_back (intervals > 0 ? from + length * i / intervals : (from + to) / 2);

    return result;
}

void requireFewCandidates (std::size_t count)
{
    if (count > maximumCandidates)
        throw InputError ("placement: step",
                          "gives more than " + std::to_string (maximumCandidates) + " positions; choose a larger step");
}

PlacementCandidates outlinedCandidates (const OutlinedPlate& plate, const CeramicDescription& like,
                                        const CandidateGrid& grid)
{
    requireSolvable (plate);
    PlacementCandidates candidates;
    candidates.ceramics = positionsOn (plate, like, grid);
    const auto solved = asSolved (plate, grid.modes);
    const auto solution = solveOutlinedModes (solved, grid.modes);
    const OutlinedGrid points (solution.scaled.problem, solution.waveNumber);
    candidates.angularFrequencies = solution.angularFrequencies;
    candidates.dampingRatios = dampingOfModes (plate.common.dampingRatios, grid.modes)
                               + dampingOfSupports (solved, solution, points, points.shapes (solution.modes));
    candidates.participation =
        Eigen::MatrixXd::Zero (grid.modes, static_cast<Eigen::Index> (candidates.ceramics.size()));

    for (std::size_t i = 0; i < candidates.ceramics.size(); ++i)
    {
        checkWatch();

        for (auto& patch : ceramicPatches (solved.common, candidates.ceramics[i]))
        {
            patch.outline = scaled (patch.outline, 1 / solution.scaled.length);
            candidates.participation.col (static_cast<Eigen::Index> (i)) +=
                solution.scaled.shapeUnit() * participationOf (patch, solution);
        }
    }

    correctCandidates (candidates, solved.common, like);
    return candidates;
}

void correctCandidates (PlacementCandidates& candidates, StructureCommon common, const CeramicDescription& like)
{
    // They are alike: one stands for all.
    common.ceramics = { like };
    ModalModel one;
    one.angularFrequencies = candidates.angularFrequencies;
    one.dampingRatios = candidates.dampingRatios;
    one.participation = Eigen::MatrixXd::Ones (one.modes(), 1);
    correctFrequencies (one, common);
    candidates.angularFrequencies = one.angularFrequencies;
    candidates.dampingRatios = one.dampingRatios;
    candidates.participation = one.participation.col (0).asDiagonal() * candidates.participation;
}
} // namespace antinode
