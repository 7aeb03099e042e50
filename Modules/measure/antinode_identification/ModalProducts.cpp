#include "ModalProducts.h"

#include "ModalFunctions.h"

#include <antinode_numerics/DenseKernels.h>

#include <cmath>
#include <numeric>

namespace antinode
{
namespace
{
constexpr Eigen::Index linesOfSmallest = 2 * fewLines;

Eigen::MatrixXd transposedProduct (const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero (a.cols(), b.cols());
    addTransposedLeft (result, 1, a, b);
    return result;
}

LineSpan emptySpan (const PreparedResponses& data, Eigen::Index first, Eigen::Index count)
{
    LineSpan span;
    span.first = first;
    span.count = count;
    const auto lowest = data.omega[first], highest = data.omega[first + count - 1];
    span.centre = (lowest + highest) / 2;
    span.halfWidth = (highest - lowest) / 2;

    if (count >= fewLines)
        span.nodes = chebyshevNodes (span.centre, span.halfWidth);

    return span;
}

void sumLines (LineSpan& span, const PreparedResponses& data, LineMoments& all)
{
    const Eigen::VectorXd roots = data.lineWeights.segment (span.first, span.count).cwiseSqrt();
    const auto values =
        dataBlock (data, span.first, roots.asDiagonal() * advances (data, span.first, span.count, all.delay));
    all.energies += (values.real.colwise().squaredNorm() + values.imaginary.colwise().squaredNorm()).transpose();

    if (span.nodes.size() == 0)
        return;

    const Eigen::MatrixXd polynomials =
        roots.asDiagonal() * interpolation (data.omega.segment (span.first, span.count), span.nodes);
    span.overlaps = transposedProduct (polynomials, polynomials);
    span.dataReal = transposedProduct (polynomials, values.real);
    span.dataImaginary = transposedProduct (polynomials, values.imaginary);
}

/** A polynomial on the whole is one on either half. */
void addHalf (LineSpan& whole, const LineSpan& half)
{
    const auto toHalf = interpolation (half.nodes, whole.nodes);
    whole.overlaps += toHalf.transpose() * half.overlaps * toHalf;
    addTransposedLeft (whole.dataReal, 1, toHalf, half.dataReal);
    addTransposedLeft (whole.dataImaginary, 1, toHalf, half.dataImaginary);
}

void fillSpan (LineMoments& all, Eigen::Index index, const PreparedResponses& data)
{
    const auto at = [&all] (Eigen::Index n) -> LineSpan& { return all.spans[static_cast<std::size_t> (n)]; };
    const auto first = at (index).first, count = at (index).count;

    if (count <= linesOfSmallest)
        return sumLines (at (index), data, all);

    const auto lower = count / 2, halves = static_cast<Eigen::Index> (all.spans.size());
    at (index).halves = halves;
    all.spans.push_back (emptySpan (data, first, lower));
    all.spans.push_back (emptySpan (data, first + lower, count - lower));
    at (index).overlaps = Eigen::MatrixXd::Zero (smoothNodes, smoothNodes);
    at (index).dataReal = at (index).dataImaginary = Eigen::MatrixXd::Zero (smoothNodes, data.columns());

    for (const auto half : { halves, halves + 1 })
    {
        fillSpan (all, half, data);
        addHalf (at (index), at (half));
    }
}
} // namespace

LineMoments lineMoments (const PreparedResponses& data, double delay)
{
    LineMoments result { delay, { emptySpan (data, 0, data.lines()) }, Eigen::VectorXd::Zero (data.columns()) };
    fillSpan (result, 0, data);
    return result;
}

bool isNear (const LineMoments& moments, double delay)
{
    constexpr double smooth = 1; // rad
    return std::abs (delay - moments.delay) * moments.spans.front().halfWidth <= smooth;
}

namespace
{
/** Functions by the pole that they have: those of mode k, or, with the number of modes for k, the powers. */
using Poles = std::vector<Eigen::Index>;

/** Real and imaginary parts of functions, one a column. */
struct Values
{
    Eigen::MatrixXd real, imaginary;

