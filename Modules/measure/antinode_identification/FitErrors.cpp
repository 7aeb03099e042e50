#include "FitErrors.h"

#include "LineSegment.h"

#include <antinode_numerics/DenseKernels.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
/** What the coefficients give on the lines of a segment; of functions that are 0 nothing is
    computed. */
DataBlock synthesised (const LineSegment& segment, const Eigen::MatrixXd& coefficients, Eigen::Index lines)
{
    const auto columns = coefficients.cols();
    DataBlock result { Eigen::MatrixXd::Zero (lines, columns), Eigen::MatrixXd::Zero (lines, columns) };
    const Eigen::MatrixXd near = coefficients (segment.near, Eigen::all);
    addProduct (result.real, 1, segment.nearReal, near);
    addProduct (result.imaginary, 1, segment.nearImaginary, near);

    if (! segment.far.empty())
    {
        const Eigen::MatrixXd far = coefficients (segment.far, Eigen::all);
        Eigen::MatrixXd atNodes = Eigen::MatrixXd::Zero (segment.farReal.rows(), columns);
        addProduct (atNodes, 1, segment.farReal, far);
        addProduct (result.real, 1, segment.interpolation, atNodes);
        atNodes.setZero();
        addProduct (atNodes, 1, segment.farImaginary, far);
        addProduct (result.imaginary, 1, segment.interpolation, atNodes);
    }

    return result;
}

void fillMissing (PreparedResponses& data, Eigen::Index first, Eigen::Index count, double delay, const DataBlock& given)
{
    for (auto& value : data.missing)
        if (value.line >= first && value.line < first + count)
        {
            const auto line = value.line - first;
            value.value = std::complex (given.real (line, value.column), given.imaginary (line, value.column))
                          * std::polar (1.0, -data.omega[value.line] * delay);
        }
}

/** Logarithms of a matrix as row + column: geometric means over what counts. */
struct Separated
{
    Eigen::VectorXd rows, columns;
};

Separated separate (const Eigen::MatrixXd& logarithms, const Eigen::MatrixXd& counts)
{
    Separated result { Eigen::VectorXd::Zero (logarithms.rows()), Eigen::VectorXd::Zero (logarithms.cols()) };

    for (int sweep = 0; sweep < 20; ++sweep)
    {
        const Eigen::MatrixXd byRows = logarithms.rowwise() - result.columns.transpose();
        result.rows =
            (byRows.cwiseProduct (counts).rowwise().sum().array() / counts.rowwise().sum().array().max (1e-9)).matrix();
        const Eigen::MatrixXd byColumns = logarithms.colwise() - result.rows;
        result.columns =
            (byColumns.cwiseProduct (counts).colwise().sum().array() / counts.colwise().sum().array().max (1e-9))
                .transpose()
                .matrix();
    }

    return result;
}

/** Straight lines between the middles of the spans. */
Eigen::VectorXd interpolated (const Eigen::VectorXd& at, const Eigen::VectorXd& values, const Eigen::VectorXd& omega)
{
    Eigen::VectorXd result (omega.size());
    Eigen::Index span = 0;

    for (Eigen::Index f = 0; f < omega.size(); ++f)
    {
        while (span + 2 < at.size() && omega[f] > at[span + 1])
            ++span;

        const auto next = std::min (span + 1, at.size() - 1);
        const auto width = at[next] - at[span];
        const auto share = width > 0 ? std::clamp ((omega[f] - at[span]) / width, 0.0, 1.0) : 0.0;
        result[f] = values[span] + share * (values[next] - values[span]);
    }

    return result;
}

