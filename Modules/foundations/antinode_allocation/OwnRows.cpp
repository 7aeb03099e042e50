#include "OwnRows.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/DenseKernels.h>
#include <antinode_numerics/ParallelFor.h>

#include <cstddef>

namespace antinode
{
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
