#pragma once

#include "LearningEquations.h"

#include <limits>
#include <vector>

namespace antinode
{
/** Parameters that are looked for, among all. */
struct Unknowns
{
    LearningParameters parameters;
    std::vector<Eigen::Index> places; ///< Theirs in the values of all parameters.
    Eigen::MatrixXd sharedEffects;    ///< As effectsOfShared().
};

/** Where an iteration ended. */
struct LearningSolution
{
    Eigen::VectorXd values;               ///< P, of all parameters, in standard deviations.
    Eigen::MatrixXd factored;             ///< The matrix of the last step, as factorLower leaves it.
    double residual = 0, unexplained = 0; ///< As in LearntModes, of whole records; by finish.
    double distance = 0;                  ///< As LearningProblem::distance; by finish.
    double largestMove = 0;               ///< As in LearntModes; by finish.
};

/** What the data say of all that they hear, recordings up to a time. One thread at a time.
    Docs/Theory.md, sections 7.6 and 8.7. */
class LearningProblem
{
public:
    /** Of the objective: a step that gains less than this share is the last of whole records. */
    static constexpr double finestGain = 1e-5;

    /** @param prior  is kept by reference [worker] */
    explicit LearningProblem (const LearningPrior& prior);

    /** Every parameter that is heard. [any] */
    const Unknowns& all() const { return every; }

    /** Those of which the recordings have more than ten times the information that was there before, two fifths of
        them on a plate with hundreds of modes. [any] */
    const Unknowns& clearlyHeard() const { return clear; }

    /** The device at values of all parameters. [any] */
    LearningState state (const Eigen::VectorXd& values) const;

    /** The most probable values of some unknowns, from values nearby; the others stay as they are.
        @param time      s, of each record
        @param enough    of the objective: a step that gains less than this share and .05 for each unknown is the last
        @param furthest  deviations that no value leaves
        @param hopeless  a distance, below: where the first four steps leave more, they are the last
        @throws Cancelled  where the thread's watch says so
        [worker] */
    LearningSolution solve (const Unknowns&, Eigen::VectorXd values, double time, double enough, double furthest,
                            double hopeless = std::numeric_limits<double>::infinity()) const;

    /** The same of all unknowns, to the end, and how well they explain the records.
        @param values  close to the solution
        [worker] */
    LearningSolution finish (Eigen::VectorXd values, double time) const;

    /** The device by a solution, and what is left of each deviation. [worker] */
    LearntModes learnt (const LearningSolution&) const;

    /** A solution with how well it explains the records, by what is believed of the noise now. [worker] */
    LearningSolution judged (LearningSolution, double time) const;

    /** The standard deviation of white noise that hides as much as what values leave unexplained: of each recording, of
        each sensor. [worker] */
    std::vector<Eigen::VectorXd> noiseLeft (const Eigen::VectorXd& values, double time) const;

    /** What values do not explain of a sensor, of its energy in all records. [worker] */
    double unexplainedShare (const Eigen::VectorXd& values, Eigen::Index sensor, double time) const;

    /** The RMS of the residual up to a time and of the values themselves, in units of the noise. [worker] */
    double distance (const Eigen::VectorXd& values, double time) const;

    /** Deviations by which a frequency is moved most, of modes below .4 of the lowest sample rate. [any] */
    double largestMoveHeardWell (const Eigen::VectorXd& values) const;

private:
    DataMisfit misfit (const LearningState&, double time) const;
    DataEquations equations (const Unknowns&, const Eigen::VectorXd& values, double time) const;
    const PlayedRecording& recording (Eigen::Index r) const;

    const LearningPrior& prior;
    Unknowns every, clear;
    Eigen::VectorXd farthest;   ///< P, deviations that no value leaves.
    Eigen::VectorXd stepLimits; ///< P, the same that a step of reach 1 does not leave.
};
} // namespace antinode
