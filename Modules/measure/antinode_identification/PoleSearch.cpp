#include "PoleSearch.h"

#include <antinode_numerics/ParallelFor.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>

namespace antinode
{
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
