#include "Attempts.h"

#include "Causes.h"
#include "ChannelFilters.h"
#include "ChannelPhases.h"
#include "FitErrors.h"
#include "Identification.h"
#include "MeasuredQuantity.h"
#include "ModalRange.h"
#include "PointDrift.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>

#include <algorithm>

namespace antinode
{
namespace
{
struct Attempt
{
    IdentificationOptions options;
    IdentifiedModes modes;
    std::string said;             ///< What was changed and why, as a sentence; empty if nothing was.
    std::string contradiction {}; ///< What contradicts the quantity that was stated; empty if nothing does.
};

/** dB: above, a result does not stand alone, and above, its cause is sought. */
constexpr double poor = -15, doubtful = -20;
/** dB: above, nothing is known yet. */
constexpr double unknown = -10, nothing = -6;
/** Misfit up to this is noise. */
constexpr double likeNoise = 3;

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
   noise is amplified where a low-pass is removed. */
bool isWorthFiltering (const IdentifiedModes& modes, const IdentifiedModes& filtered)
{
    constexpr double worth = 0.8, same = 1.1;
    const auto becomeReal = modes.complexShapes.size() > 0 && filtered.complexShapes.size() == 0;
    return filtered.misfit < (becomeReal ? same : worth) * modes.misfit;
}

/** Whether less modes explain as much. */
bool isSimpler (const IdentifiedModes& one, const IdentifiedModes& other)
{
    constexpr double same = 1; // dB
    return one.modes() < other.modes() && one.measuredReconstructionError < other.measuredReconstructionError + same;
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

    /** Nothing makes a result better: it is good, or of another quantity than what was measured. */
    bool isDone() const { return best && (isGood (best->modes) || ! best->contradiction.empty()); }
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

        if (! best->contradiction.empty())
        {
            modes.warnings.insert (modes.warnings.begin(), best->contradiction);
            return modes;
        }

        if (modes.misfit < likeNoise)
            return modes;

        if (modes.reconstructionError > poor)
            modes.warnings.insert (modes.warnings.begin(), sayWhere (responses, modes));

        if (modes.reconstructionError > doubtful || seemsInverted (modes))
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

            auto contradiction = quantityContradiction (responses, options, modes);
            best = { options, std::move (modes), said, std::move (contradiction) };
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

/** "150 and 310 Hz" */
std::string inHertz (const std::vector<double>& frequencies)
{
    std::string text;

    for (std::size_t n = 0; n < frequencies.size(); ++n)
        text += (n == 0 ? "" : n + 1 < frequencies.size() ? ", " : " and ") + inWords (frequencies[n]);

    return text + " Hz";
}

std::string sayRange (const FrequencyBand& band, const FrequencyResponses& responses,
                      const IdentificationOptions& options)
{
    std::string text;

    if (band.minimum > responses.frequencies[0])
        text = "lines below " + inWords (band.minimum)
               + " Hz are left out: what they hold (drift, suspension) hides the modes; --band sets another range";

    if (band.maximum < responses.frequencies[responses.frequencies.size() - 1])
        text += std::string (text.empty() ? "" : "; ") + "lines above " + inWords (band.maximum)
                + " Hz are left out: they contain noise";

    if (const auto outside = resonancesOutside (band, responses, options); ! outside.empty())
        text += "; what is left out has resonances at " + inHertz (outside);

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

    const auto whole = options;

    for (const auto& candidate : candidateRanges (responses, whole))
    {
        options.minimumFrequency = candidate.minimum;
        options.maximumFrequency = candidate.maximum;
        inVain = attempts.tryRange (options, sayRange (candidate, responses, whole), gainOfRanges) ? 0 : inVain + 1;

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

    if (const auto drift = attempts.result() ? findPointDrift (responses, attempts.result()->modes) : std::nullopt)
    {
        Attempts straight (drift->responses, identifyWith);

        if (straight.tryRange (options, {}, 0) && isSimpler (straight.result()->modes, attempts.result()->modes))
        {
            auto modes = finishAttempts (straight, drift->responses, options);
            modes.warnings.insert (modes.warnings.begin(), drift->said);
            return modes;
        }
    }

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
