#pragma once

#include "ImmersedSpace.h"

namespace antinode
{
/** The functions that live on a cell, at places of it. */
class CellFunctions
{
public:
    /** @param highest  derivative that is asked for, along one axis
        [worker] */
    CellFunctions (const ImmersedSpace&, const ImmersedCell&, const std::vector<Eigen::Vector2d>& places, int highest);

    const std::vector<Eigen::Index>& unknowns() const { return numbers; }

    /** places x functions: a derivative. [worker] */
    Eigen::MatrixXd derivative (int dx, int dy) const;

    /** The same, written into a matrix of that size. [worker] */
    void writeDerivative (int dx, int dy, Eigen::Ref<Eigen::MatrixXd> result) const;

private:
    /** An unknown as a product of splines, by their numbers on the cell, and of a kink's function. */
    struct Member
    {
        Eigen::Index ofX = 0, ofY = 0;
        const KinkFunction* kink = nullptr;
    };

    Eigen::VectorXd kinkDerivative (const KinkFunction&, int dx, int dy) const;

    std::vector<Eigen::Vector2d> places;
    std::vector<Eigen::MatrixXd> alongX, alongY; ///< Of each derivative: places x splines.
    std::vector<Member> members;
    std::vector<Eigen::Index> numbers;
};
} // namespace antinode
