#include "Attempts.h"

#include "Causes.h"
#include "ChannelFilters.h"
#include "ChannelPhases.h"
#include "ModalRange.h"
#include "PointSample.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>
#include <antinode_base/Watch.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace antinode
{
namespace
{
struct Attempt
{
    IdentificationOptions options;
    IdentifiedModes modes;
    std::string said; ///< What was changed and why, as a sentence; empty if nothing was.
};

/** dB: above, a result does not stand alone, and above, its cause is sought. */
constexpr double poor = -15, doubtful = -20;
/** dB: above, nothing is known yet. */
constexpr double unknown = -10, nothing = -6;
/** Misfit up to this is noise. */
constexpr double likeNoise = 3;

double decibels (double ratio)
{
    return 10 * std::log10 (std::max (ratio, 1e-30));
}

/** dB, the larger of velocities and of what was measured. */
double ownError (const IdentifiedModes& modes)
{
    return std::max (modes.reconstructionError, modes.measuredReconstructionError);
}

/** What is left is noise, or little. */
bool isGood (const IdentifiedModes& modes)
{
    constexpr double notAll = -8, little = -30;
    return ownError (modes) < (modes.misfit < likeNoise ? notAll : little);
}

constexpr Eigen::Index spans = 24;

/** Energies of velocities and of what synthesis leaves of them, by spans of lines and by channels: spans x C. */
struct ErrorMap
{
    Eigen::VectorXd edges; ///< Hz, spans + 1.
    Eigen::ArrayXXd errors, energies;
};

ErrorMap errorMap (const FrequencyResponses& responses, const IdentifiedModes& modes, const FrequencyBand& band)
{
    const auto* const begin = responses.frequencies.data();
    const auto* const end = begin + responses.frequencies.size();
    const auto first = std::lower_bound (begin, end, band.minimum) - begin;
    const auto count = std::upper_bound (begin, end, band.maximum) - begin - first;
    const auto points = responses.points.rows();
    ErrorMap map { Eigen::VectorXd (spans + 1),
                   Eigen::ArrayXXd::Zero (spans, points * static_cast<Eigen::Index> (responses.values.size())),
                   {} };
    map.energies = map.errors;
    map.edges[spans] = responses.frequencies[first + count - 1];

    for (Eigen::Index s = 0; s < spans; ++s)
    {
        checkWatch();
        const auto from = first + s * count / spans, lines = first + (s + 1) * count / spans - from;
        map.edges[s] = responses.frequencies[from];

        const auto given = synthesise (modes, responses.frequencies.segment (from, lines));

        for (std::size_t i = 0; i < responses.values.size(); ++i)
            for (Eigen::Index p = 0; p < points; ++p)
                for (Eigen::Index f = 0; f < lines; ++f)
                {
                    const auto measured = responses.values[i](from + f, p);
                    const auto column = static_cast<Eigen::Index> (i) * points + p;

                    if (const auto error = std::norm (measured - given.values[i](f, p)); std::isfinite (error))
                    {
                        map.errors (s, column) += error;
                        map.energies (s, column) += std::norm (measured);
                    }
                }
    }

    return map;
}

/** Two dB figures of the error between two frequencies added: that of the energy as it is, and that of spans of lines
   which count alike, however weak they are. The lower the better. */
double errorBetween (const FrequencyResponses& responses, const IdentifiedModes& modes, const FrequencyBand& band)
{
    const auto map = errorMap (responses, modes, band);
    const Eigen::ArrayXd errors = map.errors.rowwise().sum(), energies = map.energies.rowwise().sum();
    return decibels (errors.sum() / energies.sum()) + decibels ((errors / energies.max (1e-300)).min (1).mean());
}

/** Where most of the error lies, and what may help, as a sentence. */
std::string sayWhere (const FrequencyResponses& responses, const IdentifiedModes& modes)
{
    const auto map = errorMap (responses, modes, { modes.minimumFrequency, modes.maximumFrequency });
    const Eigen::ArrayXd bySpan = map.errors.rowwise().sum(), byColumn = map.errors.colwise().sum().transpose();
    Eigen::Index span = 0, column = 0;
    bySpan.maxCoeff (&span);
    byColumn.maxCoeff (&column);
    const auto share = [] (double part, double all)
    { return fixedText (100 * part / std::max (all, 1e-300), 0) + " %"; };
    auto text = share (bySpan[span], bySpan.sum()) + " of the error lies from " + fixedText (map.edges[span], 0)
                + " to " + fixedText (map.edges[span + 1], 0) + " Hz";

    if (byColumn.size() > 1)
        text += ", " + share (byColumn[column], byColumn.sum()) + " of it at point "
                + std::to_string (column % responses.points.rows() + 1) + ", driver "
                + responses.references[static_cast<std::size_t> (column / responses.points.rows())].name;

    return text
           + "; other ranges and orders were tried: check quantity, sign and sensors, then --band, --orders and "
             "--complex";
}

/** Where both identified. */
FrequencyBand commonBand (const IdentifiedModes& one, const IdentifiedModes& other)
{
    return { std::max (one.minimumFrequency, other.minimumFrequency) * (1 - 1e-9),
             std::min (one.maximumFrequency, other.maximumFrequency) * (1 + 1e-9) };
}

/** Low-passes that may be why real modes leave more than noise, or seem complex. */
std::optional<ChannelFilters> suspectedFilters (const FrequencyResponses& responses, const Attempt& attempt)
{
    constexpr double muchMisfit = 1.5;
    const auto isComplex = attempt.modes.complexShapes.size() > 0;

    if (attempt.options.complexModes.value_or (false) || (! isComplex && attempt.modes.misfit < muchMisfit))
        return {};

    return findChannelFilters (responses, attempt.modes);
}

/** Whether modes of responses without these low-passes are better, or real and as good: by misfit over noise, since
   noise is amplified where a low-pass is taken off. */
bool isWorthFiltering (const IdentifiedModes& modes, const IdentifiedModes& filtered)
{
    constexpr double worth = 0.8, same = 1.1;
    const auto becomeReal = modes.complexShapes.size() > 0 && filtered.complexShapes.size() == 0;
    return filtered.misfit < (becomeReal ? same : worth) * modes.misfit;
}

class Attempts
{
public:
    /** @param result  known already, of these responses or of more points */
    Attempts (const FrequencyResponses& measured, const Identify& function, std::optional<Attempt> result = {})
        : responses (measured), identifyWith (function), best (std::move (result))
    {
    }

    /** Tries, and keeps a result of another range whose own error is lower by so many dB. @return whether it is */
    bool tryRange (const IdentificationOptions& options, const std::string& said, double by)
    {
        const auto isLower = [by] (const IdentifiedModes& one, const IdentifiedModes& other)
        { return one.reconstructionError < other.reconstructionError - by; };
        return attempt (options, said, isLower);
    }

    /** Tries, and keeps a result of the same range, or of one within, that is better by so many dB in both figures. */
    void tryOrders (const IdentificationOptions& options, const std::string& said, double by)
    {
        const auto isLower = [this, by] (const IdentifiedModes& one, const IdentifiedModes& other)
        {
            const auto band = commonBand (one, other);
            return errorBetween (responses, one, band) < errorBetween (responses, other, band) - by;
        };
        attempt (options, said, isLower);
    }

    bool isDone() const { return best && isGood (best->modes); }
    bool isUsable() const { return best && best->modes.reconstructionError < doubtful; }
    bool isFair() const { return best && best->modes.reconstructionError < unknown; }
    const std::optional<Attempt>& result() const { return best; }
    const Identify& identification() const { return identifyWith; }

    IdentifiedModes finish() const
    {
        // Where the first attempt found nothing, what describes next to nothing is no result either.
        if (! best || (failure && best->modes.reconstructionError > nothing))
            throw InputError (*failure);

        auto modes = best->modes;

        if (! best->said.empty())
            modes.warnings.insert (modes.warnings.begin(), best->said);

        if (modes.misfit < likeNoise)
            return modes;

        if (modes.reconstructionError > poor)
            modes.warnings.insert (modes.warnings.begin(), sayWhere (responses, modes));

        // Modes that move more than all that was measured, residual terms against them, are of another quantity.
        if (modes.reconstructionError > doubtful || modes.modalReconstructionError > 0 || seemsInverted (modes))
            if (const auto cause = likelyCause (responses, best->options, modes, identifyWith); ! cause.empty())
                modes.warnings.insert (modes.warnings.begin(), cause);

        return modes;
    }

private:
    template <typename IsBetter>
    bool attempt (const IdentificationOptions& options, const std::string& said, const IsBetter& isBetter)
    {
        try
        {
            auto modes = identifyWith (responses, options);

            if (best && ! isBetter (modes, best->modes))
                return false;

            best = { options, std::move (modes), said };
            return true;
        }
        catch (const InputError& error)
        {
            if (! failure)
                failure = error;

            return false;
        }
    }

    /** Whether a channel contradicts the others, which costs it its weight and hardly shows in the error. */
    bool seemsInverted (const IdentifiedModes& modes) const
    {
        constexpr double little = -30; // dB
        return modes.reconstructionError > little && responses.references.size() > 1 && responses.points.rows() > 2
               && channelAgreements (channelResidues (responses, modes), responses.points.rows()).minCoeff()
                      < oppositeAgreement;
    }

    const FrequencyResponses& responses;
    const Identify& identifyWith;
    std::optional<Attempt> best;
    std::optional<InputError> failure;
};

std::string sayRange (const FrequencyBand& band, const FrequencyResponses& responses)
{
    std::string text;

    if (band.minimum > responses.frequencies[0])
        text = "lines below " + fixedText (band.minimum, 1)
               + " Hz are left out: what they hold (drift, suspension) hides the modes; --band sets another range";

    if (band.maximum < responses.frequencies[responses.frequencies.size() - 1])
        text += std::string (text.empty() ? "" : "; ") + "lines above " + fixedText (band.maximum, 1)
                + " Hz are left out: they hold noise";

    return text;
}

/** Few responses need higher orders for as many modes; 0 where there are many. */
int highOrder (const FrequencyResponses& responses)
{
    constexpr Eigen::Index poles = 144;
    constexpr int least = 24, most = 48;
    const auto columns = std::max (responses.points.rows(), static_cast<Eigen::Index> (responses.references.size()));
    const auto order = static_cast<int> (poles / columns);
    return order < least ? 0 : std::min (order, most);
}

IdentificationOptions withOrders (IdentificationOptions options, int highest)
{
    options.minimumOrder = std::max (options.minimumOrder, highest / 5);
    options.maximumOrder = highest;
    return options;
}

bool hasOwnRange (const IdentificationOptions& options)
{
    const IdentificationOptions standard;
    return ! options.bands.empty() || options.minimumFrequency > standard.minimumFrequency
           || options.maximumFrequency < standard.maximumFrequency;
}

constexpr double gainOfRanges = 3; // dB

/** From below, until one is usable or two in a row have gained nothing on something that is. */
void tryRanges (Attempts& attempts, const FrequencyResponses& responses, IdentificationOptions options)
{
    constexpr int enough = 2;
    auto inVain = 0;

    for (const auto& candidate : candidateRanges (responses, options))
    {
        options.minimumFrequency = candidate.minimum;
        options.maximumFrequency = candidate.maximum;
        inVain = attempts.tryRange (options, sayRange (candidate, responses), gainOfRanges) ? 0 : inVain + 1;

        if (attempts.isUsable() || (inVain >= enough && attempts.isFair()))
            break;
    }
}

/** Of many points a few choose the range; all of them are fitted in that one alone. */
void chooseRange (Attempts& attempts, const FrequencyResponses& responses, IdentificationOptions options)
{
    const auto points = samplePoints (responses);

    if (static_cast<Eigen::Index> (points.size()) == responses.points.rows())
        return tryRanges (attempts, responses, std::move (options));

    const auto sample = atPoints (responses, points);
    Attempts trials (sample, attempts.identification(), attempts.result());
    tryRanges (trials, sample, atPoints (options, points));

    if (const auto& found = trials.result(); found && ! found->said.empty())
    {
        options.minimumFrequency = found->options.minimumFrequency;
        options.maximumFrequency = found->options.maximumFrequency;
        attempts.tryRange (options, found->said, gainOfRanges);
    }
}

/** What follows a first attempt. */
IdentifiedModes finishAttempts (Attempts attempts, const FrequencyResponses& responses,
                                const IdentificationOptions& options)
{
    constexpr double gainOfOrders = 2; // dB
    constexpr int highForRanges = 36;  // so few responses show hardly anything with less

    if (attempts.isDone() || ! options.selected.empty())
        return attempts.finish();

    const auto high = options.maximumOrder == 0 ? highOrder (responses) : 0;

    if (! hasOwnRange (options))
        chooseRange (attempts, responses, high >= highForRanges ? withOrders (options, high) : options);

    if (! attempts.isDone() && high > 0)
    {
        const auto said = attempts.result() ? attempts.result()->said : std::string();
        attempts.tryOrders (withOrders (attempts.result() ? attempts.result()->options : options, high), said,
                            gainOfOrders);
    }

    return attempts.finish();
}
} // namespace

IdentifiedModes bestOfAttempts (const FrequencyResponses& responses, const IdentificationOptions& options,
                                const Identify& identifyWith)
{
    Attempts attempts (responses, identifyWith);
    attempts.tryRange (options, {}, 0);

    // Before ranges: phases of channels are no reason to leave lines out.
    if (const auto filters = attempts.result() ? suspectedFilters (responses, *attempts.result()) : std::nullopt)
    {
        const auto before = withoutLowPasses (responses, filters->timeConstants);
        Attempts filtered (before, identifyWith);

        if (filtered.tryRange (options, {}, 0) && isWorthFiltering (attempts.result()->modes, filtered.result()->modes))
        {
            auto modes = finishAttempts (filtered, before, options);
            modes.lowPasses = filters->timeConstants;
            modes.warnings.insert (modes.warnings.begin(), filters->said);
            return modes;
        }
    }

    return finishAttempts (attempts, responses, options);
}
} // namespace antinode
