#pragma once

#include "EstimatedResponses.h"
#include "Sweep.h"

#include <vector>

namespace antinode
{
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
