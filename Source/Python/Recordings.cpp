#include "Recordings.h"

#include <antinode_base/InputError.h>

#include <pybind11/numpy.h>

#include <algorithm>

namespace antinode
{
namespace py = pybind11;

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

PlayedRecording recordingOf (double sampleRate, const Eigen::MatrixXd& voltages, const Eigen::MatrixXd& signals)
{
    const auto samples = std::min (voltages.cols(), signals.cols());
    return { sampleRate, voltages.leftCols (samples), signals.leftCols (samples), {}, 0 };
}
} // namespace antinode
