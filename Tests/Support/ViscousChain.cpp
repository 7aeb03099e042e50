#include "Support/ViscousChain.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <complex>
#include <iterator>
#include <set>
#include <string>
#include <vector>

namespace antinode::test
{
namespace
{
/** By Taylor's series of a small part of the matrix, squared. Eigen's own takes more than a minute to compile. */
Eigen::MatrixXd exponential (const Eigen::MatrixXd& matrix)
{
    constexpr int terms = 16; // 0.5^17 / 17! is 2e-20
    const auto norm = matrix.cwiseAbs().rowwise().sum().maxCoeff();
    const auto squarings = norm > 0 ? std::max (0, std::ilogb (norm) + 2) : 0;
    const Eigen::MatrixXd part = std::ldexp (1.0, -squarings) * matrix;
    Eigen::MatrixXd result = Eigen::MatrixXd::Identity (matrix.rows(), matrix.cols());
    Eigen::MatrixXd term = result;

    for (int k = 1; k <= terms; ++k)
    {
        term = term * part / k;
        result += term;
    }

    for (int k = 0; k < squarings; ++k)
        result = result * result;

    return result;
}
} // namespace

Eigen::MatrixXd ViscousChain::stateMatrix() const
{
    const auto n = size();
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero (2 * n, 2 * n);
    matrix.topRightCorner (n, n) = rate * Eigen::MatrixXd::Identity (n, n);
    matrix.bottomLeftCorner (n, n) = -mass.inverse() * stiffness / rate;
    matrix.bottomRightCorner (n, n) = -mass.inverse() * damping;
    return matrix;
}

Eigen::MatrixXd ViscousChain::inputMatrix() const
{
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero (2 * size(), forces.cols());
    matrix.bottomRows (size()) = mass.inverse() * forces;
    return matrix;
}

ViscousChain viscousChain (Eigen::Index size, Eigen::Index ceramics, double damper)
{
    constexpr double mass = 0.01, stiffness = 1.6e6, proportional = 8e-7;
    ViscousChain chain;
    chain.mass = Eigen::MatrixXd::Zero (size, size);
    chain.stiffness = Eigen::MatrixXd::Zero (size, size);
    chain.forces = Eigen::MatrixXd::Zero (size, ceramics);

    for (Eigen::Index i = 0; i < size; ++i)
    {
        chain.mass (i, i) = mass * (1 + 0.1 * std::sin (3.0 * static_cast<double> (i)));
        chain.stiffness (i, i) = 2 * stiffness;

        if (i > 0)
            chain.stiffness (i, i - 1) = chain.stiffness (i - 1, i) = -stiffness;

        for (Eigen::Index c = 0; c < ceramics; ++c)
            chain.forces (i, c) = 5e-3 * std::cos (1.7 * static_cast<double> ((c + 1) * (i + 1)));
    }

    chain.damping = proportional * chain.stiffness;
    chain.damping (1, 1) += damper;
    chain.damping (5, 5) += damper;
    chain.damping (6, 6) += damper;
    chain.damping (5, 6) -= damper;
    chain.damping (6, 5) -= damper;
    return chain;
}

ModalModel complexModel (const ViscousChain& chain)
{
    using namespace std::complex_literals;
    const auto n = chain.size();
    const Eigen::EigenSolver<Eigen::MatrixXd> solver (chain.stateMatrix());
    std::vector<Eigen::Index> order;

    for (Eigen::Index k = 0; k < 2 * n; ++k)
        if (solver.eigenvalues()[k].imag() > 0)
            order.push_back (k);

    std::sort (order.begin(), order.end(),
               [&] (auto a, auto b)
               { return std::abs (solver.eigenvalues()[a]) < std::abs (solver.eigenvalues()[b]); });
    ModalModel model;
    model.name = "chain";
    model.coversWholeBody = false;
    model.angularFrequencies.resize (n);
    model.dampingRatios.resize (n);
    model.shapes.resize (n, 2 * n);
    model.participation.resize (2 * n, chain.forces.cols());

    for (Eigen::Index k = 0; k < n; ++k)
    {
        const auto pole = solver.eigenvalues()[order[static_cast<std::size_t> (k)]];
        Eigen::VectorXcd shape = solver.eigenvectors().col (order[static_cast<std::size_t> (k)]).head (n);
        const Eigen::MatrixXcd slope = 2.0 * pole * chain.mass + chain.damping;
        shape *= std::sqrt (2i * pole.imag() / (shape.transpose() * slope * shape) (0, 0));
        const Eigen::RowVectorXcd participation = shape.transpose() * chain.forces;
        model.angularFrequencies[k] = std::abs (pole);
        model.dampingRatios[k] = -pole.real() / std::abs (pole);
        model.shapes.col (k) = shape.real();
        model.shapes.col (n + k) = shape.imag();
        model.participation.row (k) = participation.real();
        model.participation.row (n + k) = participation.imag();
    }

    auto& surface = model.surface;
    surface.points = Eigen::MatrixX2d::Zero (n, 2);
    surface.points.col (0) = Eigen::VectorXd::LinSpaced (n, 0, 0.01 * static_cast<double> (n - 1));
    surface.xMaximum = surface.points (n - 1, 0);
    surface.masses = chain.mass.diagonal();
    surface.areas = Eigen::VectorXd::Ones (n);

    for (Eigen::Index c = 0; c < chain.forces.cols(); ++c)
        model.ceramics.push_back ({ "C" + std::to_string (c + 1), 0, 0, 0, 0, 150, 0, 0, 0.02, 0 });

    model.fullScaleVoltage = 150;
    return withSplineSlopes (model);
}

Eigen::VectorXd chainMotion (const ViscousChain& chain, const VoltageProgram& program, double time)
{
    const auto n = 2 * chain.size();
    std::set<double> knots { time };

    for (const auto& oscillation : program.oscillations)
        for (const auto knot : { oscillation.start, oscillation.end })
            if (knot < time)
                knots.insert (knot);

    Eigen::VectorXd state = Eigen::VectorXd::Zero (n);

    for (auto next = std::next (knots.begin()); next != knots.end(); ++next)
    {
        const auto begin = *std::prev (next), end = *next;
        std::vector<Eigen::Index> playing;

        for (std::size_t c = 0; c < program.oscillations.size(); ++c)
            if (program.oscillations[c].start <= begin && program.oscillations[c].end >= end)
                playing.push_back (static_cast<Eigen::Index> (c));

        const auto size = n + 2 * static_cast<Eigen::Index> (playing.size());
        Eigen::MatrixXd generator = Eigen::MatrixXd::Zero (size, size);
        Eigen::VectorXd all = Eigen::VectorXd::Zero (size);
        generator.topLeftCorner (n, n) = chain.stateMatrix();
        all.head (n) = state;

        for (std::size_t i = 0; i < playing.size(); ++i)
        {
            const auto& oscillation = program.oscillations[static_cast<std::size_t> (playing[i])];
            const auto at = n + 2 * static_cast<Eigen::Index> (i);
            const auto p = oscillation.exponent();
            const auto value = oscillation.phasor() * std::exp (p * (begin - oscillation.start));
            generator.block (at, at, 2, 2) << p.real(), -p.imag(), p.imag(), p.real();
            generator.block (0, at, n, 1) = chain.inputMatrix() * program.allocation.col (playing[i]);
            all[at] = value.real();
            all[at + 1] = value.imag();
        }

        generator *= end - begin;
        state = (exponential (generator) * all).head (n);
    }

    state.head (chain.size()) /= ViscousChain::rate;
    return state;
}
} // namespace antinode::test
