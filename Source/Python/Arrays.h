#pragma once

#include <Eigen/Core>

#include <pybind11/numpy.h>

#include <memory>
#include <string>
#include <utility>

namespace antinode
{
/** Where an array lies: its first number, and the steps between rows and columns in numbers. */
struct ArrayPlace
{
    const double* data = nullptr;
    pybind11::ssize_t rows = 0, columns = 0, rowStep = 0, columnStep = 0;
};

/** Numbers as a NumPy array that cannot be written, on the memory where they are.
    @param owner  what owns that memory: the array keeps it alive
    @return       rows x columns
    [any] with the GIL */
pybind11::array readOnlyArray (const ArrayPlace&, const pybind11::object& owner);

/** The same of one column, as an array of one dimension. */
pybind11::array readOnlyVector (const ArrayPlace&, const pybind11::object& owner);

/** A matrix, or a block of one, as an array on its own memory. [any] with the GIL */
template <typename Derived>
pybind11::array viewOf (const Eigen::DenseBase<Derived>& matrix, const pybind11::object& owner)
{
    const auto& dense = matrix.derived();
    const ArrayPlace place { dense.data(), dense.rows(), dense.cols(), dense.rowStride(), dense.colStride() };
    return Derived::ColsAtCompileTime == 1 ? readOnlyVector (place, owner) : readOnlyArray (place, owner);
}

/** Numbers that were computed for this call, as an array that owns them. [any] with the GIL */
template <typename Matrix>
pybind11::array arrayOf (Matrix computed)
{
    auto kept = std::make_unique<Matrix> (std::move (computed));
    const auto* const matrix = kept.get();
    const pybind11::capsule owner (kept.release(), [] (void* memory) { delete static_cast<Matrix*> (memory); });
    return viewOf (*matrix, owner);
}

/** Complex numbers as an array of their own that cannot be written. [any] with the GIL */
pybind11::array copyOf (const Eigen::MatrixXcd&);

/** An array of two dimensions of Python as a matrix. @param name  how errors name it
    @throws InputError  where it is none, or a number is not finite
    [any] with the GIL */
Eigen::MatrixXd matrixOf (const pybind11::object& array, const std::string& name);
} // namespace antinode
