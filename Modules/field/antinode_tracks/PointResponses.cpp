#include "PointResponses.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/ParallelFor.h>

#include <complex>
#include <numbers>

namespace antinode
{
namespace
{
using Complex = std::complex<double>;

/** The modal equations at the points and the loads together: what a line needs. */
struct LineSystem
{
    Eigen::MatrixXd shapes; ///< (points + loads) x N_m
    Eigen::MatrixXd inputs; ///< N_m x (actuators + loads)
    Eigen::Index points = 0, actuators = 0, loads = 0;
};

LineSystem lineSystem (const ModalModel& model, const Eigen::MatrixXd& pointShapes,
                       const std::vector<SurfaceLoad>& loads)
{
    LineSystem system;
    system.points = pointShapes.rows();
    system.actuators = model.actuators();
    system.loads = static_cast<Eigen::Index> (loads.size());
    system.shapes.resize (system.points + system.loads, model.modes());
    system.shapes.topRows (system.points) = pointShapes;

    for (std::size_t f = 0; f < loads.size(); ++f)
        system.shapes.row (system.points + static_cast<Eigen::Index> (f)) = loads[f].shapes;

    system.inputs.resize (model.modes(), system.actuators + system.loads);
    system.inputs.leftCols (system.actuators) = model.participation;
    system.inputs.rightCols (system.loads) = system.shapes.bottomRows (system.loads).transpose();
    return system;
}

/** Displacement at points for voltages. Loads are added one by one: each is a term of rank one (Sherman and Morrison).
 */
Eigen::MatrixXcd responseAt (const LineSystem& system, const Eigen::VectorXcd& compliances,
                             const Eigen::VectorXcd& impedances)
{
    const Eigen::MatrixXd real = system.shapes * compliances.real().asDiagonal() * system.inputs;
    const Eigen::MatrixXd imaginary = system.shapes * compliances.imag().asDiagonal() * system.inputs;
    Eigen::MatrixXcd response = real.cast<Complex>() + Complex (0, 1) * imaginary.cast<Complex>();

    for (Eigen::Index f = 0; f < system.loads; ++f)
    {
        const Eigen::VectorXcd byForce = response.col (system.actuators + f);
        const Eigen::RowVectorXcd atLoad = response.row (system.points + f);
        response -= byForce * (impedances[f] / (1.0 + impedances[f] * byForce[system.points + f])) * atLoad;
    }

    return response.topLeftCorner (system.points, system.actuators);
}
} // namespace

Eigen::MatrixXcd PointResponses::atLine (Eigen::Index line) const
{
    const Eigen::RowVectorXcd row = values.row (line);
    return Eigen::Map<const Eigen::MatrixXcd> (row.data(), points, actuators);
}

PointResponses pointResponses (const ModalModel& model, const Eigen::MatrixXd& pointShapes,
                               const std::vector<SurfaceLoad>& loads, double sampleRate, Eigen::Index length)
{
    requireRealModes (model, "waveforms at points");
    const auto system = lineSystem (model, pointShapes, loads);
    PointResponses responses { system.points, system.actuators, length, sampleRate, {} };
    responses.values.resize (length / 2 + 1, system.points * system.actuators);
    const auto squares = model.angularFrequencies.array().square();
    const auto dampings = 2 * model.dampingRatios.array() * model.angularFrequencies.array();

    const auto atLine = [&] (std::size_t line)
    {
        checkWatch();
        const auto omega =
            2 * std::numbers::pi * sampleRate * static_cast<double> (line) / static_cast<double> (length);
        Eigen::VectorXcd compliances (model.modes()), impedances (system.loads);

        for (Eigen::Index k = 0; k < model.modes(); ++k)
            compliances[k] = 1.0 / Complex (squares[k] - omega * omega, dampings[k] * omega);

        for (std::size_t f = 0; f < loads.size(); ++f)
            impedances[static_cast<Eigen::Index> (f)] =
                Complex (loads[f].stiffness - loads[f].mass * omega * omega, loads[f].damping * omega);

        const auto response = responseAt (system, compliances, impedances);
        responses.values.row (static_cast<Eigen::Index> (line)) =
            Eigen::Map<const Eigen::RowVectorXcd> (response.data(), response.size());
    };
    parallelFor (static_cast<std::size_t> (length / 2 + 1), atLine);
    return responses;
}
} // namespace antinode
