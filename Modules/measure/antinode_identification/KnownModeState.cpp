#include "KnownModeState.h"

#include <antinode_numerics/DenseKernels.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
Eigen::MatrixXd strengthsOf (const KnownModes& modes)
{
    return modes.angularFrequencies.cwiseInverse().asDiagonal() * modes.participation;
}

KnownModeState knownModeState (const PreparedResponses& data, const LineMoments& moments, const KnownModes& modes,
                               double delay)
{
    const auto count = modes.modes(), points = data.points(), references = data.references();
    KnownModeState state;
    state.basis = makeBasis (modes.angularFrequencies, modes.dampingRatios, data);
    const auto products = modalProducts (state.basis, data, moments, delay);
    state.reduced = withoutPowers (state.basis, products);
    const auto strengths = strengthsOf (modes);
    Eigen::MatrixXd amplitudes (count, data.columns());
    state.weightedShapes.resize (count, data.columns());

    for (Eigen::Index i = 0; i < references; ++i)
    {
        const auto columns = Eigen::seqN (i * points, points);
        amplitudes (Eigen::all, columns) = strengths.col (i).asDiagonal() * modes.shapes.transpose();
        state.weightedShapes (Eigen::all, columns) =
            modes.shapes.transpose() * data.columnWeights.segment (i * points, points).asDiagonal();
        state.shapes.emplace_back (state.weightedShapes (Eigen::all, columns) * modes.shapes);
    }

    state.errors = state.reduced.data;
    const Eigen::MatrixXd toVelocity = state.reduced.gram (Eigen::all, functionsOf (ModalFunction::velocity, count));
    addProduct (state.errors, -1, toVelocity, amplitudes);
    const auto velocity = functionsOf (ModalFunction::velocity, count);
    const Eigen::VectorXd costs =
        state.reduced.energies
        - amplitudes.cwiseProduct (state.reduced.data (velocity, Eigen::all) + state.errors (velocity, Eigen::all))
              .colwise()
              .sum()
              .transpose();
    const auto energy = products.energies.dot (data.columnWeights),
               left = std::max (costs.dot (data.columnWeights), 1e-20 * energy);
    state.values = 2 * static_cast<double> (data.lines() * (data.columnWeights.array() > 0).count());
    state.variance = left / state.values;
    state.reconstructionError = 10 * std::log10 (left / energy);
    const auto ofPoints = [&] (const Eigen::VectorXd& columns) -> Eigen::VectorXd
    { return columns.cwiseProduct (data.columnWeights).reshaped (points, references).rowwise().sum(); };
    state.pointErrors =
        (ofPoints (costs).cwiseMax (0).array() / ofPoints (products.energies).array().max (1e-300)).sqrt().matrix();
    state.coefficients = Eigen::MatrixXd::Zero (state.basis.size(), data.columns());
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero (state.basis.modalColumns(), data.columns());
    all (velocity, Eigen::all) = amplitudes;
    state.coefficients << all, powerCoefficients (state.basis, products, all);
    return state;
}
} // namespace antinode