    explicit Values (const Eigen::MatrixXcd& values) : real (values.real()), imaginary (values.imag()) {}
};

Eigen::Index firstColumn (const ModalBasis& basis, Eigen::Index pole)
{
    return pole * basis.functions;
}

Eigen::Index columnCount (const ModalBasis& basis, Eigen::Index pole)
{
    return pole < basis.modes() ? basis.functions : basis.size() - basis.modalColumns();
}

std::vector<Eigen::Index> columnsOf (const ModalBasis& basis, const Poles& poles)
{
    std::vector<Eigen::Index> result;

    for (const auto pole : poles)
        for (Eigen::Index n = 0; n < columnCount (basis, pole); ++n)
            result.push_back (firstColumn (basis, pole) + n);

    return result;
}

Eigen::MatrixXcd evaluate (const ModalBasis& basis, const Poles& poles, const Eigen::VectorXd& omega)
{
    Eigen::MatrixXcd result (omega.size(), static_cast<Eigen::Index> (columnsOf (basis, poles).size()));
    Eigen::Index column = 0;

    for (const auto pole : poles)
    {
        const auto count = columnCount (basis, pole);
        result.middleCols (column, count) =
            pole < basis.modes() ? evaluateModalFunctions (basis, pole, omega) : evaluatePowers (basis, omega);
        column += count;
    }

    return result;
}

/** Whether what a pole does to the lines of a span is smooth. Negative powers have a pole of third order at 0. */
bool isSmooth (const ModalBasis& basis, Eigen::Index pole, const LineSpan& span)
{
    constexpr double distanceOfPowers = 4;

    if (span.nodes.size() == 0)
        return false;

    if (pole == basis.modes())
        return span.centre > distanceOfPowers * span.halfWidth;

    const auto resonance = basis.angularFrequencies[pole], reach = smoothDistance * span.halfWidth;
    return std::abs (resonance - span.centre) > reach && resonance + span.centre > reach;
}

/** to (rows, columns) += values, and the same mirrored to the other triangle. */
void addBoth (Eigen::MatrixXd& to, const std::vector<Eigen::Index>& rows, const std::vector<Eigen::Index>& columns,
              const Eigen::MatrixXd& values)
{
    for (std::size_t n = 0; n < columns.size(); ++n)
        for (std::size_t m = 0; m < rows.size(); ++m)
        {
            const auto value = values (static_cast<Eigen::Index> (m), static_cast<Eigen::Index> (n));
            to (rows[m], columns[n]) += value;
            to (columns[n], rows[m]) += value;
        }
}

/** Re <a, b>, one function a column. */
Eigen::MatrixXd products (const Values& a, const Eigen::MatrixXd& real, const Eigen::MatrixXd& imaginary)
{
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero (a.real.cols(), real.cols());
    addTransposedLeft (result, 1, a.real, real);
    addTransposedLeft (result, 1, a.imaginary, imaginary);
    return result;
}

/** Walks down the halves of the lines: a pole is dealt with where it first is far enough, or at single lines. */
class Summation
{
public:
    Summation (const ModalBasis& basisToUse, const PreparedResponses& dataToUse, const LineMoments& momentsToUse,
               double delay)
        : basis (basisToUse), data (dataToUse), moments (momentsToUse),
          delayLeft (delay - momentsToUse.delay), result { Eigen::MatrixXd::Zero (basis.size(), basis.size()),
                                                           Eigen::MatrixXd::Zero (basis.size(), data.columns()),
                                                           moments.energies }
    {
    }

