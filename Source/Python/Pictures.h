#pragma once

#include <antinode_charts/Chart.h>
#include <antinode_focus/FocusDesign.h>
#include <antinode_model/ModalModel.h>

#include <pybind11/pybind11.h>

#include <string>

namespace antinode
{
/** The size and the look of a picture. */
struct PictureStyle
{
    int width = 760, height = 0; ///< Pixels at scale 1; a height of 0 follows from what is drawn.
    float scale = 1;
    std::string theme; ///< "light", "dark" or "print".
};

/** A chart as PNG. @param usualHeight  where the style says none
    @throws InputError  for a theme or size that is not allowed [worker] */
std::string picture (const Chart&, const PictureStyle&, int usualHeight);

/** A velocity field: on a line what was wanted and represented as well, on a plate a map of what was reached. [worker]
    @param reached  N_p, m/s */
std::string fieldPicture (const ModalModel&, const FocusDesign&, const Eigen::VectorXd& reached, const PictureStyle&);

/** Names the style of pictures for Python. [any] with the GIL */
void bindPictures (pybind11::module_&);
} // namespace antinode
