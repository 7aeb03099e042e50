#include "ChainModes.h"
#include "DescribedCeramic.h"
#include "DescribedModel.h"
#include "DescriptionChecks.h"
#include "DeviceDescription.h"
#include "ElementChain.h"
#include "MeasuredModel.h"
#include "OutlinedModel.h"
#include "SolvedPlate.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>

#include <algorithm>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

namespace antinode
{
namespace
{
constexpr int elementDegree = 8; ///< What subdivided() divides for.
constexpr int coarseDegree = 5;  ///< Enough for some percent.
constexpr double coarseErrors = 0.02;
constexpr int defaultBeamModes = 40;

/** The wanted modes of a description: a number, or all up to a frequency. */
struct WantedModes
{
    std::optional<int> count;
    double limit = std::numeric_limits<double>::infinity(); ///< rad/s
    double expected = 0; ///< rad/s: about the frequency up to which modes must be accurate.
};

WantedModes modesUpTo (const ElementChain& chain, double frequency)
{
    const auto limit = 2 * std::numbers::pi * frequency;

    if (! (limit > 0 && halfWavesAt (chain, limit) <= maximumBeamModes))
        throw InputError ("device", "maximum frequency is " + std::to_string (frequency)
                                        + " Hz; allowed: above 0 Hz, with up to " + std::to_string (maximumBeamModes)
                                        + " modes below it");

    return { {}, limit, std::max (limit, angularFrequencyOfHalfWaves (chain, 2)) };
}

WantedModes wantedModes (const ElementChain& chain, const StructureCommon& common, std::optional<int> argument)
{
    const auto given = argument ? argument : common.modeCount;

    if (! given && common.maximumFrequency)
        return modesUpTo (chain, *common.maximumFrequency);

    WantedModes wanted;
    wanted.count = given.value_or (defaultBeamModes);

    if (*wanted.count < 1 || *wanted.count > maximumBeamModes)
        throw InputError ("device", "number of modes is " + std::to_string (*wanted.count) + "; allowed: 1 to "
                                        + std::to_string (maximumBeamModes));

    wanted.expected = angularFrequencyOfHalfWaves (chain, *wanted.count + 2);
    return wanted;
}

/** A chain divided finely enough for the wanted ones of its modes, and these. */
struct Solution
{
    ElementChain chain;
    ChainModes modes;
    double angularFrequency = 0; ///< rad/s: what the chain was divided for.
};

void keepFirst (ChainModes& modes, Eigen::Index count)
{
    modes.angularFrequencies.conservativeResize (count);
    modes.coefficients.conservativeResize (Eigen::NoChange, count);
}

Solution solveWanted (const ElementChain& whole, const WantedModes& wanted, int degree)
{
    // The frequency of the last mode is known only roughly if sections change often: search higher until there are
    // enough.
    for (auto angularFrequency = wanted.expected;; angularFrequency *= 1.25)
    {
        Solution solution { subdivided (whole, angularFrequency), {}, angularFrequency };
        solution.modes = solveChain (solution.chain, degree, angularFrequency);
        const auto highest = std::min (angularFrequency, wanted.limit);
        const auto found = (solution.modes.angularFrequencies.array() <= highest).count();

        if (! wanted.count && found == 0)
            throw InputError ("device", "has no mode up to its maximum frequency; choose a higher frequency");

        if (! wanted.count || found >= *wanted.count)
        {
            keepFirst (solution.modes, wanted.count.value_or (static_cast<int> (found)));
            return solution;
        }
    }
}

/** The change of each frequency against a solution of a lower degree, which is many times the error left. */
Eigen::VectorXd estimatedErrors (const Solution& solution)
{
    constexpr double rounding = 1e-12; // What no change of degree shows.
    const auto& fine = solution.modes.angularFrequencies;
    const auto coarse = solveChain (solution.chain, elementDegree - 1, solution.angularFrequency).angularFrequencies;
    return (coarse.head (fine.size()) - fine).cwiseQuotient (fine).cwiseAbs().cwiseMax (rounding);
}

Eigen::VectorXd momentsPerVolt (const StructureCommon& common, double width)
{
    Eigen::VectorXd moments (static_cast<Eigen::Index> (common.ceramics.size()));
    std::transform (common.ceramics.begin(), common.ceramics.end(), moments.begin(),
                    [&] (const CeramicDescription& ceramic) { return momentPerVolt (common, width, ceramic); });
    return moments;
}

/** At a free or guided end of a beam the surface moves; the top of a staple is held by its legs. */
HeldEdges heldEdges (const BeamDescription& beam)
{
    return { isHeld (beam.left), isHeld (beam.right), true, true };
}

HeldEdges heldEdges (const StapleDescription&)
{
    return {};
}

template <typename Body>
ModalModel solveLine (const std::string& name, const Body& body, std::optional<int> modeCount,
                      int degree = elementDegree)
{
    requireSolvable (body);
    const auto whole = makeChain (body);
    const auto solution = solveWanted (whole, wantedModes (whole, body.common, modeCount), degree);
    auto model = makeModel (solution.chain, solution.modes, degree, solution.angularFrequency, body.width,
                            momentsPerVolt (body.common, body.width));
    model.frequencyErrors =
        degree == elementDegree ? estimatedErrors (solution) : Eigen::VectorXd::Constant (model.modes(), coarseErrors);
    model.surface.held = heldEdges (body);
    describe (model, name, body.common);
    validate (model);
    return model;
}

std::string complexModesInWords (const ModalModel& model)
{
    const auto collinearity = phaseCollinearities (model);
    return "Its modes are complex (modal phase collinearity " + inWords (collinearity.minCoeff()) + " to "
           + inWords (collinearity.maxCoeff())
           + "): pictures show the real parts of shapes, tables those of participations.";
}

/** Solves what a device's body is. */
struct BodySolver
{
    ModalModel operator() (const BeamDescription& beam) const { return solveLine (name, beam, modeCount); }
    ModalModel operator() (const StapleDescription& staple) const { return solveLine (name, staple, modeCount); }

