#include "TrackWork.h"

#include "PointDistances.h"
#include "TouchedNodes.h"
#include "TrackMemory.h"
#include "WantedMotion.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>
#include <antinode_numerics/Decompositions.h>
#include <antinode_numerics/Fourier.h>
#include <antinode_numerics/KaiserSinc.h>
#include <antinode_numerics/Median.h>
#include <antinode_numerics/SampleInterpolation.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace antinode
{
namespace
{
constexpr double ratesPerBand = 6;    // the design's rate over the band's upper frequency, at least
constexpr double decayedTo = 0.01;    // of the slowest mode, before the transforms begin again
constexpr double longestDecay = 2;    // s of it at most: what rings then is quiet at all points
constexpr Eigen::Index mostFiner = 8; // times the design's rate, at which limits are kept sample by sample

double decayTime (const ModalModel& model, TrackBand band)
{
    const auto rates = decayRates (model);
    auto slowest = rates[0];

    for (Eigen::Index k = 0; k < model.modes() && model.frequencyHz (k) <= 2 * band.upper; ++k)
        slowest = std::min (slowest, rates[k]);

    return std::min (-std::log (decayedTo) / slowest, longestDecay);
}

/** Voltages reach kaiserSincHalfWidth samples beyond the window, which belong to the roll. */
Eigen::Index rollSamples (double roll, double rate)
{
    return std::max<Eigen::Index> (0, static_cast<Eigen::Index> (std::floor (roll * rate)) - kaiserSincHalfWidth);
}

TrackSpan trackSpan (const ModalModel& model, const WaveformsDescription& description, double sampleRate)
{
    const auto least = ratesPerBand * description.band.upper;

    if (! (sampleRate >= least))
        throw InputError ("sample rate", "is " + inWords (sampleRate) + " Hz; allowed for a band up to "
                                             + inWords (description.band.upper) + " Hz: " + inWords (least)
                                             + " Hz or more");

    TrackSpan span;
    span.factor = static_cast<Eigen::Index> (sampleRate / least);
    span.rate = sampleRate / static_cast<double> (span.factor);
    span.lead = rollSamples (description.preRoll, span.rate);
    span.wanted = static_cast<Eigen::Index> (std::ceil (tracksDuration (description) * span.rate)) + 1;
    span.window = span.lead + span.wanted + rollSamples (description.postRoll, span.rate);
    span.length = quickLength (static_cast<double> (span.window) + decayTime (model, description.band) * span.rate);
    return span;
}

/** The smallest singular values of the responses within the band, squared: from the trace of the inverse, of which it
   is the largest part. */
void addSmallest (std::vector<double>& squares, const PointResponses& responses, TrackBand band)
{
    const auto step = responses.sampleRate / static_cast<double> (responses.length);

    for (auto line = static_cast<Eigen::Index> (std::ceil (band.lower / step));
         line <= static_cast<Eigen::Index> (band.upper / step); ++line)
    {
        const auto response = responses.atLine (line);
        const Eigen::MatrixXcd gram = response * response.adjoint();
        const Eigen::MatrixXcd inverse =
            solveSemidefinite (gram, Eigen::MatrixXcd::Identity (gram.rows(), gram.cols()));
        squares.push_back (1 / inverse.real().trace());
    }
}

/** Peaks over their limits. */
double highest (const Eigen::VectorXd& limits, const Eigen::MatrixXd& played)
{
    return (played.cwiseAbs().colwise().maxCoeff().transpose().array() / limits.array()).maxCoeff();
}

/** Slew rates over their limits, 0: none. */
double steepest (const Eigen::VectorXd& slews, double sampleRate, const Eigen::MatrixXd& played)
{
    double times = 0;

    for (Eigen::Index i = 0; i < played.cols(); ++i)
        if (const auto last = played.rows() - 1; slews[i] > 0)
            times = std::max (times, (played.col (i).tail (last) - played.col (i).head (last)).cwiseAbs().maxCoeff()
                                         * sampleRate / slews[i]);

    return times;
}
} // namespace

double smallestResponse (const PointResponses& nodes, const MovingPoints& moving, TrackBand band)
{
    std::vector<double> squares;

    if (moving.points.empty())
        addSmallest (squares, nodes, band);

    for (const auto sample : moving.stages)
        addSmallest (squares, frozenResponses (nodes, moving, sample), band);

    return median (squares);
}

TrackWork trackWork (const ModalModel& model, const WaveformsDescription& description, const TrackSettings& settings)
{
    const auto span = trackSpan (model, description, settings.sampleRate);
    requirePlaces (model.surface, description);
    requireEnoughCeramics (model, description);
    requirePathMemory (model, description);
    const TouchedNodes nodes (model, description, span.rate);
    requireTrackMemory (trackBytes (model, description, span, nodes), static_cast<double> (span.wanted) / span.rate);
    requireDistinctPoints (model, description);
    auto moving = nodes.weights (span.rate, span.lead, span.length);
    auto responses = pointResponses (model, nodes.shapes(), touchedLoads (model, description), span.rate, span.length);
    const auto compliance =
        settings.regularisation * settings.regularisation * smallestResponse (responses, moving, description.band);
    TrackWork work { span,
                     WindowedResponses (std::move (responses), span.window, compliance, std::move (moving)),
                     {},
                     voltageLimits (model),
                     slewLimits (model),
                     settings.sampleRate };
    work.wanted = Eigen::MatrixXd::Zero (span.length, work.responses.points());
    work.wanted.middleRows (span.lead, span.wanted) = wantedMotion (description, settings.threshold, span.rate);
    return work;
}

Eigen::MatrixXd wantedAsPlayed (const ModalModel& model, const WaveformsDescription& description,
                                const TrackSettings& settings)
{
    const auto span = trackSpan (model, description, settings.sampleRate);
    return interpolated (wantedMotion (description, settings.threshold, span.rate), span.factor)
        .middleRows (kaiserSincHalfWidth * span.factor, (span.wanted - 1) * span.factor + 1);
}

std::optional<TrackWork> finerWork (const ModalModel& model, const WaveformsDescription& description,
                                    const TrackWork& coarse)
{
    Eigen::Index factor = std::min (mostFiner, coarse.span.factor);

    while (coarse.span.factor % factor != 0)
        --factor;

    auto span = coarse.span;
    span.factor /= factor;
    span.rate *= static_cast<double> (factor);
    span.lead *= factor;
    span.wanted = (span.wanted - 1) * factor + 1;
    span.window = (span.window - 1) * factor + 1;
    span.length *= factor;
    const TouchedNodes nodes (model, description, span.rate);

    if (! isWithinMemory (trackBytes (model, description, span, nodes)))
        return {};

    auto moving = nodes.weights (span.rate, span.lead, span.length);
    auto responses = pointResponses (model, nodes.shapes(), touchedLoads (model, description), span.rate, span.length);
    return TrackWork { span,
                       WindowedResponses (std::move (responses), span.window, coarse.responses.compliance(),
                                          std::move (moving)),
                       finer (coarse.wanted, factor),
                       coarse.limits,
                       coarse.slews,
                       coarse.sampleRate };
}

Eigen::MatrixXd finer (const Eigen::MatrixXd& signals, Eigen::Index factor)
{
    const auto length = signals.rows();
    Eigen::MatrixXd result (length * factor, signals.cols());

    for (Eigen::Index i = 0; i < signals.cols(); ++i)
    {
        const auto lines = forwardFourier (signals.col (i));
        Eigen::VectorXcd more = Eigen::VectorXcd::Zero (result.rows() / 2 + 1);
        more.head (lines.size()) = lines;
        more[lines.size() - 1] /= factor > 1 ? 2 : 1; // the Nyquist line stands for two
        result.col (i) = static_cast<double> (factor) * inverseFourier (more, result.rows());
    }

    return result;
}

bool isSteep (const TrackWork& work, const Eigen::MatrixXd& played)
{
    return steepest (work.slews, work.sampleRate, played) > highest (work.limits, played);
}

double timesLimits (const TrackWork& work, const Eigen::MatrixXd& played)
{
    return std::max (highest (work.limits, played), steepest (work.slews, work.sampleRate, played));
}

double timesLimits (const ModalModel& model, double sampleRate, const Eigen::MatrixXd& played)
{
    return std::max (highest (voltageLimits (model), played), steepest (slewLimits (model), sampleRate, played));
}
} // namespace antinode
