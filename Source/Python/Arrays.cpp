#include "Arrays.h"

#include <antinode_base/InputError.h>

#include <pybind11/complex.h>

#include <algorithm>
#include <vector>

namespace antinode
{
namespace
{
namespace py = pybind11;

constexpr py::ssize_t bytes = sizeof (double);

py::array readOnly (std::vector<py::ssize_t> shape, std::vector<py::ssize_t> steps, const double* data,
                    const py::object& owner)
{
    py::array array (py::dtype::of<double>(), std::move (shape), std::move (steps), data, owner);
    py::detail::array_proxy (array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
    return array;
}
} // namespace

py::array readOnlyArray (const ArrayPlace& place, const py::object& owner)
{
    return readOnly ({ place.rows, place.columns }, { place.rowStep * bytes, place.columnStep * bytes }, place.data,
                     owner);
}

py::array copyOf (const Eigen::MatrixXcd& values)
{
    py::array_t<std::complex<double>, py::array::f_style> array ({ values.rows(), values.cols() });
    std::copy (values.data(), values.data() + values.size(), array.mutable_data());
    py::detail::array_proxy (array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
    return array;
}

py::array readOnlyVector (const ArrayPlace& place, const py::object& owner)
{
    return readOnly ({ place.rows }, { place.rowStep * bytes }, place.data, owner);
}

Eigen::MatrixXd matrixOf (const py::object& source, const std::string& name)
{
    const auto array = py::array_t<double, py::array::f_style | py::array::forcecast>::ensure (source);

    if (! array || array.ndim() != 2)
    {
        PyErr_Clear();
        throw InputError (name, "is not an array of two dimensions; allowed: one row per channel, one column per "
                                "sample");
    }

    Eigen::MatrixXd matrix = Eigen::Map<const Eigen::MatrixXd> (array.data(), array.shape (0), array.shape (1));

    if (! matrix.allFinite())
        throw InputError (name, "has numbers that are not finite; allowed: finite ones");

    return matrix;
}
} // namespace antinode
