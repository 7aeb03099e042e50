#include "EquivalentLinear.h"

#include "CubedVoltages.h"
#include "DrivenModes.h"

#include <Eigen/LU>

#include <cmath>
#include <complex>

namespace antinode
{
namespace
{
// Regularisation, as a share of the power of an average mode and of the mode itself. Without it small differences of
// large motions would need large changes.
constexpr double hardlyDriven = 1e-3;

Eigen::Vector2d parts (const std::complex<double>& number)
{
    return { number.real(), number.imag() };
}
} // namespace

ModalModel equivalentLinear (const LearntModes& learnt, const Eigen::MatrixXd& voltages, double sampleRate, double time)
{
    auto model = learnt.model;

    if ((learnt.distortions.array() == 0).all())
        return model;

    const auto sample = static_cast<Eigen::Index> (std::llround (time * sampleRate));
    const auto motions = lastMotions (model, { voltages, cubedVoltages (voltages), sampleRate }, sample);
    const Eigen::VectorXcd added = motions.byCubes * learnt.distortions;
    const auto usual = motions.byVoltages.squaredNorm() / static_cast<double> (model.modes());

    for (Eigen::Index k = 0; k < model.modes(); ++k)
    {
        Eigen::Matrix2Xd states (2, model.actuators());
        states << motions.byVoltages.row (k).real(), motions.byVoltages.row (k).imag();
        Eigen::Matrix2d gram = states * states.transpose();
        gram.diagonal().array() += hardlyDriven * (usual + gram.trace());

        if (gram.trace() > 0)
            model.participation.row (k).array() *=
                1 + (states.transpose() * gram.inverse() * parts (added[k])).transpose().array();
    }

    return model;
}

Eigen::VectorXd distortionShares (const Eigen::VectorXd& distortions, const Eigen::MatrixXd& voltages)
{
    return distortions.cwiseProduct (voltages.rowwise().lpNorm<Eigen::Infinity>().cwiseAbs2());
}
} // namespace antinode