    ModalModel operator() (const PlateDescription& plate) const
    {
        const auto isAligned =
            std::all_of (plate.common.ceramics.begin(), plate.common.ceramics.end(), fillsItsRectangle);
        return isAligned ? solvePlate (name, plate, modeCount) : (*this) (outlinedPlate (plate));
    }

    ModalModel operator() (const OutlinedPlate& plate) const { return solveOutlinedPlate (name, plate, modeCount); }

    ModalModel operator() (const ModalModel& measured) const
    {
        validate (measured);
        const auto needsSlopes = measured.surface.kind == SurfaceKind::line && measured.slopes.size() == 0;
        auto model = needsSlopes ? withSplineSlopes (measured) : measured;

        if (model.hasComplexModes())
            model.warnings.push_back (complexModesInWords (model));

        return model;
    }

    ModalModel operator() (const MeasuredDevice& measured) const
    {
        return measuredModel (measured, solveStructure (*measured.drawing));
    }

    const std::string& name;
    std::optional<int> modeCount;
};
} // namespace

ModalModel solveCoarsely (const DeviceDescription& device, int modeCount)
{
    if (const auto* const plate = std::get_if<PlateDescription> (&device.body))
        return solveOutlinedCoarsely (device.name, outlinedPlate (*plate), modeCount);

    if (const auto* const plate = std::get_if<OutlinedPlate> (&device.body))
        return solveOutlinedCoarsely (device.name, *plate, modeCount);

    if (const auto* const beam = std::get_if<BeamDescription> (&device.body))
        return solveLine (device.name, *beam, modeCount, coarseDegree);

    if (const auto* const staple = std::get_if<StapleDescription> (&device.body))
        return solveLine (device.name, *staple, modeCount, coarseDegree);

    return solveStructure (device, modeCount);
}

ModalModel solveStructure (const DeviceDescription& device, std::optional<int> modeCount)
{
    return std::visit (BodySolver { device.name, modeCount }, device.body);
}
} // namespace antinode
