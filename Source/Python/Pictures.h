#pragma once

#include "Work.h"

#include <antinode_focus/FocusDesign.h>
#include <antinode_model/ModalModel.h>
#include <antinode_reports/Chart.h>
#include <antinode_reports/Report.h>

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

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

/** The captions of the figures of a report, in their order. [any] */
std::vector<std::string> figureCaptions (const ReportPage&);

/** A figure of a report as PNG. @param figure  from 0
    @throws InputError  where there is no such figure, and as picture [worker] */
std::string figurePicture (const ReportPage&, int figure, const PictureStyle&);

/** The theme that was set for notebooks. [any] with the GIL */
std::string usualTheme();

/** The docstring of `png`, and of that of a report. */
inline constexpr const char* pictureHelp =
    "The picture as the bytes of a PNG file.\n\nArgs:\n"
    "    width, height: pixels at scale 1, 16 to 8192; a height of 0 follows from what is drawn.\n"
    "    scale: pixels of the file for each of these, 0.25 to 8; 2 for dense screens.\n"
    "    theme: 'light', 'dark' or 'print'; None: that of :func:`antinode.set_theme`.";
inline constexpr const char* figureHelp =
    "A figure as the bytes of a PNG file.\n\nArgs:\n"
    "    width, height, scale, theme: as of every picture: pixels at scale 1, pixels of the file for each of these.\n"
    "    figure: which one of ``figures``, from 0; None: the one that notebooks show.\n\n"
    "Raises:\n    InputError: there is no such figure, size or theme.";

/** Names the style of pictures for Python. [any] with the GIL */
void bindPictures (pybind11::module_&);
} // namespace antinode
