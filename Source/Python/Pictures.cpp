#include "Pictures.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_reports/ChartFile.h>
#include <antinode_reports/FocusCharts.h>
#include <antinode_reports/PlateCharts.h>
#include <antinode_reports/Theme.h>

namespace antinode
{
namespace
{
constexpr int lineHeight = 400; // pixels, as in reports

const Theme& themeNamed (const std::string& name)
{
    if (name == "light")
        return Theme::light();

    if (name == "dark")
        return Theme::dark();

    if (name == "print")
        return Theme::print();

    throw InputError ("theme", "is " + inQuotes (name) + "; allowed: light, dark, print");
}

std::vector<const ReportFigure*> figuresOf (const ReportPage& page)
{
    std::vector<const ReportFigure*> figures;

    for (const auto& section : page.sections)
        for (const auto& figure : section.figures)
            figures.push_back (&figure);

    return figures;
}
} // namespace

std::string picture (const Chart& chart, const PictureStyle& style, int usualHeight)
{
    return renderPng (chart, style.width, style.height > 0 ? style.height : usualHeight, style.scale,
                      themeNamed (style.theme));
}

std::string fieldPicture (const ModalModel& model, const FocusDesign& design, const Eigen::VectorXd& reached,
                          const PictureStyle& style)
{
    if (model.surface.kind == SurfaceKind::plate)
        return picture (plateFieldChart (model, reached, "velocity", design.description.targets), style,
                        plateFigureHeight (model.surface, style.width, 1, 1));

    return picture (fieldChart (model, design.target.field, design.truncatedField, reached), style, lineHeight);
}

std::vector<std::string> figureCaptions (const ReportPage& page)
{
    std::vector<std::string> captions;

    for (const auto* const figure : figuresOf (page))
        captions.push_back (figure->caption);

    return captions;
}

std::string figurePicture (const ReportPage& page, int index, const PictureStyle& style)
{
    const auto figures = figuresOf (page);

    if (index < 0 || static_cast<std::size_t> (index) >= figures.size())
        throw InputError ("figure", "is " + std::to_string (index) + "; allowed: 0 to "
                                        + std::to_string (static_cast<long> (figures.size()) - 1));

    const auto& figure = *figures[static_cast<std::size_t> (index)];
    return picture (figure.chart, style, figure.height * style.width / figure.width);
}

std::string usualTheme()
{
    return pybind11::module_::import ("antinode._pictures").attr ("_theme").cast<std::string>();
}

void bindPictures (pybind11::module_& module)
{
    namespace py = pybind11;
    py::class_<PictureStyle> (module, "PictureStyle")
        .def (py::init<int, int, float, std::string>(), py::arg ("width"), py::arg ("height"), py::arg ("scale"),
              py::arg ("theme"));
}
} // namespace antinode
