#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

namespace antinode
{
/** A matrix in a MATLAB file. */
struct MatlabMatrix
{
    std::string name; ///< 1 to 63 letters, digits and '_', a letter first.
    Eigen::MatrixXd real;
    Eigen::MatrixXd imaginary; ///< As large; empty where numbers are real.
    bool mayLack = false;      ///< Whether NaN is allowed, for numbers that there are not.
};

/** Matrices as a MATLAB file of level 5 (versions 5 to 7), uncompressed, little-endian: the same matrices give the same
    bytes.
    @throws InputError  when a number is not finite where none may be lacking, is infinite, or a matrix takes 2 GiB or
   more [worker] MATLAB, MAT-File Format, The MathWorks. */
std::string encodeMatlabFile (const std::vector<MatlabMatrix>&);
} // namespace antinode
