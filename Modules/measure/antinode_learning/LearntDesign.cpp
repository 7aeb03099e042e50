#include "LearntDesign.h"

#include "DrivenModes.h"
#include "PlayedVoltages.h"

#include <Eigen/LU>
#include <antinode_base/MessageText.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/SpillOver.h>

#include <cmath>
#include <complex>
#include <numeric>
#include <utility>
#include <vector>

namespace antinode
{
namespace
{
constexpr double highestCorrected = 0.4; // of the sample rate

/** How many modes are corrected: the lowest ones. */
Eigen::Index correctedModes (const ModalModel& model, double sampleRate)
{
    Eigen::Index count = 0;

    while (count < model.modes() && model.frequencyHz (count) < highestCorrected * sampleRate)
        ++count;

    return count;
}

/** The two programs at once. */
VoltageProgram sum (VoltageProgram program, const VoltageProgram& more)
{
    const auto before = program.allocation.cols();
    program.oscillations.insert (program.oscillations.end(), more.oscillations.begin(), more.oscillations.end());
    program.allocation.conservativeResize (Eigen::NoChange, before + more.allocation.cols());
    program.allocation.rightCols (more.allocation.cols()) = more.allocation;
    return program;
}

/** Velocities of some modes at a time, by drives for these alone, within the same limits. */
FocusDesign designCorrection (const FocusDesign& design, const ModalModel& model, const Eigen::VectorXd& velocities)
{
    FocusDescription description;
    description.targets = design.description.targets;
    description.focusTime = design.program.focusTime;
    description.allocation.voltageLimit = design.description.allocation.voltageLimit;
    std::vector<int> all (static_cast<std::size_t> (model.modes()));
    std::iota (all.begin(), all.end(), 0);
    return designModes (model, description, all, velocities, design.playback, DesignExtent::compared);
}
} // namespace

std::optional<FocusDesign> correctedDesign (const FocusDesign& design, const ModalModel& learnt,
                                            const Eigen::VectorXd& missing)
{
    if (design.program.samples || design.moments.size() != 1)
        return {};

    try
    {
        const auto count = correctedModes (learnt, design.playback.sampleRate);
        const auto correction = designCorrection (design, firstModes (learnt, count), missing.head (count));
        auto corrected = design;
        auto& certificate = corrected.certificate;
        certificate.peakRatio += correction.certificate.peakRatio;
        certificate.peakVoltage += correction.certificate.peakVoltage;

        if (! (certificate.peakRatio <= 1))
            return {};

        corrected.program = sum (std::move (corrected.program), correction.program);
        corrected.choices.push_back ("Corrected from plays: " + inWords (peakVoltage (correction))
                                     + " V at most are added, for " + std::to_string (count) + " modes.");
        return corrected;
    }
    catch (const LimitError&)
    {
        return {};
    }
}

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
