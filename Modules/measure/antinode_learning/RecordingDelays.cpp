#include "RecordingDelays.h"

#include "LearningEquations.h"
#include "PlayedRecording.h"

#include <antinode_base/InputError.h>
#include <antinode_numerics/Fourier.h>
#include <antinode_numerics/Statistics.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace antinode
{
namespace
{
constexpr double leastShare = 0.25; // of the largest correlation

/** By lags from 0 on, in samples: all sensors together, by their noise. */
Eigen::VectorXd correlation (const PlayedRecording& recording, const Eigen::MatrixXd& predicted)
{
    const auto length = quickLength (static_cast<double> (recording.signals.cols() + predicted.rows()));
    Eigen::VectorXcd sum = Eigen::VectorXcd::Zero (length / 2 + 1);
    FourierTables tables;

    for (Eigen::Index m = 0; m < predicted.cols(); ++m)
        sum += tables.forward (predicted.col (m), length)
                   .conjugate()
                   .cwiseProduct (tables.forward (recording.signals.row (m).transpose(), length))
               / (recording.noise[m] * recording.noise[m]);

    return tables.inverse (sum, length);
}
} // namespace

std::vector<double> likelyDelays (const PlayedRecording& recording, const Eigen::MatrixXd& predicted, std::size_t most)
{
    const auto values = correlation (recording, predicted);
    const auto first = static_cast<Eigen::Index> (std::floor (recording.delay * recording.sampleRate));
    const auto span = static_cast<Eigen::Index> (std::ceil (recording.delaySpan * recording.sampleRate));
    const auto end = std::min (first + span + 1, values.size() - 1);
    std::vector<std::pair<double, double>> maxima; // correlation, lag

    for (auto n = first; n < end; ++n)
    {
        const auto before = n > 0 ? values[n - 1] : values[values.size() - 1];
        const auto curvature = before - 2 * values[n] + values[n + 1];

        if (values[n] > before && values[n] >= values[n + 1])
            maxima.emplace_back (values[n], static_cast<double> (n) + (before - values[n + 1]) / (2 * curvature));
    }

    std::sort (maxima.rbegin(), maxima.rend());
    std::vector<double> delays;

    for (const auto& [value, lag] : maxima)
        if (delays.size() < most && value >= leastShare * maxima.front().first)
            delays.push_back (
                std::clamp (lag / recording.sampleRate, recording.delay, recording.delay + recording.delaySpan));

    if (delays.empty())
        delays.push_back (recording.delay);

    return delays;
}

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

namespace
{
constexpr std::size_t mostLikely = 24; // delays that are compared by the beginning of the record
constexpr std::size_t mostTried = 5;   // of them that are tried on the whole record
constexpr double surelyRight = 1.5;    // times the noise: a delay that leaves less of the beginning is the right one
constexpr std::size_t fewCompared = 4; // so many delays are compared before one of them stands out
constexpr double farLess = 0.2;        // of the next one's misfit: what a delay leaves that stands out
constexpr double hardlyAny = 0.05;     // the same of the median of the others
constexpr double step = 10e-6;         // s, between delays beside the best one: a third of the highest modes' periods
constexpr int mostSteps = 8;           // to either side: a model that is off has its maxima some periods beside

struct ComparedDelay
{
    double delay = 0;              ///< s
    std::array<double, 2> misfits; ///< Of the beginning, by each bound.

    double least() const { return std::min (misfits[0], misfits[1]); }
};

bool isNearer (const ComparedDelay& one, const ComparedDelay& other)
{
    return one.least() < other.least();
}

/** Whether the least one is far less than all others. What modes beyond the model do is left by the right delay too, so
    the noise alone is no measure. */
bool oneStandsOut (std::vector<ComparedDelay> delays)
{
    if (delays.size() < fewCompared)
        return false;

    std::sort (delays.begin(), delays.end(), isNearer);
    std::vector<double> others;

    for (auto each = delays.begin() + 1; each != delays.end(); ++each)
        others.push_back (each->least());

    const auto least = delays.front().least(), next = others.front();
    return least < farLess * next && least < hardlyAny * median (std::move (others));
}

/** s: the likeliest delay by the correlation, since beginnings can mislead, then those that explain the beginning best,
    those of the two bounds in turn. */
std::vector<double> delaysWorthTrying (const std::vector<ComparedDelay>& compared, double likeliest)
{
    std::array ranked { compared, compared };
    std::vector<double> best { likeliest };

    for (std::size_t bound = 0; bound < ranked.size(); ++bound)
        std::sort (ranked[bound].begin(), ranked[bound].end(),
                   [bound] (const auto& one, const auto& other) {
                       return std::pair (one.misfits[bound], one.delay) < std::pair (other.misfits[bound], other.delay);
                   });

    for (std::size_t i = 0; i < compared.size() && best.size() < mostTried; ++i)
        for (const auto& each : ranked)
            if (std::find (best.begin(), best.end(), each[i].delay) == best.end())
                best.push_back (each[i].delay);

    best.resize (std::min (best.size(), mostTried));
    return best;
}

/** The best of the delays beside one, or the first that is surely right. */
template <typename Compare>
ComparedDelay bestBeside (ComparedDelay best, double earliest, double latest, const Compare& compare)
{
    const auto middle = best.delay;

    for (int i = 1; i <= mostSteps; ++i)
        for (const auto delay : { middle - i * step, middle + i * step })
        {
            if (delay < earliest || delay > latest)
                continue;

            if (const auto now = compare (delay); isNearer (now, best))
                best = now;

            if (best.least() < surelyRight)
                return best;
        }

    return best;
}
} // namespace

std::vector<double> firstDelays (const ModalModel& nominal, const std::vector<Sensor>& sensors,
                                 const ModeSpread& deviations, const PlayedRecording& recording)
{
    auto likely = delaysBy (meanModel (nominal, deviations.frequencies), sensors, recording, mostLikely);

    if (likely.size() == 1)
        return likely;

    constexpr auto none = std::numeric_limits<double>::infinity();
    std::array least { none, none }; // of each bound
    const auto compare = [&] (double delay) -> ComparedDelay
    {
        const ComparedDelay now { delay,
                                  misfitsOfBeginning (nominal, sensors, deviations, withDelay (recording, delay),
                                                      surelyRight, { least[0] / hardlyAny, least[1] / hardlyAny }) };

        for (std::size_t bound = 0; bound < least.size(); ++bound)
            least[bound] = std::min (least[bound], now.misfits[bound]);

        return now;
    };
    std::vector<ComparedDelay> compared;

    for (const auto delay : likely)
    {
        compared.push_back (compare (delay));

        if (compared.back().least() < surelyRight)
            return { delay };

        if (oneStandsOut (compared))
            return { std::min_element (compared.begin(), compared.end(), isNearer)->delay };
    }

    compared.push_back (bestBeside (*std::min_element (compared.begin(), compared.end(), isNearer), recording.delay,
                                    recording.delay + recording.delaySpan, compare));

    if (compared.back().least() < surelyRight)
        return { compared.back().delay };

    return delaysWorthTrying (compared, delaysBy (nominal, sensors, recording, 1).front());
}

namespace
{
/** What sensors would hear without delay until the voltages end: samples x N. Later phases of a model that is off are
    no help to find a delay. */
Eigen::MatrixXd predictedWhilePlayed (const ModalModel& model, const std::vector<Sensor>& sensors,
                                      const PlayedRecording& recording)
{
    const PlayedVoltages voltages (recording.voltages, recording.sampleRate);
    const auto velocities = modeVelocities (model, voltages, voltages.drivenSamples());
    Eigen::MatrixXd signals (velocities.rows(), std::ssize (sensors));

    for (std::size_t m = 0; m < sensors.size(); ++m)
        signals.col (static_cast<Eigen::Index> (m)) = velocities * sensors[m].shapes.transpose();

    return signals;
}

LearningState stateOf (const LearntModes& device, const LearningPrior& prior, const LearningParameters& delayOnly,
                       double delay)
{
    auto state = stateAt (prior, delayOnly, Eigen::VectorXd::Zero (delayOnly.size()));
    state.distortions = device.distortions;
    state.delays[0] = delay;
    return state;
}

/** s: one step of Gauss and Newton's method to the delay that suits a device best, within what a recording may have and
    a sample, where the misfit is a parabola. A delay that is known has a deviation too. */
double betterDelay (const LearningPrior& prior, const LearningParameters& delayOnly, const LearningState& state,
                    const PlayedRecording& recording)
{
    const auto samples = comparableSamples (prior.recordings.front());
    const auto equations = recordingEquations (prior, delayOnly, state, 0, samples);
    const auto place = delayOnly.delay (0);
    const auto curvature = equations.matrix (place, place), delay = state.delays[0];

    if (! (curvature > 0))
        return delay;

    constexpr double farthest = 4; // deviations
    const auto deviation = prior.deviations.delay;
    const auto sample = 1 / recording.sampleRate;
    const auto change = deviation * equations.right[place] / curvature;
    return std::clamp (delay + std::clamp (change, -sample, sample),
                       std::max (0.0, recording.delay - farthest * deviation),
                       recording.delay + recording.delaySpan + farthest * deviation);
}
} // namespace

double loudnessOf (const ModalModel& model, const std::vector<Sensor>& sensors, const PlayedRecording& recording)
{
    const auto predicted = predictedWhilePlayed (model, sensors, recording);
    const auto latest = (recording.delay + recording.delaySpan) * recording.sampleRate;
    const auto samples =
        std::min (recording.signals.cols(), predicted.rows() + static_cast<Eigen::Index> (std::ceil (latest)));
    const Eigen::VectorXd heard = recording.signals.leftCols (samples).rowwise().norm();
    const Eigen::VectorXd ratios = heard.array() / predicted.colwise().norm().transpose().array().max (1e-300);
    return median ({ ratios.begin(), ratios.end() });
}

ModalModel meanModel (ModalModel model, const Eigen::VectorXd& frequencyDeviations)
{
    model.dampingRatios += frequencyDeviations;
    return model;
}

std::vector<double> delaysBy (const ModalModel& model, const std::vector<Sensor>& sensors,
                              const PlayedRecording& recording, std::size_t most)
{
    if (! (recording.delaySpan > 0))
        return { recording.delay };

    return likelyDelays (recording, predictedWhilePlayed (model, sensors, recording), most);
}

PlayedRecording withDelay (PlayedRecording recording, double delay)
{
    recording.delay = delay;
    recording.delaySpan = 0;
    return recording;
}

// From the most likely delay by a few steps: a microsecond is much for high modes.
double surprise (const LearntModes& device, const ModeSpread& deviations, const PlayedRecording& recording)
{
    constexpr int mostSteps = 3;
    auto delay = delaysBy (device.model, device.sensors, recording, 1).front();
    const std::vector<PlayedRecording> one { withDelay (recording, delay) };
    const auto prior = makePrior (device.model, device.sensors, deviations, one);
    LearningParameters delayOnly;
    delayOnly.delays = 1;
    const auto misfit = [&] (double by)
    {
        const auto sum =
            recordingMisfit (prior, stateOf (device, prior, delayOnly, by), 0, comparableSamples (one.front()));
        return std::sqrt (sum.residual / sum.samples);
    };
    auto least = misfit (delay);

    for (int i = 0; i < mostSteps; ++i)
    {
        const auto next = betterDelay (prior, delayOnly, stateOf (device, prior, delayOnly, delay), recording);
        const auto reached = misfit (next);

        if (! (reached < least))
            break;

        least = reached;
        delay = next;
    }

    return least;
}
} // namespace antinode
