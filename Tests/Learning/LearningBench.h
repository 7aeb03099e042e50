#pragma once

#include "Support/SineBeam.h"

#include <antinode_engine/OfflineRender.h>
#include <antinode_focus/Detuning.h>
#include <antinode_focus/FocusScore.h>
#include <antinode_learning/LearningPasses.h>
#include <antinode_numerics/Statistics.h>

#include <cmath>
#include <vector>

// Plays of a focus on a beam that is not the one that is known, for the tests of learning.

namespace antinode::test
{
constexpr double benchRate = 24000;
constexpr int knownModes = 7, allModes = 9;

/** What the plate model, which steps from sample to sample, gives for voltages: rows of shapes x N_s. */
inline Eigen::MatrixXd played (const ModalModel& model, const Eigen::MatrixXd& shapes, const Eigen::MatrixXd& voltages)
{
    PlateModel plate (model, { Reconstruction::bandLimited, benchRate }, shapes);
    Eigen::MatrixXd fed = Eigen::MatrixXd::Zero (voltages.rows(), voltages.cols() + plate.latencySamples());
    fed.leftCols (voltages.cols()) = voltages;
    Eigen::MatrixXd velocities (shapes.rows(), fed.cols());
    plate.process (fed, velocities);
    return velocities.rightCols (voltages.cols());
}

inline FocusDescription sincFocus()
{
    FocusDescription focus;
    focus.targets = { { TargetShape::sinc, 0.02, 0, 0.05, 0.02, 1 } };
    focus.focusTime = 0.02;
    focus.modes.count = 5;
    focus.allocation.voltageLimit = 150;
    return focus;
}

inline LearningSettings threePasses()
{
    return { benchRate, 0.12, 3 };
}

/** A beam whose modes are not those of the model, with sensors that are some samples late. */
struct Bench
{
    WideModel nominal { sineBeam (allModes, 5), knownModes, {} };
    ModalModel truth;
    std::vector<double> places { -0.07, -0.033, 0.012, 0.055 };
    double noise = 0.01, delay = 37 / benchRate, delayError = 4e-6;
    Eigen::VectorXd distortions = Eigen::VectorXd::Zero (5); // 1/V^2, of the ceramics
    double delaySpan = 0; // above 0: nobody says the delay, which is another one in each pass

    explicit Bench (double scatter, std::uint64_t seed)
        : truth (detuned (sineBeam (allModes, 5), { scatter, 0.1, 0.05, 0 }, seed))
    {
    }

    std::vector<Sensor> sensors() const
    {
        std::vector<Sensor> result;

        for (const auto place : places)
            result.push_back ({ shapesAt (nominal.model, place, 0) });

        return result;
    }

    /** Those of a model at the sensors: sensors x modes. */
    Eigen::MatrixXd shapes (const ModalModel& model) const
    {
        Eigen::MatrixXd rows (static_cast<Eigen::Index> (places.size()), model.modes());

        for (Eigen::Index m = 0; m < rows.rows(); ++m)
            rows.row (m) = shapesAt (model, places[static_cast<std::size_t> (m)], 0);

        return rows;
    }

    PlayedRecording operator() (const Eigen::MatrixXd& voltages, int pass) const
    {
        const auto isKnown = delaySpan == 0;
        const auto late = static_cast<Eigen::Index> (delay * benchRate) + (isKnown ? 0 : 61 * pass);
        const auto heard = played (truth, shapes (truth), acting (voltages));
        Eigen::MatrixXd signals = Eigen::MatrixXd::Zero (heard.rows(), heard.cols());
        signals.rightCols (signals.cols() - late) = heard.leftCols (signals.cols() - late);
        RandomNumbers random (static_cast<std::uint64_t> (100 + pass));
        const Eigen::VectorXd deviations =
            noise * signals.rowwise().norm() / std::sqrt (static_cast<double> (signals.cols()));

        for (Eigen::Index m = 0; m < signals.rows(); ++m)
            signals.row (m) += deviations[m] * random.normal (signals.cols()).transpose();

        return { benchRate, voltages, signals, deviations, isKnown ? delay + delayError : 0, delaySpan };
    }

    /** Voltages that linear ceramics would need to act like these. */
    Eigen::MatrixXd acting (Eigen::MatrixXd voltages) const
    {
        for (Eigen::Index i = 0; i < voltages.rows(); ++i)
            for (auto& voltage : voltages.row (i))
                voltage += distortions[i] * voltage * voltage * voltage;

        return voltages;
    }

    /** The field at the focus that voltages make. */
    Eigen::VectorXd field (const Eigen::MatrixXd& voltages) const
    {
        return played (truth, truth.shapes, acting (voltages))
            .col (static_cast<Eigen::Index> (sincFocus().focusTime * benchRate));
    }

    /** The voltages of one who knows the beam. */
    Eigen::MatrixXd exactVoltages() const
    {
        const Playback playback { Reconstruction::bandLimited, benchRate };
        const auto design = designWithin ({ truth, knownModes, {} }, sincFocus(), playback, DesignExtent::compared);
        return renderOffline (truth, design.program,
                              { playback, threePasses().duration, 512, Eigen::MatrixXd (0, truth.modes()) })
            .voltages;
    }

    double fieldError (const Eigen::MatrixXd& voltages) const
    {
        const Eigen::VectorXd wanted = played (truth, truth.shapes, exactVoltages())
                                           .col (static_cast<Eigen::Index> (sincFocus().focusTime * benchRate));
        return scoreField (truth.surface, field (voltages), wanted).fieldError;
    }
};

inline LearntFocus learn (const Bench& bench, const PassPlayer& play)
{
    return learnFocus (bench.nominal, sincFocus(), bench.sensors(),
                       sameSpread (bench.nominal.model.modes(), 0.005, 0.1, 0.05), play, threePasses());
}
} // namespace antinode::test
