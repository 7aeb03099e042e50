#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <antinode_model/ModalModel.h>

#include <cstdint>
#include <vector>

namespace antinode
{
/** What filters do with the lags of ceramics. */
enum class LagDirection
{
    undo, ///< From the voltages that ceramics are to act on to those that are asked for: before the outputs.
    apply ///< From the voltages that were asked for to those that ceramics acted on.
};

/** One filter a ceramic for the lags in which ceramics differ, or that are no delay. Docs/Theory.md, section 7.9. */
struct LagFilters
{
    Eigen::MatrixXd taps;             ///< N_t x N_b: the oldest sample first; N_t is odd.
    std::vector<Eigen::Index> starts; ///< N_b: samples by which the newest tap is late.
    Eigen::Index lateness = 0;        ///< Samples: by how much all that was designed happens later.
    double misfit = 0;                ///< The largest error of a response in the band of the modes, of the wanted one.

    /** Samples from the oldest that is needed to the newest. [any] */
    Eigen::Index reach() const;
};

/** Whether there is more to do than to wait: ceramics differ in their lags, or have one that is no delay. [any] */
bool needsLagFilters (const ModalModel&);

/** Filters by least squares over the band of the modes, as long as they have to be, 1025 taps at most.
    @param sampleRate  Hz
    @throws InputError  where delays differ by more than longestLag
    [worker] Docs/Theory.md, section 7.9. */
LagFilters lagFilters (const ModalModel&, double sampleRate, LagDirection);

/** Voltages before the outputs: what is asked for so that ceramics act on what was designed, within the limits. */
struct UndoneLags
{
    Eigen::MatrixXd voltages;             ///< N_b x N_s, V: longer than what was designed, where anything lags.
    std::vector<std::int64_t> limited {}; ///< N_b: samples that limits of voltage or slew rate changed.
    Eigen::Index lateness = 0;            ///< As LagFilters.
    double misfit = 0;                    ///< As LagFilters.
};

/** The same voltages where there is nothing to undo. Slew rates and voltages stay within the limits.
    @param voltages  N_b x N_s, V, finite
    @param limits    N_b, V
    @throws InputError  as lagFilters, or where anything lags and there are not N_b rows
    [worker] */
UndoneLags withLagsUndone (const ModalModel&, const Eigen::MatrixXd& voltages, const Eigen::VectorXd& limits,
                           double sampleRate);

/** What ceramics acted on when these voltages were asked for, at the time when they did.
    @param voltages  N_b x N_s, V
    @return          N_b x N_s, V
    @throws InputError  as withLagsUndone
    [worker] */
Eigen::MatrixXd withLags (const ModalModel&, const Eigen::MatrixXd& voltages, double sampleRate);

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
