#include "PoleClusters.h"

#include <antinode_numerics/Median.h>

#include <algorithm>
#include <cmath>

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
} // namespace antinode
