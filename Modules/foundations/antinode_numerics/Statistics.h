#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <random>
#include <vector>

namespace antinode
{
/** The median, of an even number of values the upper of the two in the middle.
    @param values  at least one, all finite
    [worker] */
double median (std::vector<double> values);

/** Numbers that look random and are the same on every computer: the standard's distributions are not. */
class RandomNumbers
{
public:
    explicit RandomNumbers (std::uint64_t seed) : engine (seed) {}

    /** Evenly distributed, at least 0 and less than 1. [any] */
    double uniform();

    /** A number of values of the normal distribution with mean 0 and deviation 1, by Box and Muller. [worker] */
    Eigen::VectorXd normal (Eigen::Index count);

    /** Leaves out what normal() would give for so many calls with a count: what follows is the same. [worker] */
    void skipNormal (Eigen::Index count, Eigen::Index calls);

private:
    std::mt19937_64 engine;
};
} // namespace antinode
