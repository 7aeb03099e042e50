#include "PlacementCandidates.h"

#include "BeamSection.h"
#include "CeramicShapes.h"
#include "DescribedModel.h"
#include "DescriptionChecks.h"
#include "OutlinedCandidates.h"
#include "OutlinedModel.h"
#include "SolvedPlate.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>
#include <antinode_model/ShapeInterpolation.h>

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
} // namespace antinode
