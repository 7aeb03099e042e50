#include "PassDelay.h"

#include "LikelyDelays.h"
#include "ShiftedSignals.h"

#include <antinode_base/InputError.h>

namespace antinode
{
AlignedSignals alignedWith (const Eigen::MatrixXd& signals, const Eigen::MatrixXd& predicted, double sampleRate,
                            double longestDelay)
{
    if (signals.rows() != predicted.rows() || signals.isZero (0) || predicted.isZero (0))
        throw InputError ("recording", "is silent, or has another number of channels than expected; allowed: "
                                       "the signals of all points, as one plays");

    PlayedRecording recording;
    recording.sampleRate = sampleRate;
    recording.voltages = Eigen::MatrixXd::Zero (1, signals.cols());
    recording.signals = signals;
    recording.noise = Eigen::VectorXd::Ones (signals.rows());
    recording.delaySpan = longestDelay;

    AlignedSignals aligned;
    aligned.delay = likelyDelays (recording, predicted.transpose(), 1).front();
    aligned.signals = signalsEarlier (recording, aligned.delay, signals.cols()).transpose();
    return aligned;
}
} // namespace antinode
