#include "IdentifiedModes.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/DenseKernels.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antinode
{
namespace
{
using Complex = std::complex<double>;

constexpr Eigen::Index columnsAtOnce = 32; // between looks at the watch

/** Functions of all modes, real and imaginary parts on their own: lines x N_m. */
struct ModeFunctions
{
    Eigen::MatrixXd real, imaginary;

    ModeFunctions (Eigen::Index lines, Eigen::Index modes) : real (lines, modes), imaginary (lines, modes) {}

    void setMode (Eigen::Index mode, const Eigen::VectorXcd& values)
    {
        real.col (mode) = values.real();
        imaginary.col (mode) = values.imag();
    }

    /** values += functions times real factors, N_m x columns. */
    void addTo (Eigen::Ref<Eigen::MatrixXcd> values, const Eigen::MatrixXd& factors) const
    {
        Eigen::MatrixXd part = Eigen::MatrixXd::Zero (values.rows(), values.cols());
        addProduct (part, 1, real, factors);
        values.real() += part;
        part.setZero();
        addProduct (part, 1, imaginary, factors);
        values.imag() += part;
    }
};

/** One mode with residue r per unit of shape times participation: r / (i omega - s) + conj (r) / (i omega - conj (s))
   for a complex product c is its real part times the first function less its imaginary part times the second. */
Eigen::MatrixXcd residueFunctions (double resonance, double damping, const Eigen::VectorXd& omega)
{
    const Complex pole (-damping * resonance, resonance * std::sqrt (1 - damping * damping));
    const auto residue = pole / Complex (0, 2 * pole.imag());
    Eigen::MatrixXcd result (omega.size(), 2);

    for (Eigen::Index f = 0; f < omega.size(); ++f)
    {
        const Complex iOmega (0, omega[f]);
        const auto first = residue / (iOmega - pole), second = std::conj (residue) / (iOmega - std::conj (pole));
        result (f, 0) = first + second;
        result (f, 1) = Complex (0, 1) * (first - second);
    }

    return result;
}

/** Products of shape and participation that enter: N_m x N_p of one reference. */
Eigen::MatrixXcd computeProducts (const IdentifiedModes& modes, Eigen::Index reference)
{
    if (modes.complexShapes.size() > 0)
        return modes.complexParticipation.col (reference).asDiagonal() * modes.complexShapes.transpose();

    return (modes.participation.col (reference).asDiagonal() * modes.shapes.transpose()).cast<Complex>();
}

void addResidualTerms (Eigen::MatrixXcd& values, const IdentifiedModes& modes, Eigen::Index reference,
                       const Eigen::VectorXd& omega)
{
    for (const auto& term : modes.residuals)
        for (Eigen::Index f = 0; f < omega.size(); ++f)
            if (omega[f] > 0 || term.power >= 0)
                values.row (f) += std::pow (Complex (0, omega[f]), term.power)
                                  * term.coefficients.col (reference).transpose().cast<Complex>();
}

void addLowPasses (Eigen::MatrixXcd& values, const Eigen::VectorXd& timeConstants, const Eigen::VectorXd& omega)
{
    for (Eigen::Index p = 0; p < values.cols(); ++p)
        if (timeConstants[p] > 0)
            values.col (p).array() /= 1.0 + Complex (0, timeConstants[p]) * omega.array();
}
} // namespace

FrequencyResponses synthesise (const IdentifiedModes& modes, const Eigen::VectorXd& frequencies)
{
    const Eigen::VectorXd omega = 2 * std::numbers::pi * frequencies;
    ModeFunctions ofReal (omega.size(), modes.modes()), ofImaginary = ofReal;

    for (Eigen::Index k = 0; k < modes.modes(); ++k)
    {
        checkWatch();
        const auto functions = residueFunctions (modes.angularFrequencies[k], modes.dampingRatios[k], omega);
        ofReal.setMode (k, functions.col (0));
        ofImaginary.setMode (k, functions.col (1));
    }

    FrequencyResponses responses { frequencies, modes.drive, modes.references, modes.points, {}, {} };
    const Eigen::ArrayXcd delays = (omega.array() * Complex (0, -modes.delay)).exp();

    for (Eigen::Index i = 0; i < static_cast<Eigen::Index> (modes.references.size()); ++i)
    {
        const auto products = computeProducts (modes, i);
        Eigen::MatrixXcd values = Eigen::MatrixXcd::Zero (omega.size(), products.cols());

        for (Eigen::Index first = 0; first < products.cols(); first += columnsAtOnce)
        {
            checkWatch();
            const auto count = std::min (columnsAtOnce, products.cols() - first);
            const Eigen::MatrixXcd part = products.middleCols (first, count);
            ofReal.addTo (values.middleCols (first, count), part.real());

            if (modes.complexShapes.size() > 0)
                ofImaginary.addTo (values.middleCols (first, count), part.imag());
        }

        addResidualTerms (values, modes, i, omega);
        values.array().colwise() *= delays;

        if (modes.lowPasses.size() > 0)
            addLowPasses (values, modes.lowPasses.col (i), omega);

        responses.values.push_back (std::move (values));
    }

    return responses;
}
} // namespace antinode