    /** @param near  poles that were too near to all that the span is a part of @param smooth  the other ones */
    void visit (Eigen::Index index, const Poles& near, const Poles& smooth)
    {
        const auto& span = moments.spans[static_cast<std::size_t> (index)];
        Poles stillNear, nowSmooth;

        for (const auto pole : near)
            (isSmooth (basis, pole, span) ? nowSmooth : stillNear).push_back (pole);

        if (! nowSmooth.empty())
            addSmooth (span, nowSmooth, smooth);

        if (stillNear.empty())
            return;

        nowSmooth.insert (nowSmooth.end(), smooth.begin(), smooth.end());

        if (span.halves == 0)
            return addNear (span, stillNear, nowSmooth);

        visit (span.halves, stillNear, nowSmooth);
        visit (span.halves + 1, stillNear, nowSmooth);
    }

    const ModalProducts& get() const { return result; }

private:
    /** The delay that is still in the data is taken out of the functions instead. */
    Values delayed (const Eigen::MatrixXcd& values, const Eigen::VectorXd& omega) const
    {
        Eigen::VectorXcd factors (omega.size());

        for (Eigen::Index f = 0; f < omega.size(); ++f)
            factors[f] = std::polar (1.0, -omega[f] * delayLeft);

        return Values (factors.asDiagonal() * values);
    }

    void addData (const std::vector<Eigen::Index>& columns, const Values& functions, const Eigen::MatrixXd& real,
                  const Eigen::MatrixXd& imaginary)
    {
        const auto sums = products (functions, real, imaginary);

        for (std::size_t n = 0; n < columns.size(); ++n)
            result.data.row (columns[n]) += sums.row (static_cast<Eigen::Index> (n));
    }

    void addSmooth (const LineSpan& span, const Poles& poles, const Poles& others)
    {
        const auto columns = columnsOf (basis, poles);
        const auto values = evaluate (basis, poles, span.nodes);
        addData (columns, delayed (values, span.nodes), span.dataReal, span.dataImaginary);
        const Values parts (values);
        const Values weighted (span.overlaps * values);
        result.gram (columns, columns) += products (parts, weighted.real, weighted.imaginary);

        if (others.empty())
            return;

        const Values of (evaluate (basis, others, span.nodes));
        addBoth (result.gram, columns, columnsOf (basis, others), products (weighted, of.real, of.imaginary));
    }

    void addNear (const LineSpan& span, const Poles& poles, const Poles& smooth)
    {
        const auto columns = columnsOf (basis, poles);
        const Eigen::VectorXd omega = data.omega.segment (span.first, span.count);
        const Eigen::VectorXd roots = data.lineWeights.segment (span.first, span.count).cwiseSqrt();
        const Eigen::MatrixXcd values = roots.asDiagonal() * evaluate (basis, poles, omega);
        const auto measured =
            dataBlock (data, span.first, roots.asDiagonal() * advances (data, span.first, span.count, moments.delay));
        addData (columns, delayed (values, omega), measured.real, measured.imaginary);
        const Values parts (values);
        result.gram (columns, columns) += products (parts, parts.real, parts.imaginary);

        if (smooth.empty())
            return;

        const Eigen::MatrixXd polynomials = roots.asDiagonal() * interpolation (omega, span.nodes);
        const Values atNodes (polynomials.transpose() * values), of (evaluate (basis, smooth, span.nodes));
        addBoth (result.gram, columns, columnsOf (basis, smooth), products (atNodes, of.real, of.imaginary));
    }

    const ModalBasis& basis;
    const PreparedResponses& data;
    const LineMoments& moments;
    double delayLeft;
    ModalProducts result;
};
} // namespace

ModalProducts modalProducts (const ModalBasis& basis, const PreparedResponses& data, const LineMoments& moments,
                             double delay)
{
    Summation summation (basis, data, moments, delay);
    Poles all (static_cast<std::size_t> (basis.modes() + (basis.powers.empty() ? 0 : 1)));
    std::iota (all.begin(), all.end(), 0);
    summation.visit (0, all, {});
    return summation.get();
}

ModalProducts modalProducts (const ModalBasis& basis, const PreparedResponses& data, double delay)
{
    return modalProducts (basis, data, lineMoments (data, delay), delay);
}
} // namespace antinode
