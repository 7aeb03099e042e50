#pragma once

#include "Support/CircularPlates.h"

#include <antinode_outline/PathBuilder.h>
#include <antinode_structure/BendingModes.h>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

namespace antinode::examples
{
inline const EdgeSupport freeEdge {}, supportedEdge { true, false }, clampedEdge { true, true };

/** Reference values, with their sources. */
inline const nlohmann::json& outlineReferences()
{
    static const auto document =
        nlohmann::json::parse (std::ifstream (std::string (ANTINODE_TEST_DATA) + "/Structure/outlines.json"));
    return document;
}

inline BendingSection isotropicSection (double stiffness, double poissonRatio, double massPerArea)
{
    BendingSection section;
    section.stiffness << 1, poissonRatio, 0, poissonRatio, 1, 0, 0, 0, (1 - poissonRatio) / 2;
    section.stiffness *= stiffness;
    section.massPerArea = massPerArea;
    return section;
}

/** A plate with D = m = 1 and the same support on as many edges as there are. */
inline BendingProblem unitPlate (double poissonRatio, std::vector<ClosedPath> paths, std::vector<EdgeSupport> edges)
{
    BendingProblem problem;
    problem.section = isotropicSection (1, poissonRatio, 1);
    problem.outline.paths = std::move (paths);
    problem.edges = std::move (edges);
    return problem;
}

inline Eigen::VectorXd frequencies (const BendingModes& modes)
{
    return modes.eigenvalues.cwiseSqrt();
}

inline Eigen::VectorXd frequencies (const BendingProblem& problem, int count,
                                    ModeAccuracy accuracy = ModeAccuracy::usual)
{
    return frequencies (bendingModes (problem, count, resolutionFor (problem, count, accuracy)));
}

/** The largest relative deviation of the first frequencies from a list; those of rigid motions in it are left out. */
inline double deviationFrom (const Eigen::VectorXd& values, const std::vector<double>& expected)
{
    double largest = 0;
    Eigen::Index k = 0;

    for (const auto value : expected)
        if (value > 0)
            largest = std::max (largest, std::abs (values[k++] / value - 1));

    return largest;
}

inline double deviationFrom (const Eigen::VectorXd& values, const nlohmann::json& expected)
{
    return deviationFrom (values, expected.get<std::vector<double>>());
}

/** That from the modes of a circular plate. */
inline double deviationFrom (const Eigen::VectorXd& values, const tests::CircularPlate& plate)
{
    std::vector<double> expected;

    for (const auto& mode : tests::circularModes (plate, static_cast<int> (values.size())))
        expected.push_back (mode.angularFrequency);

    return deviationFrom (values, expected);
}
} // namespace antinode::examples
