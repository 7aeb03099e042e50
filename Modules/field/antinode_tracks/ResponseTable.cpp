#include "ResponseTable.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/DenseKernels.h>

#include <algorithm>
#include <complex>
#include <numbers>
#include <utility>

namespace antinode
{
namespace
{
using Complex = std::complex<double>;
using Lines = Eigen::ArrayXcd;

constexpr double farAbove = 2;     // times the highest frequency: beyond it modes are a series
constexpr Eigen::Index terms = 10; // of it: it converges as farAbove^-terms

/** 1 / (omega_k^2 + 2 xi_k omega_k s + s^2) in powers of s. */
Eigen::VectorXd powerSeries (double angularFrequency, double dampingRatio)
{
    const auto first = 2 * dampingRatio / angularFrequency, second = 1 / (angularFrequency * angularFrequency);
    Eigen::VectorXd coefficients (terms);
    coefficients[0] = second;
    coefficients[1] = -first * second;

    for (Eigen::Index n = 2; n < terms; ++n)
        coefficients[n] = -first * coefficients[n - 1] - second * coefficients[n - 2];

    return coefficients;
}

/** The lines of all pairs of a row (points, then loads) and an input (ceramics, then loads): column row + rows input.
 */
struct LoadedLines
{
    Eigen::MatrixXcd values;
    Eigen::Index points, actuators, loads;

    auto at (Eigen::Index row, Eigen::Index input) { return values.col (row + (points + loads) * input).array(); }
};

/** Sherman and Morrison's identity for one load, for what is needed after it. */
void addLoad (LoadedLines& lines, Eigen::Index load, const Lines& impedance)
{
    const auto row = lines.points + load, input = lines.actuators + load;
    const Lines factor = impedance / (1 + impedance * lines.at (row, input));
    const auto isNeeded = [&] (Eigen::Index index, Eigen::Index own, Eigen::Index first)
    { return index < first || index > own; };

    for (Eigen::Index i = 0; i < lines.actuators + lines.loads; ++i)
    {
        if (! isNeeded (i, input, lines.actuators))
            continue;

        const Lines force = factor * lines.at (row, i);

        for (Eigen::Index p = 0; p < lines.points + lines.loads; ++p)
            if (isNeeded (p, row, lines.points))
                lines.at (p, i) -= lines.at (p, input) * force;
    }
}
} // namespace

ResponseTable::ResponseTable (const ModalModel& model, Eigen::MatrixXd inputsToUse, double sampleRateToUse,
                              Eigen::Index lengthToUse, double highest)
    : inputs (std::move (inputsToUse)), sampleRate (sampleRateToUse), length (lengthToUse)
{
    requireRealModes (model, "waveforms at points");
    const auto spacing = 2 * std::numbers::pi * sampleRate / static_cast<double> (length); // rad/s
    const auto lines = std::min<Eigen::Index> (static_cast<Eigen::Index> (2 * std::numbers::pi * highest / spacing) + 1,
                                               length / 2 + 1);
    const auto& own = model.angularFrequencies;
    const auto resonances = (own.array() < farAbove * 2 * std::numbers::pi * highest).count();
    real.resize (lines, resonances + terms);
    imaginary.resize (lines, resonances + terms);

    for (Eigen::Index line = 0; line < lines; ++line)
    {
        checkWatch();
        const Complex s (0, spacing * static_cast<double> (line));
        Complex power = 1;

        for (Eigen::Index k = 0; k < resonances + terms; ++k)
        {
            const auto value =
                k < resonances ? 1.0 / (own[k] * own[k] + 2 * model.dampingRatios[k] * own[k] * s + s * s) : power;
            power *= k < resonances ? 1.0 : s;
            real (line, k) = value.real();
            imaginary (line, k) = value.imag();
        }
    }

    series.resize (terms, own.size() - resonances);

    for (Eigen::Index k = 0; k < series.cols(); ++k)
        series.col (k) = powerSeries (own[resonances + k], model.dampingRatios[resonances + k]);
}

/** How much of each resonance and of each power is in the motion of a row of shapes, per input. */
Eigen::MatrixXd ResponseTable::strengths (const Eigen::RowVectorXd& shapes, const Eigen::MatrixXd& allInputs) const
{
    const auto above = series.cols(), resonances = shapes.size() - above;
    Eigen::MatrixXd result (resonances + terms, allInputs.cols());
    result.topRows (resonances) = shapes.head (resonances).asDiagonal() * allInputs.topRows (resonances);
    result.bottomRows (terms).setZero();
    addProduct (result.bottomRows (terms), 1, series * shapes.tail (above).asDiagonal(), allInputs.bottomRows (above));
    return result;
}

PointResponses ResponseTable::responses (const Eigen::MatrixXd& pointShapes,
                                         const std::vector<SurfaceLoad>& loads) const
{
    LoadedLines lines { {}, pointShapes.rows(), inputs.cols(), static_cast<Eigen::Index> (loads.size()) };
    const auto rows = lines.points + lines.loads, columns = lines.actuators + lines.loads;
    Eigen::MatrixXd shapes (rows, inputs.rows()), allInputs (inputs.rows(), columns);
    shapes.topRows (lines.points) = pointShapes;
    allInputs.leftCols (lines.actuators) = inputs;

    for (Eigen::Index f = 0; f < lines.loads; ++f)
    {
        shapes.row (lines.points + f) = loads[static_cast<std::size_t> (f)].shapes;
        allInputs.col (lines.actuators + f) = loads[static_cast<std::size_t> (f)].shapes.transpose();
    }

    Eigen::MatrixXd all (real.cols(), rows * columns);

    for (Eigen::Index p = 0; p < rows; ++p)
        all (Eigen::all, Eigen::seqN (p, columns, rows)) = strengths (shapes.row (p), allInputs);

    Eigen::MatrixXd realPart = Eigen::MatrixXd::Zero (real.rows(), all.cols()), imaginaryPart = realPart;
    addProduct (realPart, 1, real, all);
    addProduct (imaginaryPart, 1, imaginary, all);
    lines.values.resize (real.rows(), all.cols());
    lines.values.real() = realPart;
    lines.values.imag() = imaginaryPart;
    const Eigen::ArrayXd omega = Eigen::ArrayXd::LinSpaced (real.rows(), 0, static_cast<double> (real.rows() - 1))
                                 * (2 * std::numbers::pi * sampleRate / static_cast<double> (length));

    for (Eigen::Index f = 0; f < lines.loads; ++f)
    {
        const auto& load = loads[static_cast<std::size_t> (f)];
        Lines impedance (omega.size());
        impedance.real() = load.stiffness - load.mass * omega.square();
        impedance.imag() = load.damping * omega;
        addLoad (lines, f, impedance);
    }

    PointResponses responses { lines.points, lines.actuators, length, sampleRate, {} };
    responses.values = Eigen::MatrixXcd::Zero (length / 2 + 1, lines.points * lines.actuators);

    for (Eigen::Index i = 0; i < lines.actuators; ++i)
        responses.values.block (0, lines.points * i, real.rows(), lines.points) =
            lines.values.middleCols (rows * i, lines.points);

    return responses;
}
} // namespace antinode
