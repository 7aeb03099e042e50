#include "HeardParameters.h"

#include <antinode_numerics/DenseKernels.h>
#include <antinode_numerics/ParallelFor.h>

#include <algorithm>

namespace antinode
{
namespace
{
constexpr double leastInformation = 0.1; // of the prior's, of a parameter

/** The inner products of what each ceramic alone does to a mode, N_b x N_b, of all recordings, each of its length. */
Eigen::MatrixXd sharesOfCeramics (const LearningPrior& prior, Eigen::Index k)
{
    const auto ceramics = prior.model.actuators();
    Eigen::MatrixXd products = Eigen::MatrixXd::Zero (ceramics, ceramics);

    for (const auto& voltages : prior.voltages)
    {
        std::vector<Eigen::VectorXd> motions;
        Eigen::Index longest = 0;

        for (Eigen::Index i = 0; i < ceramics; ++i)
        {
            motions.push_back (modeMotionUntilRest (prior.model.angularFrequencies[k], prior.model.dampingRatios[k],
                                                    prior.model.participation (k, i) * voltages.of (i),
                                                    voltages.sampleRate(), voltages.samples(), false)
                                   .velocity);
            longest = std::max (longest, motions.back().size());
        }

        Eigen::MatrixXd together = Eigen::MatrixXd::Zero (longest, ceramics);

        for (Eigen::Index i = 0; i < ceramics; ++i)
            together.col (i).head (motions[static_cast<std::size_t> (i)].size()) =
                motions[static_cast<std::size_t> (i)];

        addGram (products, 1, together.transpose());
    }

    return products.selfadjointView<Eigen::Lower>();
}

/** How well all sensors together hear a mode: the sum of squares over the noise. */
double audibility (const LearningPrior& prior, Eigen::Index k)
{
    double sum = 0;

    for (std::size_t m = 0; m < prior.sensors.size(); ++m)
    {
        const auto ratio = prior.sensors[m].shapes[k] / prior.recordings.front().noise[static_cast<Eigen::Index> (m)];
        sum += ratio * ratio;
    }

    return sum;
}

std::vector<LearningParameter> participationParameters (const LearningPrior& prior, Eigen::Index k,
                                                        const Eigen::MatrixXd& products, double heard)
{
    const auto deviation = prior.deviations.participation[k];
    const auto eigen = symmetricEigen (products);
    std::vector<LearningParameter> parameters;

    for (auto v = eigen.values.size() - 1; v >= 0; --v)
        if (heard * deviation * deviation * eigen.values[v] > leastInformation)
            parameters.push_back ({ ParameterKind::participation, k, 0, eigen.vectors.col (v) });

    return parameters;
}

/** The sum of squares of a mode's motion, and of its change per relative change of its frequency and its damping. */
Eigen::Vector3d energies (const LearningPrior& prior, Eigen::Index k)
{
    Eigen::Vector3d sums = Eigen::Vector3d::Zero();

    for (const auto& voltages : prior.voltages)
    {
        const auto motion = modeMotionUntilRest (prior.model.angularFrequencies[k], prior.model.dampingRatios[k],
                                                 voltages.force (prior.model.participation.row (k)),
                                                 voltages.sampleRate(), voltages.samples(), true);
        sums += Eigen::Vector3d { motion.velocity.squaredNorm(), motion.byFrequency.squaredNorm(),
                                  motion.byDamping.squaredNorm() };
    }

    return sums;
}

/** The same where participations are off as the prior says. Voltages that keep a mode at rest by what it is known to be
    move it on the device: ceramics that cancel each other do not any more. */
Eigen::Vector3d expectedEnergies (const LearningPrior& prior, Eigen::Index k, const Eigen::MatrixXd& products)
{
    const auto known = energies (prior, k);
    const auto deviation = prior.deviations.participation[k];
    const auto whole = known[0] + deviation * deviation * products.trace();
    return known[0] > 0 ? Eigen::Vector3d (known * (whole / known[0])) : Eigen::Vector3d (whole, 0, 0);
}

std::vector<LearningParameter> parametersOf (const LearningPrior& prior, Eigen::Index k)
{
    const auto square = [] (double value) { return value * value; };
    const auto& deviations = prior.deviations;
    const auto heard = audibility (prior, k);
    const auto products = sharesOfCeramics (prior, k);
    const auto energy = expectedEnergies (prior, k, products);
    auto parameters = std::vector<LearningParameter> {};

    if (heard * energy[1] * square (deviations.frequencies[k]) > leastInformation)
        parameters.push_back ({ ParameterKind::frequency, k, 0, {} });

    if (heard * energy[2] * square (deviations.dampings[k]) > leastInformation)
        parameters.push_back ({ ParameterKind::damping, k, 0, {} });

    if (heard * energy[0] * square (deviations.participation[k]) > leastInformation)
    {
        const auto directions = participationParameters (prior, k, products, heard);
        parameters.insert (parameters.end(), directions.begin(), directions.end());
    }

    for (std::size_t m = 0; m < prior.sensors.size(); ++m)
    {
        const auto& sensor = prior.sensors[m];
        const auto ratio =
            sensor.deviation * sensor.shapes[k] / prior.recordings.front().noise[static_cast<Eigen::Index> (m)];

        if (square (ratio) * energy[0] > leastInformation)
            parameters.push_back ({ ParameterKind::sensor, k, static_cast<Eigen::Index> (m), {} });
    }

    return parameters;
}
} // namespace

LearningParameters heardParameters (const LearningPrior& prior)
{
    std::vector<std::vector<LearningParameter>> ofModes (static_cast<std::size_t> (prior.model.modes()));
    parallelFor (ofModes.size(),
                 [&] (std::size_t k) { ofModes[k] = parametersOf (prior, static_cast<Eigen::Index> (k)); });
    LearningParameters parameters;
    parameters.recordings = static_cast<Eigen::Index> (prior.recordings.size());

    for (const auto& some : ofModes)
        parameters.modal.insert (parameters.modal.end(), some.begin(), some.end());

    return parameters;
}
} // namespace antinode
