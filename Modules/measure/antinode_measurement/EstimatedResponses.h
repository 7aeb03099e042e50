#pragma once

#include "Excitation.h"

#include <Eigen/Core>

#include <vector>

namespace antinode
{
/** The nonlinear part of the sensor signals, RMS values relative to the linear response within the band. */
struct NonlinearDistortion
{
    double even = 0, odd = 0;      ///< Of a multisine with an odd grid, noise taken out; else 0.
    std::vector<double> harmonics; ///< Of a sweep: the second, the third, ...; else empty.
};

/** Responses of N sensors to one ceramic, on N_f lines. */
struct EstimatedResponses
{
    Eigen::MatrixXcd values;   ///< N_f x N: output per input with exp (+i omega t).
    Eigen::MatrixXd variances; ///< N_f x N: E |error|^2; empty if one period alone cannot tell.
    Eigen::MatrixXd
        coherence; ///< N_f x N: 0 to 1, the share of a block's power that comes from the input; empty in the same case.
    std::vector<NonlinearDistortion> distortion; ///< One per sensor; empty if the excitation does not show it.
};

/** Variances that few repetitions tell: each becomes the mean of itself and four neighbours at each side, within which
   a resonance hardly changes. @param variances  N_f x N [worker] */
Eigen::MatrixXd averagedOverNeighbours (const Eigen::MatrixXd& variances);

/** The classical estimators. S_yx = E Y conj X. */
enum class ResponseEstimator
{
    h1, ///< S_yx / S_xx: unbiased by noise at the output.
    h2, ///< S_yy / S_xy: unbiased by noise at the input.
    hv  ///< Their geometric mean, with their common phase.
};

/** Sums over blocks of an input's spectra and those of one output. */
class AveragedSpectra
{
public:
    /** @param input  N_f x N: the lines of N blocks [worker] */
    explicit AveragedSpectra (Eigen::MatrixXcd input);

    /** Whether the input has something on every line. [worker] */
    bool drivesAllLines() const { return powers.minCoeff() > 0; }

    /** Response, coherence and the variance of H1, |H|^2 (1 - gamma^2) / (gamma^2 n), of one sensor, into a column.
       One block fits itself and tells neither coherence nor variance.
        @param output    N_f x N
        @param averages  n, at most N where blocks overlap
        [worker] Bendat and Piersol, Random Data, 2010, section 9.1; Docs/Theory.md, section 8.9. */
    void estimate (const Eigen::MatrixXcd& output, ResponseEstimator, double averages, Eigen::Index column,
                   EstimatedResponses&) const;

private:
    Eigen::MatrixXcd spectra;
    Eigen::ArrayXd powers; ///< S_xx
};

/** Responses from signals of any kind, by Welch's averages: blocks with a Hann window that overlap by half.

    The variance is that of H1, |H|^2 (1 - gamma^2) / (gamma^2 n), n the number of blocks over 1.06 for the overlap.
   Leakage, which no averaging removes, shows in the coherence.
    @param block  samples, no more than there are
    @param lines  those of a block that are given, ascending
    @param input, outputs  as many samples each; outputs N x samples
    @throws InputError  where there are fewer samples than a block, or the input has nothing on a line
    [worker] Welch, IEEE Trans. Audio Electroacoust. 15, 1967; Bendat and Piersol, Random Data, 2010, section 9.1;
   Docs/Theory.md, section 8.9. */
EstimatedResponses estimateByWelch (Eigen::Index block, const std::vector<Eigen::Index>& lines, ResponseEstimator,
                                    const Eigen::VectorXd& input, const Eigen::MatrixXd& outputs);

/** The lines of a periodic excitation. */
struct PeriodicLines
{
    Eigen::Index period = 0;           ///< Samples.
    std::vector<Eigen::Index> excited; ///< Ascending.
    bool showsDistortion = false;      ///< The lines between them tell of even and odd distortion.
};

/** Responses to a periodic signal in its steady state: mean output over mean input, line by line, without leakage.

    The variance comes from how periods differ, that of the input and what both share included: with R periods and h =
   Y/X

        E |error|^2 = |h|^2 (s_Y^2 / |Y|^2 + s_X^2 / |X|^2 - 2 Re (s_YX / (Y conj X))) / R.

    @param input    whole periods
    @param outputs  N x as many samples
    @throws InputError  where the length is no whole number of periods, or the input has nothing on a line
    [worker] Pintelon and Schoukens, System Identification, 2012, section 2.5; Docs/Theory.md, section 8.9. */
EstimatedResponses averagePeriods (const PeriodicLines&, const Eigen::VectorXd& input, const Eigen::MatrixXd& outputs);

/** The played sweep and the wanted response. */
struct RepeatedSweep
{
    Sweep sweep;
    double sampleRate = 0;           ///< Hz
    double lowest = 0, highest = 0;  ///< Hz: the band; between it and the sweep's ends the deconvolution is faded.
    Eigen::Index block = 0;          ///< Samples of a sweep and the silence after it.
    Eigen::Index responseLength = 0; ///< Samples of the impulse response that are kept, at most those of the silence.
    std::vector<Eigen::Index> lines; ///< Ascending, within the band; lines lie sampleRate / responseLength apart.
};

/** Responses from repeated exponential sweeps: output over input gives the impulse response, before which harmonic m
   stands earlier by L ln m. The linear part is cut out and transformed, the others give the harmonics' levels. The
   variance comes from how repetitions differ.
    @param input    whole blocks, as they were played or recorded
    @param outputs  N x as many samples
    @throws InputError  where lengths do not agree or the input has nothing within the band
    [worker] Farina, AES 108, 2000; Novak, Lotton and Simon, J. Audio Eng. Soc. 63, 2015; Docs/Theory.md, section 8.9.
 */
EstimatedResponses deconvolveSweep (const RepeatedSweep&, const Eigen::VectorXd& input, const Eigen::MatrixXd& outputs);
} // namespace antinode
