#pragma once

namespace antinode
{
/** What a free waveform reached where less was to be felt elsewhere, in terms of the modes that it is designed for. */
struct LessFelt
{
    double gain = 0;      ///< dB: by how much the weighted energy there is less than that of the design without it.
    double weight = 0;    ///< What the limits allow of the wanted one.
    double share = 1;     ///< Of the way from that design to the compromise of this weight; below 1 where limits allow
                          ///< next to none.
    double plainPeak = 0; ///< V that the design without it needs.
    int iterations = 0;   ///< Of conjugate gradients.
    double residual = 0;  ///< Of the compromise: |slope| / |slope of the design without it|.
};
} // namespace antinode
