#include "FreeGrams.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/DenseKernels.h>
#include <antinode_numerics/ParallelFor.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace antinode
{
namespace
{
constexpr auto worthThreads = 1e8; // products: some 10 ms of one core
}

FreeGrams::FreeGrams (const Eigen::MatrixXd& weightsToUse, const Eigen::MatrixXd& wholeGram, Eigen::Index ceramics)
    : weights (weightsToUse), whole (wholeGram), parts (static_cast<std::size_t> (ceramics))
{
    for (auto& part : parts)
        part.isFree.assign (static_cast<std::size_t> (weights.cols()), 1);
}

const Eigen::MatrixXd& FreeGrams::of (Eigen::Index ceramic) const
{
    const auto& part = parts[static_cast<std::size_t> (ceramic)];
    return part.gram.size() > 0 ? part.gram : whole;
}

void FreeGrams::follow (const Eigen::MatrixXd& pulls, const Eigen::MatrixXd& caps)
{
    const auto products = static_cast<double> (weights.rows()) * static_cast<double> (weights.rows())
                          * static_cast<double> (pulls.size());
    parallelFor (
        parts.size(), [&] (std::size_t i) { followOne (parts[i], pulls, caps, static_cast<Eigen::Index> (i)); },
        products > worthThreads ? processorThreads() : 1);
}

/** From what it was by the samples that changed; or from none, or from all, where that is less. */
void FreeGrams::followOne (Part& part, const Eigen::MatrixXd& pulls, const Eigen::MatrixXd& caps,
                           Eigen::Index ceramic) const
{
    checkWatch();
    std::vector<Eigen::Index> freed, held, free, others;

    for (Eigen::Index n = 0; n < pulls.cols(); ++n)
    {
        const auto isFree = std::abs (pulls (ceramic, n)) < caps (ceramic, n);
        auto& wasFree = part.isFree[static_cast<std::size_t> (n)];

        if (isFree != (wasFree != 0))
            (isFree ? freed : held).push_back (n);

        (isFree ? free : others).push_back (n);
        wasFree = isFree ? 1 : 0;
    }

    if (freed.empty() && held.empty())
        return;

    if (std::min (free.size(), others.size()) < freed.size() + held.size())
    {
        const auto isFewer = free.size() < others.size();
        part.gram = whole;

        if (isFewer)
            part.gram.setZero();

        freed = isFewer ? std::move (free) : std::vector<Eigen::Index> {};
        held = isFewer ? std::vector<Eigen::Index> {} : std::move (others);
    }
    else if (part.gram.size() == 0)
        part.gram = whole;

    addGram (part.gram, 1, weights (Eigen::all, freed));
    addGram (part.gram, -1, weights (Eigen::all, held));
}
} // namespace antinode
