#include "ChooseSensors.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>
#include <antinode_numerics/DenseKernels.h>
#include <antinode_numerics/ParallelFor.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
Eigen::VectorXd informationOnMode (const ModalModel& model, const ModeSpread& deviations,
                                   const PlayedVoltages& voltages, Eigen::Index k)
{
    const auto ceramics = model.actuators();
    const auto motion =
        modeMotion (model.angularFrequencies[k], model.dampingRatios[k], voltages.force (model.participation.row (k)),
                    voltages.sampleRate(), voltages.samples(), true);
    Eigen::MatrixXd changes (voltages.samples(), 2 + ceramics);
    changes.col (0) = deviations.frequencies[k] * motion.byFrequency;
    changes.col (1) = deviations.dampings[k] * motion.byDamping;

    for (Eigen::Index i = 0; i < ceramics; ++i)
        changes.col (2 + i) = modeMotion (model.angularFrequencies[k], model.dampingRatios[k],
                                          deviations.participation[k] * model.participation (k, i) * voltages.of (i),
                                          voltages.sampleRate(), voltages.samples(), false)
                                  .velocity;

    Eigen::MatrixXd products = Eigen::MatrixXd::Zero (changes.cols(), changes.cols());
    addGram (products, 1, changes.transpose());
    return symmetricEigen (std::move (products)).values.cwiseMax (0);
}

/** The candidate with which the others tell most. */
Eigen::Index bestCandidate (const PlayedInformation& information, const Eigen::MatrixXd& audibilities,
                            const Eigen::VectorXd& others, const std::vector<Eigen::Index>& taken)
{
    std::vector<double> bits (static_cast<std::size_t> (audibilities.rows()), -1);
    parallelFor (bits.size(),
                 [&] (std::size_t c)
                 {
                     const auto candidate = static_cast<Eigen::Index> (c);

                     if (std::find (taken.begin(), taken.end(), candidate) == taken.end())
                         bits[c] = informationBits (information, others + audibilities.row (candidate).transpose());
                 });
    return std::max_element (bits.begin(), bits.end()) - bits.begin();
}

/** One round of exchanges. @return  whether there was one */
bool exchange (const PlayedInformation& information, const Eigen::MatrixXd& audibilities,
               std::vector<Eigen::Index>& chosen, Eigen::VectorXd& sum)
{
    constexpr double leastGain = 1e-9; // relative: rounding is no gain
    auto isChanged = false;

    for (auto& sensor : chosen)
    {
        const Eigen::VectorXd others = sum - audibilities.row (sensor).transpose();
        auto rest = chosen;
        std::erase (rest, sensor);
        const auto best = bestCandidate (information, audibilities, others, rest);
        const Eigen::VectorXd with = others + audibilities.row (best).transpose();

        if (best != sensor
            && informationBits (information, with) > (1 + leastGain) * informationBits (information, sum))
        {
            sensor = best;
            sum = with;
            isChanged = true;
        }
    }

    return isChanged;
}
} // namespace

PlayedInformation playedInformation (const ModalModel& model, const ModeSpread& deviations,
                                     const PlayedVoltages& voltages)
{
    PlayedInformation information (static_cast<std::size_t> (model.modes()));
    parallelFor (information.size(),
                 [&] (std::size_t k)
                 {
                     checkWatch();
                     information[k] = informationOnMode (model, deviations, voltages, static_cast<Eigen::Index> (k));
                 });
    return information;
}

double informationBits (const PlayedInformation& information, const Eigen::VectorXd& audibilities)
{
    double sum = 0;

    for (std::size_t k = 0; k < information.size(); ++k)
        sum += (audibilities[static_cast<Eigen::Index> (k)] * information[k].array()).log1p().sum();

    return sum / (2 * std::log (2.0));
}

SensorChoice chooseSensors (const PlayedInformation& information, const Eigen::MatrixXd& audibilities,
                            Eigen::Index count)
{
    constexpr int mostRounds = 20;
    SensorChoice choice;
    Eigen::VectorXd sum = Eigen::VectorXd::Zero (audibilities.cols());

    while (static_cast<Eigen::Index> (choice.chosen.size()) < count)
    {
        choice.chosen.push_back (bestCandidate (information, audibilities, sum, choice.chosen));
        sum += audibilities.row (choice.chosen.back()).transpose();
    }

    for (int i = 0; i < mostRounds && exchange (information, audibilities, choice.chosen, sum); ++i)
        ;

    // In the order of what they add.
    std::vector<Eigen::Index> left = std::move (choice.chosen);
    choice.chosen.clear();
    sum.setZero();

    while (! left.empty())
    {
        const Eigen::MatrixXd some = audibilities (left, Eigen::all);
        const auto at = bestCandidate (information, some, sum, {});
        sum += some.row (at).transpose();
        choice.chosen.push_back (left[static_cast<std::size_t> (at)]);
        choice.bits.push_back (informationBits (information, sum));
        left.erase (left.begin() + at);
    }

    return choice;
}

Eigen::MatrixX2d placesToMeasure (const ModalModel& model, int count)
{
    constexpr double margin = 0.08; // of the shorter side: aim is worst, and motion least like the drawing's, at edges
    const auto& surface = model.surface;
    const auto isLine = surface.kind == SurfaceKind::line;
    const int candidates = isLine ? 20 : 60; // So few that chosen ones are some millimetres apart: aim is no better.
    const auto width = surface.xMaximum - surface.xMinimum, height = surface.yMaximum - surface.yMinimum;
    const auto wide = margin * (isLine ? width : std::min (width, height));
    const auto isInside = [&] (double x, double y, double away)
    {
        const auto up = isLine ? 0.0 : away;
        return liesOn (surface, x - away, y) && liesOn (surface, x + away, y) && liesOn (surface, x, y - up)
               && liesOn (surface, x, y + up);
    };
    const auto centres = squareCells (surface, candidates).centres;
    std::vector<Eigen::Index> inside;

    // Where the surface is narrow, closer to its edges.
    for (auto away = wide; inside.empty() && away > wide / 100; away /= 2)
        for (Eigen::Index c = 0; c < centres.rows(); ++c)
            if (isInside (centres (c, 0), centres (c, 1), away))
                inside.push_back (c);

    if (inside.empty())
        throw InputError ("device", "has no place for a sensor that is not at an edge");

    const Eigen::MatrixX2d at = centres (inside, Eigen::all);
    Eigen::MatrixXd audibilities = shapesAtPlaces (model, at).cwiseAbs2();

    // All modes count alike, however large their shapes are.
    constexpr double signalToNoise = 100;
    for (auto mode : audibilities.colwise())
        if (const auto mean = mode.mean(); mean > 0)
            mode *= signalToNoise / mean;

    const PlayedInformation information (static_cast<std::size_t> (model.modes()), Eigen::VectorXd::Ones (1));
    const auto choice = chooseSensors (information, audibilities, std::min<Eigen::Index> (count, at.rows()));
    return at (choice.chosen, Eigen::all);
}
} // namespace antinode
