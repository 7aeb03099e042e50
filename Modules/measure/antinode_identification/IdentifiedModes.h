#pragma once

#include "FrequencyResponses.h"

namespace antinode
{
/** How the shapes are scaled: responses alone determine only the products phi_pk alpha_ki. Docs/Theory.md, section 8.6.
 */
enum class ShapeScaling
{
    drivingPoint, ///< A force acts at a measured point q: alpha_k = phi_qk, and the modal mass is 1.
    knownMass,    ///< sum over points of mass phi_pk^2 = 1 with given masses.
    convention    ///< As if the points stood for 1 kg in all, evenly: sum phi_pk^2 = N_p. Products are right, sizes are
                  ///< not known.
};

/** The uncertainty of an estimate: standard deviations. N_m modes, N_b references, N_p points. Docs/Theory.md,
   section 8.5. */
struct ModeDeviations
{
    Eigen::VectorXd angularFrequencies; ///< N_m: rad/s.
    Eigen::VectorXd dampingRatios;      ///< N_m
    Eigen::MatrixXd shapes;             ///< N_p x N_m, at fixed size of the shape.
    Eigen::MatrixXd participation;      ///< N_m x N_b, at fixed size of the shape.
    double delay = 0;                   ///< s; 0 where the delay was given.
};

/** Quality measures of one identified mode. */
struct ModeQuality
{
    double rankOne = 1; ///< Share of its residues' energy that one shape times one participation explains; 1 is best.
    double collinearity = 1;  ///< Modal phase collinearity (MPC): 1 where all points move in phase or against it.
    double presence = 1;      ///< Share of the model orders at which it was found.
    double signalToNoise = 0; ///< Its energy over that of the noise in its estimate, as amplitudes.
    std::vector<std::string> warnings; ///< Warnings, as sentences; empty if there are none.
};

/** Residual terms of modes outside the band: coefficients (i omega)^power to the velocity per drive, behind the delay.
 */
struct ResidualTerm
{
    int power =
        1; ///< -1: a rigid body's or lower modes' inertia. 1: stiffness of higher modes. Even ones: their damping.
    Eigen::MatrixXd coefficients; ///< N_p x N_b
};

/** One pole of one model order: what a stabilisation diagram is made of. */
struct StabilisationPoint
{
    int order = 0;
    double frequency = 0;    ///< Hz
    double dampingRatio = 0; ///< Above 0: others are not kept.
    bool stable = false;     ///< True where it belongs to a mode that is found at enough orders.
};

/** A pole that recurs: what may be picked as a mode. */
struct PoleCandidate
{
    double frequency = 0; ///< Hz
    double dampingRatio = 0;
    double presence = 0;              ///< Share of the model orders at which it was found.
    std::optional<Eigen::Index> mode; ///< The mode that was fitted from it.
};

/** Modes as they follow from frequency responses. N_m modes, ascending in frequency; N_p points; N_b references.

    H(p, i) = [ sum_k phi_pk alpha_ki i omega / (omega_k^2 - omega^2 + 2 i xi_k omega_k omega) + residual terms ]
    exp (-i omega delay) / (1 + i omega lowPass). Docs/Theory.md, sections 8.2 to 8.6.
*/
struct IdentifiedModes
{
    DriveQuantity drive = DriveQuantity::voltage;
    int integrations = 0; ///< As FrequencyResponses::integrations: of what was measured, also where nothing stated it.
    std::vector<Reference> references;  ///< N_b
    Eigen::MatrixX2d points;            ///< N_p x 2, m.
    Eigen::VectorXd angularFrequencies; ///< N_m: omega_k, rad/s, undamped.
    Eigen::VectorXd dampingRatios;      ///< N_m
    Eigen::MatrixXd shapes; ///< N_p x N_m: phi_k, kg^-1/2; the largest value is positive. NaN at points without data.
    Eigen::MatrixXd participation;         ///< N_m x N_b: alpha_ki, N kg^-1/2 / V, or kg^-1/2 for forces.
    Eigen::MatrixXcd complexShapes;        ///< N_p x N_m, rotated onto the real axis; empty where modes are real.
    Eigen::MatrixXcd complexParticipation; ///< N_m x N_b; with complexShapes as the real ones; empty where they are.
    std::string kindReason;                ///< Why modes are real or complex, a sentence; empty where options said it.
    double delay = 0;                      ///< s, common to all.
    ModeDeviations deviations;             ///< The larger of noise's and of what points and references disagree by.
    ModeDeviations noiseDeviations;   ///< Of white noise alone, the Cramer-Rao bound; empty where peaks were picked.
    std::vector<ModeQuality> quality; ///< N_m
    Eigen::MatrixXd lowPasses; ///< N_p x N_b: time constants, s, of low-passes of first order that were removed from
                               ///< the responses; 0 where there is none, empty where none was found.
    ShapeScaling scaling = ShapeScaling::convention;
    std::string scalingReason; ///< Why this scaling, as a sentence.
    std::vector<ResidualTerm> residuals;
    Eigen::MatrixXd staticShare; ///< N_p x N_b: as ModalRest has it; empty where peaks were picked.
    std::vector<StabilisationPoint> stabilisation;
    std::vector<PoleCandidate> candidates; ///< Those among which IdentificationOptions::selected chooses; ascending.
    double minimumFrequency = 0, maximumFrequency = 0; ///< Hz: the lines that were used.
    double reconstructionError =
        0; ///< RMS of measured minus synthesised velocities over RMS of measured, dB, on those lines.
    double measuredReconstructionError = 0; ///< The same of what was measured, accelerations or displacements.
    double modalReconstructionError = 0;    ///< As reconstructionError, of the modes alone, without residual terms.
    double misfit = 1; ///< Energy of the residual over that of its noise: 1 where modes leave nothing but noise.
    double noise =
        0; ///< RMS of the residual, (m/s)/V or (m/s)/N; at the geometric middle of the lines where it is not white.
    std::vector<std::string> warnings; ///< Warnings about the whole identification, as sentences.

    Eigen::Index modes() const { return angularFrequencies.size(); }
};

/** The responses synthesised from modes, residual terms and delay, for comparison with measured ones.
    @param frequencies  N_f: Hz, ascending, at least 0
    @return             values (m/s)/V or (m/s)/N, without variances; complex modes where there are any
    [worker] Docs/Theory.md, section 8.1. */
FrequencyResponses synthesise (const IdentifiedModes&, const Eigen::VectorXd& frequencies);
} // namespace antinode
