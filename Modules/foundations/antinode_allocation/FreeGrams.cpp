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

namespace
{
constexpr auto worthSharing = 1e8; // products: some 10 ms of one core
}

OwnRows::OwnRows (const Eigen::MatrixXd& spreadToUse, const Eigen::MatrixXd& participationToUse)
    : spread (spreadToUse), participation (participationToUse), parts (static_cast<std::size_t> (spreadToUse.cols()))
{
    for (Eigen::Index i = 0; i < spread.cols(); ++i)
        for (Eigen::Index k = 0; k < spread.rows(); ++k)
            if (spread (k, i) > 0)
                parts[static_cast<std::size_t> (i)].rows.push_back (k);
}

std::vector<Eigen::MatrixXd> OwnRows::eliminate (const FreeGrams& grams)
{
    std::vector<Eigen::MatrixXd> left (parts.size());
    double products = 0;

    for (const auto& part : parts)
        products += static_cast<double> (part.rows.size()) * static_cast<double> (spread.rows() * spread.rows());

    parallelFor (
        parts.size(),
        [&] (std::size_t i)
        {
            const auto ceramic = static_cast<Eigen::Index> (i);
            left[i] = eliminateOne (parts[i], grams.of (ceramic), ceramic);
        },
        products > worthSharing ? processorThreads() : 1);
    return left;
}

Eigen::MatrixXd OwnRows::eliminateOne (Part& part, const Eigen::MatrixXd& gram, Eigen::Index ceramic) const
{
    checkWatch();
    const Eigen::VectorXd sizes = spread.col (ceramic) (part.rows);
    part.coupling.resize (sizes.size(), gram.rows());

    for (Eigen::Index a = 0; a < sizes.size(); ++a)
    {
        const auto k = part.rows[static_cast<std::size_t> (a)];
        part.coupling.row (a).head (k) = sizes[a] * gram.row (k).head (k);
        part.coupling.row (a).tail (gram.rows() - k) = sizes[a] * gram.col (k).tail (gram.rows() - k).transpose();
    }

    part.factor = part.coupling (Eigen::all, part.rows) * sizes.asDiagonal();
    part.factor.diagonal().array() += 1;
    factorLower (part.factor);
    solveLower (part.factor, part.coupling);
    Eigen::MatrixXd left = gram;
    addGram (left, -1, part.coupling.transpose());
    return left;
}

Eigen::VectorXd OwnRows::takenBySlope (const Eigen::MatrixXd& slope) const
{
    Eigen::VectorXd taken = Eigen::VectorXd::Zero (spread.rows());

    for (std::size_t i = 0; i < parts.size(); ++i)
    {
        const auto& part = parts[i];
        const auto ceramic = static_cast<Eigen::Index> (i);
        Eigen::MatrixXd own = slope.col (ceramic) (part.rows);
        solveLower (part.factor, own);
        taken += participation.col (ceramic).cwiseProduct (part.coupling.transpose() * own.col (0));
    }

    return taken;
}

Eigen::MatrixXd OwnRows::steps (const Eigen::MatrixXd& slope, const Eigen::VectorXd& step) const
{
    Eigen::MatrixXd steps = Eigen::MatrixXd::Zero (slope.rows(), slope.cols());

    for (std::size_t i = 0; i < parts.size(); ++i)
    {
        const auto& part = parts[i];
        const auto ceramic = static_cast<Eigen::Index> (i);
        Eigen::MatrixXd own = slope.col (ceramic) (part.rows);
        solveLower (part.factor, own);
        own -= part.coupling * participation.col (ceramic).cwiseProduct (step);
        solveLowerTransposed (part.factor, own);

        for (std::size_t a = 0; a < part.rows.size(); ++a)
            steps (part.rows[a], ceramic) = own (static_cast<Eigen::Index> (a), 0);
    }

    return steps;
}
} // namespace antinode
