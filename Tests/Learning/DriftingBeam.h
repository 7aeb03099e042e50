#pragma once

#include "Support/SineBeam.h"

#include <antinode_engine/OfflineRender.h>
#include <antinode_focus/Detuning.h>
#include <antinode_focus/SpillOver.h>
#include <antinode_learning/PlayedRecording.h>
#include <antinode_numerics/Statistics.h>

#include <cmath>
#include <vector>

namespace antinode::test
{
inline constexpr double driftRate = 24000;                            // Hz
inline constexpr Eigen::Index knownModes = 7, allModes = 9, idle = 4; // the last of five ceramics listens

/** A beam that drifts, under whatever is played: noise that falls from 1 kHz on. Its plate model steps from sample to
   sample and has two modes more than the one that follows. */
struct DriftingBeam
{
    ModalModel nominal = firstModes (sineBeam (allModes, 5), knownModes);
    ModalModel truth;
    std::uint64_t seed = 1;
    double noise = 0.01, feedthrough = 0;

    explicit DriftingBeam (double drift, double scatter, std::uint64_t seedToUse = 1)
        : truth (detuned (sineBeam (allModes, 5), { scatter, 0.02, 0.01, 0 }, seedToUse)), seed (seedToUse)
    {
        truth.angularFrequencies *= 1 + drift;
    }

    std::vector<Sensor> sensors() const { return { { nominal.participation.col (idle).transpose() } }; }

    /** An idle ceramic is given no voltage. */
    ModalModel driven() const
    {
        auto model = nominal;
        model.participation.col (idle).setZero();
        return model;
    }

    /** As it was recorded. @param isCharge  of the idle ceramic, in place of its current */
    PlayedRecording recordAll (double duration, double level = 20, bool isCharge = false) const
    {
        constexpr auto rate = driftRate;
        const auto samples = static_cast<Eigen::Index> (duration * rate);
        RandomNumbers random (1000 * seed + 7);
        Eigen::MatrixXd voltages = Eigen::MatrixXd::Zero (5, samples);

        for (Eigen::Index i = 0; i < idle; ++i)
        {
            const Eigen::VectorXd white = random.normal (samples);
            double once = 0, twice = 0;

            for (Eigen::Index n = 0; n < samples; ++n)
            {
                once += 0.3 * (white[n] - once);
                twice += 0.3 * (once - twice);
                voltages (i, n) = level * twice;
            }
        }

        return hear (std::move (voltages), isCharge);
    }

    /** The answer to voltages, with noise of its own. */
    PlayedRecording hear (Eigen::MatrixXd voltages, bool isCharge = false) const
    {
        constexpr auto rate = driftRate;
        const auto samples = voltages.cols();
        RandomNumbers random (1000 * seed + 8);
        auto plate = truth;
        plate.participation.col (idle).setZero();
        PlateModel model (plate, { Reconstruction::bandLimited, rate },
                          truth.participation.col (idle).transpose().eval());
        Eigen::MatrixXd fed = Eigen::MatrixXd::Zero (5, samples + model.latencySamples());
        fed.leftCols (samples) = voltages;
        Eigen::MatrixXd heard (1, fed.cols());

        if (isCharge)
            for (Eigen::Index n = 0; n < fed.cols(); ++n)
            {
                Eigen::VectorXd velocities (plate.modes());
                model.processModes (fed.col (n), velocities);
                heard (0, n) = truth.participation.col (idle).dot (model.modalDisplacements());
            }
        else
            model.process (fed, heard);

        PlayedRecording recording { rate, voltages, heard.rightCols (samples), {}, 0 };

        // The slope by five points, 1 % low at 3 kHz.
        for (Eigen::Index n = 2; n + 2 < samples; ++n)
            recording.signals (0, n) +=
                feedthrough * rate / 12
                * (8 * (voltages (0, n + 1) - voltages (0, n - 1)) - (voltages (0, n + 2) - voltages (0, n - 2)));

        const auto deviation = noise * recording.signals.norm() / std::sqrt (static_cast<double> (samples)) + 1e-12;
        recording.signals.row (0) += deviation * random.normal (samples).transpose();
        recording.noise = Eigen::VectorXd::Constant (1, deviation);
        return recording;
    }

    /** Below the highest mode that is known. */
    PlayedRecording record (double duration, double level = 20) const
    {
        return atLowerRate (recordAll (duration, level), highestModelled (nominal));
    }
};
} // namespace antinode::test
