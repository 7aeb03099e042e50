#pragma once

#include "IdentifiedModes.h"

namespace antinode
{
/** The identification method. */
enum class IdentificationMethod
{
    maximumLikelihood, ///< All modes, residual terms and the delay fitted at once, from poles found without hints.
    peakPicking        ///< Peaks and their half-power widths, shapes from the peaks' values: as the paper did it.
};

/** A range of frequencies, Hz. */
struct FrequencyBand
{
    double minimum = 0, maximum = 0;
};

/** Options of identification; all have defaults. */
struct IdentificationOptions
{
    IdentificationMethod method = IdentificationMethod::maximumLikelihood;
    double minimumFrequency = 0;      ///< Hz: lines below are not used.
    double maximumFrequency = 1e12;   ///< Hz: lines above are not used.
    std::vector<FrequencyBand> bands; ///< Bands in which poles are searched separately; empty: automatic.
    int minimumOrder = 3;             ///< Of the polynomials, 1 or more.
    int maximumOrder = 0;             ///< 0: chosen.
    std::optional<bool> complexModes; ///< Complex as well as real shapes and participations; none: a test decides.
    std::vector<double> selected;     ///< Hz: if any, only the candidates nearest to these are kept, each once.
    std::vector<double> rejected;     ///< Hz: the candidates nearest to these are left out.
    Eigen::VectorXd pointWeights; ///< N_p: confidence in each point, at least 0; empty: from variances or residuals.
    Eigen::VectorXd
        pointMasses; ///< N_p: kg that each point stands for, whose shapes then have modal mass 1; may be empty.
    std::optional<double> delay; ///< s, where it is known.
    double ridge = 1e-12;        ///< Relative, on the diagonal of normal equations: input without noise is singular.
    bool gramSchmidt =
        false; ///< Shapes made orthogonal as the paper did, participation with them: spoils shapes of a part.
};

/** Modes from measured responses, without hints: bands, compression across points, polynomials of rising order whose
   poles are clustered, then one maximum-likelihood fit of all real normal modes, residual terms and the common delay;
   a test decides whether modes are complex.
    @throws InputError  when the responses are not valid, options contradict them, or no mode is found
    [worker] Docs/Theory.md, sections 8.2 to 8.5. */
IdentifiedModes identify (const FrequencyResponses&, const IdentificationOptions&);

/** Points on which a range or a cause can be judged: all of them, or, of more than 24, as many spread evenly over
   their numbers. [any] Docs/Design/identification.md */
std::vector<Eigen::Index> samplePoints (const FrequencyResponses&);

/** Only some of the points: a copy of their responses. [worker] */
FrequencyResponses atPoints (const FrequencyResponses&, const std::vector<Eigen::Index>& points);

/** Options for some of the points: their weights and masses. [any] */
IdentificationOptions atPoints (IdentificationOptions, const std::vector<Eigen::Index>& points);
} // namespace antinode
