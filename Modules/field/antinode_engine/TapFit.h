#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace antinode
{
/** Where a response has to be right, rad per sample. */
struct FitBand
{
    double lowest = 0, highest = 0;
};

/** A wanted response: 1 + i omega timeConstant, or its inverse, times exp (i (angle - omega delay)); above the band of
   the magnitude that it has at its end. */
struct FitTarget
{
    double timeConstant = 0; ///< Samples.
    bool isLowPass = false;  ///< The inverse.
    double angle = 0;        ///< rad
    double delay = 0;        ///< Samples.
};

/** Filters of one length by least squares over a band. Taps that are even in time fit the real part of a response, odd
   ones the imaginary part, all of them by two factors. Docs/Theory.md, section 7.9. */
class TapFit
{
public:
    /** @param half  taps on each side of the middle one [worker] */
    TapFit (const FitBand&, Eigen::Index half);

    Eigen::Index half() const { return odd.cols(); }

    /** 2 half + 1 taps, the newest sample first; the middle one is the origin of time. [worker] */
    Eigen::VectorXd taps (const FitTarget&) const;

    /** The largest error of the response of these taps in the band, of the wanted one. [worker] */
    double misfit (const Eigen::VectorXd& taps, const FitTarget&) const;

private:
    Eigen::LLT<Eigen::MatrixXd> factorOf (const Eigen::MatrixXd& waves) const;
    Eigen::ArrayXcd wanted (const FitTarget&) const;

    double highest; ///< Of the band, rad per sample.
    Eigen::Index bandLines;
    Eigen::ArrayXd omegas;     ///< rad per sample: lines in the band, then some anywhere.
    Eigen::ArrayXd weights;    ///< Of lines.
    Eigen::MatrixXd even, odd; ///< Lines x taps.
    Eigen::LLT<Eigen::MatrixXd> evenFactor, oddFactor;
};
} // namespace antinode
