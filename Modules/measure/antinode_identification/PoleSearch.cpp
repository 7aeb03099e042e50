#include "PoleSearch.h"

#include <antinode_base/InputError.h>
#include <antinode_numerics/ParallelFor.h>
#include <antinode_numerics/Statistics.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <optional>

namespace antinode
{
namespace
{
/** Poles belong together when they differ by less than this share of the half width, and of the frequency, and their
   participations by this MAC. Poles of noise are broad: shares of their widths would hold anything. */
constexpr double shareOfHalfWidth = 0.35, shareOfFrequency = 0.01, minimumAssurance = 0.8;

struct Candidate
{
    std::size_t order = 0;
    std::complex<double> pole;
    Eigen::VectorXcd participation;
    bool used = false;
};

double clusterRadius (std::complex<double> pole)
{
    return std::min (-shareOfHalfWidth * pole.real(), shareOfFrequency * pole.imag());
}

double distance (const Candidate& a, const Candidate& b)
{
    return std::abs (a.pole - b.pole) / std::min (clusterRadius (a.pole), clusterRadius (b.pole));
}

bool belongTogether (const Candidate& a, const Candidate& b)
{
    return distance (a, b) < 1 && std::norm (a.participation.dot (b.participation)) > minimumAssurance;
}

std::vector<Candidate> collectCandidates (const std::vector<OrderPoles>& orders)
{
    std::vector<Candidate> result;

    for (std::size_t n = 0; n < orders.size(); ++n)
        for (Eigen::Index k = 0; k < orders[n].poles.size(); ++k)
            result.push_back ({ n, orders[n].poles[k], orders[n].participation.row (k).transpose() });

    std::stable_sort (result.begin(), result.end(),
                      [] (const auto& a, const auto& b) { return a.pole.imag() < b.pole.imag(); });
    return result;
}

/** The nearest unused candidate of each order around one: what would be its cluster. */
std::vector<std::size_t> clusterAround (const std::vector<Candidate>& candidates, std::size_t centre,
                                        std::size_t orders)
{
    std::vector<std::size_t> nearest (orders, candidates.size());
    const auto& middle = candidates[centre];
    const auto reach = clusterRadius (middle.pole);
    const auto consider = [&] (std::size_t n)
    {
        const auto& candidate = candidates[n];
        auto& best = nearest[candidate.order];

        if (! candidate.used && belongTogether (candidate, middle)
            && (best == candidates.size() || distance (candidate, middle) < distance (candidates[best], middle)))
            best = n;
    };

    for (auto n = centre; n < candidates.size() && candidates[n].pole.imag() - middle.pole.imag() < reach; ++n)
        consider (n);

    for (auto n = centre; n-- > 0 && middle.pole.imag() - candidates[n].pole.imag() < reach;)
        consider (n);

    nearest.erase (std::remove (nearest.begin(), nearest.end(), candidates.size()), nearest.end());
    return nearest;
}

PoleCluster summary (const std::vector<Candidate>& candidates, const std::vector<std::size_t>& members,
                     std::size_t orders)
{
    std::vector<double> real, imaginary;

    for (const auto n : members)
    {
        real.push_back (candidates[n].pole.real());
        imaginary.push_back (candidates[n].pole.imag());
    }

    return { { median (real), median (imaginary) },
             static_cast<double> (members.size()) / static_cast<double> (orders) };
}
} // namespace

std::vector<PoleCluster> clusterPoles (const std::vector<OrderPoles>& orders, double presence)
{
    auto candidates = collectCandidates (orders);
    const auto minimum = std::max<std::size_t> (
        1, static_cast<std::size_t> (std::ceil (presence * static_cast<double> (orders.size()))));
    std::vector<PoleCluster> result;

    // The largest cluster first: what it takes can no more blur its neighbours.
    while (true)
    {
        std::vector<std::size_t> largest;

        for (std::size_t n = 0; n < candidates.size(); ++n)
            if (! candidates[n].used)
                if (auto members = clusterAround (candidates, n, orders.size()); members.size() > largest.size())
                    largest = std::move (members);

        if (largest.size() < minimum)
            break;

        for (const auto n : largest)
            candidates[n].used = true;

        result.push_back (summary (candidates, largest, orders.size()));
    }

    std::stable_sort (result.begin(), result.end(),
                      [] (const auto& a, const auto& b) { return a.pole.imag() < b.pole.imag(); });
    return result;
}

namespace
{
constexpr double bandRatio = 1.6, guardShare = 0.25;
constexpr double widest = 2 * std::numbers::pi * 2500; // rad/s
constexpr Eigen::Index fewestLines = 96;               // of a chosen band, where there are as many

SearchBand bandAround (const PreparedResponses& data, double minimum, double maximum)
{
    const auto* const begin = data.omega.data();
    const auto* const end = begin + data.lines();
    const auto guard = guardShare * (maximum - minimum);
    const auto first = std::lower_bound (begin, end, minimum - guard) - begin;
    const auto last = std::upper_bound (begin, end, maximum + guard) - begin;
    return { first, last - first, minimum, maximum };
}

std::vector<SearchBand> chosenBands (const PreparedResponses& data)
{
    const auto highest = data.omega[data.lines() - 1];
    std::vector<SearchBand> bands;

    for (auto lower = data.omega[0]; lower < highest;)
    {
        const auto* const line = std::lower_bound (data.omega.data(), data.omega.data() + data.lines(), lower);
        const auto enough = std::min<Eigen::Index> (line - data.omega.data() + fewestLines, data.lines() - 1);
        auto upper = std::max (std::min (bandRatio * lower, lower + widest), data.omega[enough]);

        // A remainder narrower than a third of a band is no band of its own.
        if (highest - upper < (upper - lower) / 3)
            upper = highest;

        bands.push_back (bandAround (data, lower, upper));
        lower = upper;
    }

    return bands;
}
} // namespace

std::vector<SearchBand> searchBands (const PreparedResponses& data, const std::vector<FrequencyBand>& wanted)
{
    if (wanted.empty())
        return chosenBands (data);

    std::vector<SearchBand> bands;

    for (const auto& [minimum, maximum] : wanted)
    {
        bands.push_back (bandAround (data, 2 * std::numbers::pi * minimum, 2 * std::numbers::pi * maximum));

        if (! (minimum < maximum) || bands.back().lines < 8)
            throw InputError ("band " + std::to_string (minimum) + " to " + std::to_string (maximum) + " Hz",
                              "contains fewer than 8 lines of the frequency responses; allowed: 8 or more");
    }

    return bands;
}

std::vector<SearchBand> splitBand (const PreparedResponses& data, const SearchBand& band)
{
    if (band.lines < 2 * fewestLines)
        return {};

    const auto middle = (band.minimum + band.maximum) / 2;
    return { bandAround (data, band.minimum, middle), bandAround (data, middle, band.maximum) };
}

namespace
{
constexpr Eigen::Index maximumOutputs = 24, maximumReferences = 8;
constexpr double minimumPresence = 0.4;
/** Where the user picks, also poles that are seen rarely are candidates. */
constexpr double presenceForPicks = 0.15;

double poleFrequency (std::complex<double> pole)
{
    return std::abs (pole) / (2 * std::numbers::pi);
}

/** Enough for all modes of a band and its noise: to 96 poles with many references, 18 to 72 with few. No more unknowns
    than the lines determine. */
int highestOrder (const CompressedBand& band, const IdentificationOptions& options)
{
    const auto affordable = std::max (1, static_cast<int> (band.lines() / 4));
    const auto chosen = band.references() > 4 ? 12 : 18;
    return std::min (options.maximumOrder > 0 ? options.maximumOrder : chosen, affordable);
}

struct BandPoles
{
    SearchBand band;
    std::vector<OrderPoles> orders;
    std::vector<PoleCluster> candidates;
};

bool isFrequent (const PoleCluster& cluster)
{
    return cluster.presence >= minimumPresence;
}

std::vector<PoleCluster> candidatesIn (const SearchBand& band, const PreparedResponses& data,
                                       const std::vector<OrderPoles>& orders, double presence)
{
    // A mode at the edge of two bands may seem to lie in either, or in none: somewhat beyond the edge it counts for
    // now.
    const auto isWithin = [&] (const PoleCluster& cluster)
    {
        const auto frequency = std::abs (cluster.pole), margin = -0.2 * cluster.pole.real();
        return frequency >= std::max (band.minimum - margin, data.omega[0])
               && frequency < std::min (band.maximum + margin, data.omega[data.lines() - 1]);
    };
    // A resonance wider than the band cannot be distinguished from modes outside of it.
    const auto isBroad = [&band] (const PoleCluster& cluster)
    {
        return -cluster.pole.real() > (band.maximum - band.minimum) / 2
               || cluster.pole.real() < -0.7 * std::abs (cluster.pole);
    };

    auto result = clusterPoles (orders, presence);
    std::erase_if (result, [&] (const auto& cluster) { return ! isWithin (cluster) || isBroad (cluster); });
    return result;
}

/** @return  nothing where the band is to be split: it holds so many modes that low orders cannot have them all. That
             is seen before the high orders, which cost most */
std::optional<BandPoles> searchBand (const PreparedResponses& data, const SearchBand& band, bool maySplit,
                                     const IdentificationOptions& options)
{
    constexpr std::ptrdiff_t maximumModes = 12;
    const auto compressed = compress (data, band.firstLine, band.lines, maximumOutputs, maximumReferences);
    const auto highest = highestOrder (compressed, options), lowest = std::min (options.minimumOrder, highest);
    const auto orders = static_cast<std::size_t> (highest - lowest) + 1;
    auto isDense = false;
    const auto looksDense = [&] (const std::vector<OrderPoles>& found)
    {
        // A pole that has been at 40 % of all orders stays frequent, whatever follows.
        if (! maySplit || found.size() < (orders + 1) / 2)
            return false;

        const auto presence = minimumPresence * static_cast<double> (orders) / static_cast<double> (found.size());
        isDense = static_cast<std::ptrdiff_t> (candidatesIn (band, data, found, presence).size()) > maximumModes;
        return isDense;
    };
    BandPoles result { band, polynomialPoles (compressed, lowest, highest, options.ridge, looksDense), {} };

    if (isDense || looksDense (result.orders))
        return {};

    result.candidates = candidatesIn (band, data, result.orders, presenceForPicks);
    return result;
}

/** In one piece, or in two where a chosen band holds too many modes. */
std::vector<BandPoles> searchDensely (const PreparedResponses& data, const SearchBand& band,
                                      const IdentificationOptions& options)
{
    const auto halves = options.bands.empty() ? splitBand (data, band) : std::vector<SearchBand>();
    std::vector<BandPoles> result;

    if (auto found = searchBand (data, band, ! halves.empty(), options))
    {
        result.push_back (std::move (*found));
        return result;
    }

    for (const auto& half : halves)
        for (auto& part : searchDensely (data, half, options))
            result.push_back (std::move (part));

    return result;
}

void append (std::vector<StabilisationPoint>& points, const BandPoles& found)
{
    const auto& band = found.band;

    for (const auto& order : found.orders)
        for (const auto pole : order.poles)
        {
            if (std::abs (pole) < band.minimum || std::abs (pole) >= band.maximum)
                continue;

            const auto isNear = [pole] (const PoleCluster& cluster)
            { return isFrequent (cluster) && std::abs (cluster.pole - pole) < -0.35 * cluster.pole.real(); };
            points.push_back ({ order.order, poleFrequency (pole), -pole.real() / std::abs (pole),
                                std::any_of (found.candidates.begin(), found.candidates.end(), isNear) });
        }
}

/** Of poles that two bands found at their common edge, those that were found at more orders. Ascending in frequency. */
std::vector<PoleCluster> withoutRepetitions (const std::vector<BandPoles>& ofBands)
{
    struct Entry
    {
        PoleCluster cluster;
        std::size_t band = 0;
    };
    std::vector<Entry> entries;

    for (std::size_t n = 0; n < ofBands.size(); ++n)
        for (const auto& cluster : ofBands[n].candidates)
            entries.push_back ({ cluster, n });

    std::stable_sort (entries.begin(), entries.end(),
                      [] (const auto& a, const auto& b)
                      { return std::abs (a.cluster.pole) < std::abs (b.cluster.pole); });
    std::vector<PoleCluster> result;

    for (const auto& entry : entries)
    {
        const auto isBetter = [&entry] (const Entry& other)
        {
            const auto reach = -0.35 * std::max (entry.cluster.pole.real(), other.cluster.pole.real());
            const auto isSame = other.band != entry.band && std::abs (other.cluster.pole - entry.cluster.pole) < reach;
            return isSame
                   && (other.cluster.presence > entry.cluster.presence
                       || (other.cluster.presence == entry.cluster.presence && other.band < entry.band));
        };

        if (std::none_of (entries.begin(), entries.end(), isBetter))
            result.push_back (entry.cluster);
    }

    return result;
}
} // namespace

FoundPoles searchPoles (const PreparedResponses& data, const IdentificationOptions& options)
{
    const auto bands = searchBands (data, options.bands);
    std::vector<std::vector<BandPoles>> ofChosen (bands.size());
    parallelFor (bands.size(), [&] (std::size_t n) { ofChosen[n] = searchDensely (data, bands[n], options); });
    std::vector<BandPoles> ofBands;

    for (auto& parts : ofChosen)
        std::move (parts.begin(), parts.end(), std::back_inserter (ofBands));

    FoundPoles result;

    for (const auto& found : ofBands)
        append (result.stabilisation, found);

    result.candidates = withoutRepetitions (ofBands);
    std::copy_if (result.candidates.begin(), result.candidates.end(), std::back_inserter (result.clusters),
                  &isFrequent);
    return result;
}
} // namespace antinode
