#pragma once

#include "DriftEstimate.h"
#include "PlayedVoltages.h"

#include <antinode_model/ModalModel.h>

#include <vector>

namespace antinode
{
/** What slow modes still do in a recording from before its beginning, where nothing is known of the voltages: any sum
    of their free decays. It is taken out of what is compared. */
class RingingBefore
{
public:
    /** @param modes    as they are taken to be
        @param memory   s before the first sample that is compared: modes that have decayed by then are left out
        @param samples  that are compared
        [worker] Docs/Theory.md, section 7.7. */
    RingingBefore (const ModalModel& modes, double sampleRate, double memory, Eigen::Index samples);

    /** Takes it out of signals, N_s x any. [worker] */
    void takeOutOf (Eigen::Ref<Eigen::MatrixXd> signals) const;

private:
    Eigen::MatrixXd basis; // N_s x 2 for each slow mode, orthonormal
};

/** Signals of a recording as the parameters of a drifting device predict them, and what they say of these. */
class DriftProblem
{
public:
    /** @param memory  s that are not compared
        @throws InputError  as followDrift [worker] */
    DriftProblem (const ModalModel& nominal, const std::vector<Sensor>&, const PlayedRecording&, double memory);

    /** What the recording says near some values. */
    struct Equations
    {
        std::vector<Eigen::Index> parameters; ///< That are heard.
        Eigen::MatrixXd matrix;               ///< J' J of these, in units of the noise.
        Eigen::VectorXd right;                ///< J' times the residual.
        double misfit = 0;                    ///< Sum of squared residuals over the noise.
    };

    /** Takes only the parameters of modes that the estimate's deviations could make heard: call it before all others.
        [worker] */
    void choose (const DriftEstimate&);

    Equations equations (const Eigen::VectorXd& values) const;

    /** Motions from before the recording explain what they can. */
    double misfit (const Eigen::VectorXd& values) const;

    /** How many noises the residual stands for: its sum of squares over the noise's, times how much narrower than white
       noise it is; at least 1. */
    double residualNoise (const Eigen::VectorXd& values) const;

    double signalEnergy() const { return energy; }            ///< Sum of squared signals over the noise.
    double heardEnergy (const Eigen::VectorXd& values) const; ///< The same of what is predicted.
    double samples() const { return static_cast<double> (signals.size()); }
    const DriftLayout& layout() const { return order; }

private:
    struct Prediction
    {
        Eigen::MatrixXd signals;         ///< N_s x N, over the noise
        std::vector<ModeMotion> motions; ///< Of the modes that are followed, from the recording's beginning.
        RingingBefore ringing;
    };

    Prediction predict (const Eigen::VectorXd& values, bool withChanges) const;
    Eigen::MatrixXd residualOf (const Prediction&) const;
    ModeMotion motionOf (const ModalModel& modes, Eigen::Index k, bool withChanges) const;
    auto compared (const Eigen::VectorXd& history) const { return history.segment (first, signals.rows()); }

    /** What a sensor hears of a mode, over the noise. */
    double gainOf (const Eigen::VectorXd& values, Eigen::Index sensor, Eigen::Index mode) const
    {
        return weights (sensor, mode) * (1 + values[order.gain (sensor, mode)]);
    }

    const ModalModel& nominal;
    DriftLayout order;
    PlayedVoltages voltages;
    Eigen::Index first = 0;             // sample that is compared
    Eigen::MatrixXd signals;            // N_s x N, of the compared part, over the noise
    Eigen::MatrixXd slopes;             // N_s x N_b, V/s, of the compared part
    Eigen::MatrixXd signalSlopes;       // N_s x N: by how much the signals change with the delay, per s
    Eigen::MatrixXd weights;            // N x N_m, shapes over the noise
    Eigen::VectorXd feedthroughWeights; // N: 1 over the noise
    double energy = 0;
    std::vector<Eigen::Index> followed; // modes
    Eigen::MatrixXd others;             // N_s x N: what is heard of the modes that are not followed
    Eigen::MatrixXd forces;             // of all modes, as PlayedVoltages gives them; empty where they are too many
    bool hasFeedthrough = false, hasDelay = false;
};
} // namespace antinode
