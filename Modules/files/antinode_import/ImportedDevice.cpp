#include "ImportedDevice.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>
#include <antinode_identification/IdentifiedModel.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace antinode
{
namespace
{
/** Modes that move the surface along its normal, ascending in frequency. */
std::vector<std::size_t> usefulModes (const ElementResults& results, const TouchedSurface& surface, int axis)
{
    constexpr double least = 1e-3; // of the surface's motion: below, modes move it within its plane
    std::vector<std::size_t> order;

    for (std::size_t k = 0; k < results.modes.size(); ++k)
    {
        const Eigen::MatrixX3cd moved = results.modes[k].shape (surface.nodes, Eigen::all);

        if (results.modes[k].frequency > 0 && moved.col (axis).squaredNorm() > least * moved.squaredNorm())
            order.push_back (k);
    }

    std::stable_sort (order.begin(), order.end(),
                      [&results] (auto a, auto b) { return results.modes[a].frequency < results.modes[b].frequency; });

    if (order.empty())
        throw InputError ("finite-element results", "contain no mode that moves the surface along its normal; choose "
                                                    "another normal axis");

    return order;
}

/** What a ceramic's forces at 1 V do to a mode; N kg^-1/2 / V. */
std::complex<double> participation (const Eigen::MatrixX3d& blockedForces, const ElementMode& mode, double voltage)
{
    return -(blockedForces.cast<std::complex<double>>().cwiseProduct (mode.shape)).sum() / voltage;
}

/** As if they had been measured at the surface's points. */
IdentifiedModes modesOnSurface (const ElementResults& results, const TouchedSurface& surface,
                                const std::vector<std::size_t>& order, const ImportSettings& settings)
{
    const auto modes = static_cast<Eigen::Index> (order.size());
    const auto ceramics = static_cast<Eigen::Index> (results.blockedForces.size());
    IdentifiedModes made;
    made.points = surface.points;
    made.angularFrequencies.resize (modes);
    made.dampingRatios.resize (modes);
    made.deviations.angularFrequencies = Eigen::VectorXd::Zero (modes);
    Eigen::MatrixXcd shapes (surface.points.rows(), modes), alpha (modes, ceramics);

    for (Eigen::Index k = 0; k < modes; ++k)
    {
        const auto& mode = results.modes[order[static_cast<std::size_t> (k)]];
        made.angularFrequencies[k] = 2 * std::numbers::pi * mode.frequency;
        made.dampingRatios[k] = mode.dampingRatio > 0 ? mode.dampingRatio : settings.dampingRatio;
        shapes.col (k) = mode.shape (surface.nodes, settings.side.axis);

        for (Eigen::Index i = 0; i < ceramics; ++i)
            alpha (k, i) =
                participation (results.blockedForces[static_cast<std::size_t> (i)], mode, settings.caseVoltage);
    }

    made.shapes = shapes.real();
    made.participation = alpha.real();

    if (results.hasComplexModes())
    {
        made.complexShapes = shapes;
        made.complexParticipation = alpha;
    }

    for (Eigen::Index i = 0; i < ceramics; ++i)
        made.references.push_back ({ "C" + std::to_string (i + 1), {} });

    return made;
}

std::vector<Ceramic> makeCeramics (const TouchedSurface& surface, double voltageLimit)
{
    std::vector<Ceramic> ceramics;

    for (const auto& area : surface.ceramics)
    {
        Ceramic ceramic;
        ceramic.name = "C" + std::to_string (ceramics.size() + 1);
        ceramic.xMinimum = area.xMinimum;
        ceramic.xMaximum = area.xMaximum;
        ceramic.yMinimum = area.yMinimum;
        ceramic.yMaximum = area.yMaximum;
        ceramic.voltageLimit = voltageLimit;
        ceramics.push_back (ceramic);
    }

    return ceramics;
}

/** RMS over the surface of what sum phi alpha / omega^2 leaves of a static displacement at the case's voltage. */
double staticError (const ModalModel& model, Eigen::Index ceramic, const Eigen::VectorXd& measured, double voltage)
{
    const Eigen::VectorXd amplitudes =
        voltage * model.participation.col (ceramic).cwiseQuotient (model.angularFrequencies.cwiseAbs2());
    return (model.shapes * amplitudes - measured).norm() / measured.norm();
}

/** @param usualDamping  of modes for which the program says none */
void addWarnings (ImportedDevice& device, double usualDamping)
{
    constexpr double likely = 0.35, goodSum = 0.05, longest = 5; // m
    const auto& surface = device.model.surface;
    const auto length = std::max (surface.xMaximum - surface.xMinimum, surface.yMaximum - surface.yMinimum);

    if (length > longest)
        device.warnings.push_back ("The surface is " + inWords (length) + " m long: the files may be in mm.");

    if (device.totalMass && std::abs (device.mass / *device.totalMass - 1) > likely)
        device.warnings.push_back ("The shapes' norms give the surface " + inWords (1000 * device.mass)
                                   + " g, the program's table says " + inWords (1000 * *device.totalMass)
                                   + " g: shapes may not be mass-normalised.");

    for (std::size_t i = 0; i < device.staticErrors.size(); ++i)
        if (device.staticErrors[i] > goodSum)
            device.warnings.push_back ("The modes leave " + inWords (100 * device.staticErrors[i])
                                       + " % of the static displacement by ceramic " + std::to_string (i + 1)
                                       + ": more modes are needed, or the case is not that of the reaction forces.");

    if (device.withoutDamping > 0)
        device.warnings.push_back (
            std::to_string (device.withoutDamping) + " of " + std::to_string (device.model.modes())
            + " modes have no damping ratio in the files: they get " + inWords (usualDamping) + ".");
}
} // namespace

ImportedDevice importDevice (const ElementResults& results, const ImportSettings& settings)
{
    for (std::size_t i = 0; i < results.blockedForces.size(); ++i)
        if (! (results.blockedForces[i].cwiseAbs().maxCoeff() > 0))
            throw InputError ("ceramic " + std::to_string (i + 1),
                              "has no reaction forces in its case; allowed: those of "
                              "all nodes held while it strains");

    const auto surface = findTouchedSurface (results, settings.side);
    const auto order = usefulModes (results, surface, settings.side.axis);
    ImportedDevice device;
    MappedSurface mapped;
    mapped.name = settings.name;
    mapped.boundary = settings.boundary;
    mapped.ceramics = makeCeramics (surface, settings.voltageLimit);
    mapped.fullScaleVoltage = settings.fullScaleVoltage;
    device.model = toModalModel (modesOnSurface (results, surface, order, settings), mapped);
    device.model.frequencyErrors.resize (0); // Nobody knows them.
    device.model.origin = { ModeSource::drawn };
    device.meshNodes = results.nodes();
    device.nodesOfSurface = surface.meshNodes;
    device.leftOut = static_cast<int> (results.modes.size() - order.size());
    device.withoutDamping = static_cast<int> (
        std::count_if (order.begin(), order.end(), [&] (auto k) { return ! (results.modes[k].dampingRatio > 0); }));
    device.mass = device.model.surface.masses.sum();

    if (results.totalMass > 0)
        device.totalMass = results.totalMass;

    if (! device.model.hasComplexModes() && device.model.surface.kind == SurfaceKind::plate)
        for (std::size_t i = 0; i < results.staticDisplacements.size(); ++i)
            device.staticErrors.push_back (
                staticError (device.model, static_cast<Eigen::Index> (i),
                             results.staticDisplacements[i](surface.nodes, settings.side.axis), settings.caseVoltage));

    addWarnings (device, settings.dampingRatio);
    return device;
}
} // namespace antinode
