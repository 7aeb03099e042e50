#pragma once

#include "FilterProblem.h"

#include "ResponseTable.h"

#include <memory>

namespace antinode
{
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
