#include "FitErrors.h"

#include "ModalFunctions.h"

#include <Eigen/LU>
#include <antinode_base/MessageText.h>
#include <antinode_base/Watch.h>
#include <antinode_numerics/DenseKernels.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

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

namespace
{
/** The fit of i omega (c_-1 x^-2 + c_0 + c_1 x^2), real c, x = omega over the highest one, to what is left of each
    channel: normal equations of the channels, which differ by the lines that they lack. */
class ShareFit
{
public:
    ShareFit (const PreparedResponses& data, const IdentifiedModes& modesToUse)
        : modes (modesToUse), rows (data.points()), highest (data.omega[data.lines() - 1]),
          last (data.omega[0] + lowerPart * (highest - data.omega[0])),
          matrices (static_cast<std::size_t> (data.columns()), Eigen::Matrix3d::Zero()),
          sums (Eigen::Matrix3Xd::Zero (3, data.columns()))
    {
    }

    void add (Eigen::Index point, Eigen::Index reference, double omega, std::complex<double> left)
    {
        if (omega > last)
            return;

        const auto lowPass = modes.lowPasses.size() > 0 ? modes.lowPasses (point, reference) : 0.0;
        const auto value = left * std::polar (1.0, omega * modes.delay) * std::complex<double> (1, omega * lowPass);
        const auto x = std::pow (omega / highest, 2);
        const Eigen::Vector3d functions = omega * Eigen::Vector3d (1 / x, 1, x);
        const auto channel = point + rows * reference;
        matrices[static_cast<std::size_t> (channel)] += functions * functions.transpose();
        sums.col (channel) += value.imag() * functions;
    }

    Eigen::MatrixXd share() const
    {
        Eigen::MatrixXd result (rows, sums.cols() / rows);

        for (Eigen::Index channel = 0; channel < sums.cols(); ++channel)
        {
            const auto& matrix = matrices[static_cast<std::size_t> (channel)];
            const Eigen::FullPivLU<Eigen::Matrix3d> factors (matrix);
            result.reshaped()[channel] = factors.isInvertible() ? factors.solve (sums.col (channel))[1]
                                                                : std::numeric_limits<double>::quiet_NaN();
        }

        return result;
    }

private:
    static constexpr double lowerPart = 0.6; // Nearer to the next mode more terms would be needed.

    const IdentifiedModes& modes;
    Eigen::Index rows;
    double highest, last; // rad/s
    std::vector<Eigen::Matrix3d> matrices;
    Eigen::Matrix3Xd sums;
};
} // namespace

ModalRest modalRest (const IdentifiedModes& modes, const PreparedResponses& data)
{
    auto alone = modes;
    alone.residuals.clear();
    double error = 0, energy = 0;
    ShareFit fit (data, modes);

    // Part by part: what was measured may fill most of the memory.
    for (Eigen::Index first = 0; first < data.lines(); first += linesOfSegment)
    {
        checkWatch();
        const auto count = std::min (linesOfSegment, data.lines() - first);
        const auto given = synthesise (alone, data.omega.segment (first, count) / (2 * std::numbers::pi));

        for (std::size_t i = 0; i < given.values.size(); ++i)
        {
            const auto measured = data.responses->values[i].middleRows (data.firstLine + first, count);

            for (Eigen::Index p = 0; p < data.points(); ++p)
                for (Eigen::Index f = 0; f < count; ++f)
                    if (const auto left = measured (f, p) - given.values[i](f, p); std::isfinite (std::norm (left)))
                    {
                        error += std::norm (left);
                        energy += std::norm (measured (f, p));
                        fit.add (p, static_cast<Eigen::Index> (i), data.omega[first + f], left);
                    }
        }
    }

    return { 10 * std::log10 (std::max (error / energy, 1e-32)), fit.share() };
}

namespace
{
constexpr Eigen::Index spans = 24;

double decibels (double ratio)
{
    return 10 * std::log10 (std::max (ratio, 1e-30));
}

/** Energies of velocities and of what synthesis leaves of them, by spans of lines and by channels: spans x C. */
struct ErrorMap
{
    Eigen::VectorXd edges; ///< Hz, spans + 1.
    Eigen::ArrayXXd errors, energies;
};

ErrorMap errorMap (const FrequencyResponses& responses, const IdentifiedModes& modes, const FrequencyBand& band)
{
    const auto* const begin = responses.frequencies.data();
    const auto* const end = begin + responses.frequencies.size();
    const auto first = std::lower_bound (begin, end, band.minimum) - begin;
    const auto count = std::upper_bound (begin, end, band.maximum) - begin - first;
    const auto points = responses.points.rows();
    ErrorMap map { Eigen::VectorXd (spans + 1),
                   Eigen::ArrayXXd::Zero (spans, points * static_cast<Eigen::Index> (responses.values.size())),
                   {} };
    map.energies = map.errors;
    map.edges[spans] = responses.frequencies[first + count - 1];

    for (Eigen::Index s = 0; s < spans; ++s)
    {
        checkWatch();
        const auto from = first + s * count / spans, lines = first + (s + 1) * count / spans - from;
        map.edges[s] = responses.frequencies[from];

        const auto given = synthesise (modes, responses.frequencies.segment (from, lines));

        for (std::size_t i = 0; i < responses.values.size(); ++i)
            for (Eigen::Index p = 0; p < points; ++p)
                for (Eigen::Index f = 0; f < lines; ++f)
                {
                    const auto measured = responses.values[i](from + f, p);
                    const auto column = static_cast<Eigen::Index> (i) * points + p;

                    if (const auto error = std::norm (measured - given.values[i](f, p)); std::isfinite (error))
                    {
                        map.errors (s, column) += error;
                        map.energies (s, column) += std::norm (measured);
                    }
                }
    }

    return map;
}

} // namespace

double errorBetween (const FrequencyResponses& responses, const IdentifiedModes& modes, const FrequencyBand& band)
{
    const auto map = errorMap (responses, modes, band);
    const Eigen::ArrayXd errors = map.errors.rowwise().sum(), energies = map.energies.rowwise().sum();
    return decibels (errors.sum() / energies.sum()) + decibels ((errors / energies.max (1e-300)).min (1).mean());
}

std::string sayWhere (const FrequencyResponses& responses, const IdentifiedModes& modes)
{
    const auto map = errorMap (responses, modes, { modes.minimumFrequency, modes.maximumFrequency });
    const Eigen::ArrayXd bySpan = map.errors.rowwise().sum(), byColumn = map.errors.colwise().sum().transpose();
    Eigen::Index span = 0, column = 0;
    bySpan.maxCoeff (&span);
    byColumn.maxCoeff (&column);
    const auto share = [] (double part, double all)
    { return fixedText (100 * part / std::max (all, 1e-300), 0) + " %"; };
    auto text = share (bySpan[span], bySpan.sum()) + " of the error lies from " + inWords (map.edges[span]) + " to "
                + inWords (map.edges[span + 1]) + " Hz";

    if (byColumn.size() > 1)
        text += ", " + share (byColumn[column], byColumn.sum()) + " of it at point "
                + std::to_string (column % responses.points.rows() + 1) + ", driver "
                + responses.references[static_cast<std::size_t> (column / responses.points.rows())].name;

    return text
           + "; other ranges and orders were tried: check quantity, sign and sensors, then --band, --orders and "
             "--complex";
}
} // namespace antinode