/** Adds what one span of lines leaves, column by column, so that the work stays near the processor. */
void addSpan (FitErrors& errors, Eigen::Index span, DataBlock& data, const DataBlock& given,
              const Eigen::VectorXd& scale)
{
    const auto lines = scale.size();
    const auto perDifference = static_cast<double> (lines) / (2.0 * static_cast<double> (lines - 1));
    errors.energies.row (span).setZero();
    errors.roughness.row (span).setZero();

    for (Eigen::Index c = 0; c < given.real.cols(); ++c)
        for (const auto isReal : { true, false })
        {
            auto values = isReal ? data.real.col (c) : data.imaginary.col (c);
            errors.velocityDataEnergies[c] += values.squaredNorm();
            errors.dataEnergies[c] += values.cwiseProduct (scale).squaredNorm();
            values -= isReal ? given.real.col (c) : given.imaginary.col (c);
            errors.velocityEnergies[c] += values.squaredNorm();
            values = values.cwiseProduct (scale);
            errors.energies (span, c) += values.squaredNorm();
            errors.roughness (span, c) +=
                perDifference * (values.tail (lines - 1) - values.head (lines - 1)).squaredNorm();
        }
}
} // namespace

Eigen::MatrixXd fitCoefficients (const FitState& state)
{
    const auto& basis = state.basis;
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero (basis.size(), state.columnWeights.size());
    result (Eigen::seqN (0, basis.modes(), Eigen::fix<realModeFunctions>), Eigen::all) = amplitudes (state);
    result.bottomRows (static_cast<Eigen::Index> (basis.powers.size())) = residualCoefficients (state);
    return result;
}

FitErrors fitErrors (PreparedResponses& data, const ModalBasis& basis, const Eigen::MatrixXd& coefficients,
                     double delay)
{
    // Spans of lines: enough of them to follow the noise's colour, enough lines in each for its variance.
    const auto perSpan = std::clamp<Eigen::Index> (data.lines() / 24, 16, linesOfSegment);
    const auto spans = std::max<Eigen::Index> (1, data.lines() / perSpan);
    FitErrors errors { Eigen::VectorXd (spans),
                       Eigen::VectorXd (spans),
                       Eigen::MatrixXd (spans, data.columns()),
                       Eigen::MatrixXd (spans, data.columns()),
                       Eigen::VectorXd::Zero (data.columns()),
                       Eigen::VectorXd::Zero (data.columns()),
                       Eigen::VectorXd::Zero (data.columns()) };

    for (Eigen::Index s = 0; s < spans; ++s)
    {
        const auto first = s * data.lines() / spans, count = (s + 1) * data.lines() / spans - first;
        const Eigen::VectorXd omega = data.omega.segment (first, count);
        const auto given = synthesised (lineSegment (basis, omega), coefficients, count);
        fillMissing (data, first, count, delay, given);
        auto error = dataBlock (data, first, advances (data, first, count, delay));
        addSpan (errors, s, error, given, data.lineScale.segment (first, count));
        errors.frequencies[s] = (omega[0] + omega[count - 1]) / 2;
        errors.lines[s] = static_cast<double> (count);
    }

    return errors;
}

void weighByErrors (PreparedResponses& data, const FitErrors& errors)
{
    const Eigen::VectorXd active = (data.columnWeights.array() > 0).cast<double>();
    const auto values = errors.lines.sum() * active.sum();

    if (data.responses->variances.empty())
    {
        // Rounding is the least noise there is: without it, input without noise would be weighted by nothing.
        const auto floor = 1e-30 * errors.dataEnergies.dot (active) / values;
        const Eigen::MatrixXd variances =
            (errors.roughness.array().colwise() / errors.lines.array()).max (std::max (floor, 1e-300));
        const auto bySpan =
            separate (variances.array().log().matrix(), Eigen::VectorXd::Ones (variances.rows()) * active.transpose());
        const Eigen::MatrixXd ofColumns = bySpan.columns.reshaped (data.points(), data.references());
        const auto byPoint = separate (ofColumns, active.reshaped (data.points(), data.references()));
        data.lineWeights = data.lineScale.array().square()
                           * (-interpolated (errors.frequencies, bySpan.rows, data.omega)).array().exp();

        for (Eigen::Index c = 0; c < data.columns(); ++c)
            data.columnWeights[c] =
                active[c] * std::exp (-byPoint.rows[c % data.points()] - byPoint.columns[c / data.points()]);
    }
}
} // namespace antinode
