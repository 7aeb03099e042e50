#pragma once

#include "FrequencyResponses.h"

namespace antinode
{
/** A value that was not measured and is replaced while modes are fitted. */
struct MissingValue
{
    Eigen::Index line = 0;   ///< Among the lines that are used.
    Eigen::Index column = 0; ///< reference N_p + point
    std::complex<double> value;
};

/** Responses as a fit takes them: the lines that are used, and the weight of each value as a product of one for its
   line and one for its column. Refers to the responses it was made from. N lines, C = N_p N_b columns, references one
   after the other. */
struct PreparedResponses
{
    const FrequencyResponses* responses = nullptr;
    Eigen::Index firstLine = 0;
    Eigen::VectorXd omega;         ///< N: rad/s, above 0.
    Eigen::VectorXd lineScale;     ///< N: times this, values are what was measured, but for a factor; 1 for velocities.
    Eigen::VectorXd lineWeights;   ///< N
    Eigen::VectorXd columnWeights; ///< C: 0 where nothing was measured.
    std::vector<MissingValue> missing; ///< Ascending in line.

    Eigen::Index lines() const { return omega.size(); }
    Eigen::Index points() const { return responses->points.rows(); }
    Eigen::Index references() const { return static_cast<Eigen::Index> (responses->references.size()); }
    Eigen::Index columns() const { return points() * references(); }
};

/** Chooses the lines between two frequencies. Columns without half of their values there have no weight; single missing
   values begin as interpolated between their neighbours. Weights are those under which the noise of what was measured
   is white, or the reciprocals of given variances as far as these are products.
    @throws InputError  when no line, or no column, has values
    [worker] */
PreparedResponses prepare (const FrequencyResponses&, double minimumFrequency, double maximumFrequency);

/** Values of neighbouring lines, real and imaginary parts on their own. Lines x C. */
struct DataBlock
{
    Eigen::MatrixXd real, imaginary;
};

/** Values of some lines, each line times a factor, for example exp (+i omega delay) to take the delay out; 0 in columns
   without weight.
    @param factors  one per line, from the first one on
    [worker] */
DataBlock dataBlock (const PreparedResponses&, Eigen::Index first, const Eigen::VectorXcd& factors);

/** exp (+i omega delay) on some lines: takes the delay out. [worker] */
Eigen::VectorXcd advances (const PreparedResponses&, Eigen::Index first, Eigen::Index count, double delay);
} // namespace antinode
