#pragma once

#include "IdentifiedModes.h"
#include "PreparedResponses.h"

namespace antinode
{
/** What modes alone leave of measured velocities, without residual terms. */
struct ModalRest
{
    double error = 0; ///< RMS over RMS of measured, dB, on the lines of the data.

    /** N_p x N_b: how far modes above the band bend the points per drive, far below it, m/V or m/N: least squares on
       the lower part of the band, beside the inertia of lower modes and the onset of higher ones. NaN where it is not
        measured. Residual terms, which fit all of the band, take it up to twice as large. */
    Eigen::MatrixXd staticShare;
};

/** [worker] Docs/Theory.md, section 8.4. */
ModalRest modalRest (const IdentifiedModes&, const PreparedResponses&);
} // namespace antinode
