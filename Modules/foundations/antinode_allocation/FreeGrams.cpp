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

void copyLower (Eigen::MatrixXd& to, const Eigen::MatrixXd& from)
{
    to.resizeLike (from);

    for (Eigen::Index k = 0; k < from.cols(); ++k)
        to.col (k).tail (from.rows() - k) = from.col (k).tail (from.rows() - k);
}

void clearLower (Eigen::MatrixXd& gram, Eigen::Index size)
{
    gram.resize (size, size);

    for (Eigen::Index k = 0; k < size; ++k)
        gram.col (k).tail (size - k).setZero();
}
} // namespace

void addWeightedLower (Eigen::MatrixXd& to, const Eigen::Ref<const Eigen::VectorXd>& p, const Eigen::MatrixXd& matrix)
{
    checkWatch();

    for (Eigen::Index k = 0; k < to.cols(); ++k)
    {
        const auto below = to.rows() - k;
        to.col (k).tail (below) += p[k] * p.tail (below).cwiseProduct (matrix.col (k).tail (below));
    }
}

FreeGrams::FreeGrams (const Eigen::MatrixXd& weightsToUse, const Eigen::MatrixXd& wholeGram, Eigen::Index ceramics,
                      std::size_t mostHeld)
    : weights (weightsToUse), whole (wholeGram), few (mostHeld), parts (static_cast<std::size_t> (ceramics))
{
    for (auto& part : parts)
        part.isFree.assign (static_cast<std::size_t> (weights.cols()), 1);
}

const Eigen::MatrixXd& FreeGrams::of (Eigen::Index ceramic) const
{
    const auto& part = parts[static_cast<std::size_t> (ceramic)];
    return part.isFew() ? whole : part.gram;
}

void FreeGrams::addWeighted (Eigen::MatrixXd& to, const Eigen::MatrixXd& participation) const
{
    addFew (to, participation);

    for (std::size_t i = 0; i < parts.size(); ++i)
        if (! parts[i].isFew())
            addWeightedLower (to, participation.col (static_cast<Eigen::Index> (i)), parts[i].gram);
}

/** The whole of those that hold few samples, less what these take from it. */
void FreeGrams::addFew (Eigen::MatrixXd& to, const Eigen::MatrixXd& participation) const
{
    std::vector<Eigen::Index> ceramics;
    Eigen::Index heldOfAll = 0;

    for (std::size_t i = 0; i < parts.size(); ++i)
        if (parts[i].isFew())
        {
            ceramics.push_back (static_cast<Eigen::Index> (i));
            heldOfAll += static_cast<Eigen::Index> (parts[i].held.size());
        }

    if (ceramics.empty())
        return;

    Eigen::MatrixXd shares = Eigen::MatrixXd::Zero (to.rows(), to.cols()), taken (to.rows(), heldOfAll);
    addGram (shares, 1, participation (Eigen::all, ceramics));
    to.triangularView<Eigen::Lower>() += shares.cwiseProduct (whole);
    Eigen::Index next = 0;

    for (const auto ceramic : ceramics)
        for (const auto sample : parts[static_cast<std::size_t> (ceramic)].held)
            taken.col (next++) = participation.col (ceramic).cwiseProduct (weights.col (sample));

    addGram (to, -1, taken);
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
    std::vector<Eigen::Index> freed, held, free, atLimit;

    for (Eigen::Index n = 0; n < pulls.cols(); ++n)
    {
        const auto isFree = std::abs (pulls (ceramic, n)) < caps (ceramic, n);
        auto& wasFree = part.isFree[static_cast<std::size_t> (n)];

        if (isFree != (wasFree != 0))
            (isFree ? freed : held).push_back (n);

        (isFree ? free : atLimit).push_back (n);
        wasFree = isFree ? 1 : 0;
    }

    if (atLimit.size() <= few)
    {
        part.gram.resize (0, 0);
        part.held = std::move (atLimit);
        return;
    }

    if (freed.empty() && held.empty())
        return;

    if (part.isFew() || std::min (free.size(), atLimit.size()) < freed.size() + held.size())
    {
        const auto isFewer = free.size() < atLimit.size();

        if (isFewer)
            clearLower (part.gram, whole.rows());
        else
            copyLower (part.gram, whole);

        freed = isFewer ? std::move (free) : std::vector<Eigen::Index> {};
        held = isFewer ? std::vector<Eigen::Index> {} : std::move (atLimit);
    }

    addGram (part.gram, 1, weights (Eigen::all, freed));
    addGram (part.gram, -1, weights (Eigen::all, held));
}
} // namespace antinode
