#pragma once

#include "NormalModes.h"

namespace antinode
{
/** Points whose references have weights in the same proportion: they share every matrix of a fit. */
struct PointGroup
{
    Eigen::VectorXd referenceWeights; ///< N_b, the largest 1.
    std::vector<Eigen::Index> points; ///< N
    Eigen::VectorXd pointWeights;     ///< N
};

/** All points with any weight, in groups. @param columnWeights C [worker] */
std::vector<PointGroup> groupPoints (const Eigen::VectorXd& columnWeights, Eigen::Index points,
                                     Eigen::Index references);

/** The state of a fit: its products, and all fitted values. N_m modes, N_b references, N_p points. */
struct FitState
{
    ModalBasis basis;
    ModalProducts products, reduced; ///< With powers, and with these taken out.
    std::vector<PointGroup> groups;
    Eigen::VectorXd columnWeights; ///< C
    Eigen::MatrixXd strengths;     ///< N_m x N_b: participation over angular frequency.
    Eigen::MatrixXd shapes;        ///< N_p x N_m; 0 at points without weight.

    Eigen::Index modes() const { return strengths.rows(); }
    Eigen::Index references() const { return strengths.cols(); }
    /** Unknown a of mode k: strengths of the references, then frequency in half widths, damping relative to itself. */
    Eigen::Index unknown (Eigen::Index mode, Eigen::Index a) const { return a * modes() + mode; }
    Eigen::Index unknowns() const { return modes() * (references() + 2) + 1; }   ///< The last one is the delay.
    double delayUnit() const { return 1 / basis.angularFrequencies.maxCoeff(); } ///< s
};

/** Shapes that fit best for given poles and strengths: N_p x N_m. [worker] Docs/Theory.md, section 8.4. */
Eigen::MatrixXd bestShapes (const FitState&, double ridge);

/** The coefficients of the modes: phi alpha / omega, N_m x C. [any] */
Eigen::MatrixXd amplitudes (const FitState&);

/** Of the powers, powers x C: the remainder after the modes. [worker] */
Eigen::MatrixXd residualCoefficients (const FitState&);

/** Gauss-Newton equations in the unknowns of FitState, the best shapes eliminated. */
struct NormalEquations
{
    Eigen::MatrixXd matrix;   ///< Square, symmetric; lower triangle.
    Eigen::VectorXd gradient; ///< Of minus half the cost.
    double cost = 0;          ///< Weighted sum of squared errors.
};

/** The matrix is a sum over groups of (Phi' W Phi)_kl times small sums that no more know the points: its cost does not
   grow with them. [worker] Docs/Theory.md, section 8.4. */
NormalEquations normalEquations (const FitState&, double ridge);

/** The coupling of the unknowns of one group with the shapes of one of its points, per unit of the shape: K^-1 X, N_m x
   N_m (N_b + 3), the last N_m columns for a delay of each mode on its own; K^-1; and its diagonal. */
struct ShapeCoupling
{
    Eigen::MatrixXd perUnknown, inverse;
    Eigen::VectorXd inverseDiagonal;
};

/** [worker] Docs/Theory.md, section 8.5. */
ShapeCoupling shapeCoupling (const FitState&, const PointGroup&, double ridge);

/** The result of a maximum-likelihood fit of real normal modes. */
struct NormalModeFit
{
    NormalModes modes;
    FitState state;  ///< At its end.
    double cost = 0; ///< Weighted sum of squared errors.
    int iterations = 0;
    bool isConverged = false; ///< Whether no step is worth the precision that was asked for.
};

/** The start of a fit and its free unknowns. */
struct NormalModeStart
{
    Eigen::VectorXd angularFrequencies, dampingRatios; ///< N_m
    Eigen::MatrixXd participation;                     ///< N_m x N_b
    double delay = 0;
    bool delayIsKnown = false;
};

/** All poles, shapes, participations and the common delay at once, by Levenberg and Marquardt's method. Shapes and
   residual terms are eliminated in each step (variable projection), so that only sums over frequencies and points
   remain.
    @param ridge      relative, on the diagonal of the normal equations
    @param precision  it ends where a step would be worth less than this many squared standard deviations
    @param maximum       iterations
    @return           look at isConverged
    [worker] Docs/Theory.md, section 8.4. */
NormalModeFit fitNormalModes (const PreparedResponses&, const NormalModeStart&, double ridge, double precision,
                              int maximum);

/** Makes equations regular: fixes the lengths of participations, which the data leave free, and the delay where it is
   known. [worker] Docs/Theory.md, section 8.4. */
void holdWhatIsNotSeen (NormalEquations&, const FitState&, bool delayIsKnown);

/** The start of a fit from unconstrained residues: the strongest product of shape and participation of each mode.
    @param residues  N_m x C, phi alpha
    @return          participations, N_m x N_b
    [worker] */
Eigen::MatrixXd strongestParticipation (const Eigen::MatrixXd& residues, const PreparedResponses&);
} // namespace antinode
