#pragma once

#include <antinode_model/ModalModel.h>
#include <antinode_model/VoltageProgram.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace antinode::test
{
/** Numbers between -1 and 1 that are the same everywhere. */
class Draws
{
public:
    explicit Draws (unsigned seed) : generator (seed) {}

    double next() { return static_cast<double> (generator()) / 2147483647.5 - 1; }

    Eigen::MatrixXd matrix (Eigen::Index rows, Eigen::Index columns)
    {
        return Eigen::MatrixXd::NullaryExpr (rows, columns, [this] { return next(); });
    }

private:
    std::mt19937 generator;
};

/** Modes by frequency in Hz and quality factor, with participation N_m x N_b. All that the plate model needs. */
inline ModalModel modelWithModes (const std::vector<double>& frequencies, double qualityFactor,
                                  Eigen::MatrixXd participation)
{
    ModalModel model;
    model.name = "test";
    model.angularFrequencies =
        2 * std::numbers::pi
        * Eigen::Map<const Eigen::VectorXd> (frequencies.data(), static_cast<Eigen::Index> (frequencies.size()));
    model.dampingRatios = Eigen::VectorXd::Constant (model.modes(), 0.5 / qualityFactor);
    model.participation = std::move (participation);
    return model;
}

/** 34 modes to 31 kHz as bending modes lie (frequency ~ order squared), Q 60, 8 ceramics: the size of the demonstrator.
 */
inline ModalModel manyModes()
{
    std::vector<double> frequencies (34);
    for (std::size_t k = 0; k < frequencies.size(); ++k)
    {
        const auto order = static_cast<double> (k) + 1.5;
        frequencies[k] = 31e3 * order * order / (34.5 * 34.5);
    }
    return modelWithModes (frequencies, 60, Draws (1).matrix (34, 8));
}

/** A program for manyModes: every mode driven for up to 20 ms, growing by e^4 to a focus that lies between two samples
   of any usual rate; then a brake of 3 ms. Up to about 3 V. */
inline VoltageProgram manyOscillations()
{
    const auto model = manyModes();
    Draws draws (2);
    VoltageProgram program;
    program.focusTime = 0.0200037;
    for (int k = 0; k < 34; ++k)
    {
        const auto b = model.angularFrequencies[k];
        const auto cycles = std::floor ((0.02 * b - std::numbers::pi / 2) / (2 * std::numbers::pi));
        const auto time = (std::numbers::pi / 2 + 2 * std::numbers::pi * cycles) / b;
        program.oscillations.push_back (
            { k, program.focusTime - time, program.focusTime, 200, b, std::exp (-4), 0.1 * draws.next() });
        program.oscillations.push_back (
            { k, program.focusTime, program.focusTime + 0.003, -900, b, draws.next(), draws.next() });
    }
    program.allocation = 0.1 * draws.matrix (8, 68);
    program.voltageLimits = Eigen::VectorXd::Constant (8, 50);
    return program;
}

/** Whether two matrices are the same to the bit. */
inline bool sameBits (const Eigen::MatrixXd& one, const Eigen::MatrixXd& other)
{
    return one.rows() == other.rows() && one.cols() == other.cols() && (one.array() == other.array()).all();
}

inline const std::vector<int> blockSizes { 1, 7, 64, 512, 8193 };
inline const std::vector<double> usualRates { 8e3, 44.1e3, 48e3, 96e3, 192e3, 384e3, 768e3 };
} // namespace antinode::test
