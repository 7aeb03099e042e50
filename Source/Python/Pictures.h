#pragma once

#include "Work.h"

#include <antinode_charts/Chart.h>
#include <antinode_focus/FocusDesign.h>
#include <antinode_model/ModalModel.h>
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

/** Gives a bound value the figures of its report: `captions ()` and `figure_png (figure, style)`.
    @param report  makes the page of a value
    [any] with the GIL */
template <typename Bound, typename Report>
void bindFigures (Bound& bound, const Report& report)
{
    using Value = typename Bound::type;
    bound.def ("captions", [report] (const Value& value)
               { return Work (pybind11::none()).run ([&] { return figureCaptions (report (value)); }); });
    bound.def ("figure_png",
               [report] (const Value& value, int figure, const PictureStyle& style)
               {
                   return pybind11::bytes (
                       Work (pybind11::none()).run ([&] { return figurePicture (report (value), figure, style); }));
               });
}

/** Names the style of pictures for Python. [any] with the GIL */
void bindPictures (pybind11::module_&);
} // namespace antinode
