#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace antinode
{
/** All lines from lowest to highest. [any] */
std::vector<Eigen::Index> everyLine (Eigen::Index lowest, Eigen::Index highest);

/** The odd lines from lowest to highest without one of each four in a row, chosen at random: what responds on even
   lines is even distortion, on the odd ones left out odd distortion. Pintelon and Schoukens, System Identification,
   2012, section 4.3.
    @throws InputError  when none is left [any] */
std::vector<Eigen::Index> oddRandomLines (Eigen::Index lowest, Eigen::Index highest, std::uint64_t seed);

/** One period of a sum of sines, equally strong on the given lines and nothing elsewhere; its largest sample is 1.

    Begins with Schroeder's phases -pi n (n - 1) / N (IEEE Trans. Inf. Theory 16, 1970), whose crest factor is 1.7, with
   the peaks between samples 1.9, and then clips the waveform and keeps the phases of what comes out, again and again
   (van der Ouderaa, Schoukens and Renneboog, IEEE Trans. Instrum. Meas. 37, 1988): 1.6 and less.
    @param length  samples, more than twice the highest line
    [worker] Docs/Theory.md, section 8.8. */
Eigen::VectorXd multisinePeriod (const std::vector<Eigen::Index>& lines, Eigen::Index length);
} // namespace antinode
