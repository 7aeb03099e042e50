#pragma once

#include <antinode_learning/PlayedRecording.h>

#include <pybind11/pybind11.h>

#include <string>

namespace antinode
{
/** An array of two dimensions of Python as a matrix. @param name  how errors name it
    @throws InputError  where it is none, or a number is not finite
    [any] with the GIL */
Eigen::MatrixXd matrixOf (const pybind11::object& array, const std::string& name);

/** What was played, N_b x N_s, and recorded, one row per sensor; as long as the shorter of them. [any] */
PlayedRecording recordingOf (double sampleRate, const Eigen::MatrixXd& voltages, const Eigen::MatrixXd& signals);
} // namespace antinode
