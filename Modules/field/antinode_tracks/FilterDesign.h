#pragma once

#include "FingerFilters.h"
#include "PointResponses.h"
#include "TrackSolver.h"

#include <Eigen/Core>

#include <memory>

namespace antinode
{
/** The samples of filters. */
struct FilterSpan
{
    Eigen::Index factor, delay, taps;
    Eigen::Index length; // of the transforms
    double rate;         // Hz
};

/** @throws InputError  for a latency or a rate that is not allowed [any] */
FilterSpan filterSpan (TrackBand, const FilterSettings&);

/** Errors count up to this frequency, Hz. [any] */
double highestWeighed (TrackBand);

/** Each line times how much an error counts there. [worker] */
void weighLines (PointResponses&, TrackBand);

/** An impulse after the delay, of which the lines that count are left: length. [worker] */
Eigen::VectorXd weighedImpulse (const FilterSpan&, TrackBand);

/** ||reached - wanted|| / ||wanted|| of a filter: what gradients have left, and what the compliance leaves. [worker] */
double filterError (const GradientsResult&, double compliance, const Eigen::VectorXd& impulse);

/** Refuses points that move: their way is not known to a filter. @throws InputError  naming the first [any] */
void requireFixedPoints (const WaveformsDescription&);

/** Designs filters for one device, rate and latency while fingers move: what all places share is computed once. Nothing
    changes after construction; any number of threads may design. */
class QuickFilterDesigner
{
public:
    /** @throws InputError  as designFingerFilters for the band and the settings
        [worker] */
    QuickFilterDesigner (std::shared_ptr<const ModalModel>, TrackBand, const FilterSettings&);

    /** What designFingerFilters gives, filters of the same sizes, within some milliseconds on the thread that calls:
        fewer mixes of ceramics play, and the search ends after a few steps. Points too near to be told apart are not
        refused; `error` says what is left.
        @param description  its points and fingers are used; the band is that of the designer
        @param tolerance    of the wanted motion, where the search may end before its last step
        @throws InputError  for points outside the surface, or more of them than ceramics
        @throws Cancelled   when a watch of this thread says no
        [worker] Docs/Theory.md, section 4.16. */
    FingerFilters design (const WaveformsDescription&, double tolerance = usualTolerance) const;

    static constexpr double usualTolerance = 3e-3; ///< -50 dB

private:
    std::shared_ptr<const ModalModel> model;
    TrackBand band;
    FilterSettings settings;
    FilterSpan span;
    Eigen::MatrixXd mixes; // N_b x mixes, orthonormal columns
    ResponseTable table;
    Eigen::VectorXd impulse;
};
} // namespace antinode
