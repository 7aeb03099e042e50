#include "ArrayViews.h"
#include "Bindings.h"
#include "Pictures.h"
#include "Values.h"
#include "Work.h"

#include <antinode_base/Prefixes.h>
#include <antinode_charts/ModeCharts.h>
#include <antinode_charts/PlateCharts.h>
#include <antinode_documents/ModeTable.h>
#include <antinode_documents/UniversalModes.h>
#include <antinode_library/Library.h>
#include <antinode_universal/UniversalFile.h>

#include <pybind11/stl.h>

namespace antinode
{
namespace
{
namespace py = pybind11;

using Modes = std::shared_ptr<ModesValue>;

Modes solvedModes (const DeviceValue& device, std::optional<int> count, bool usesCache)
{
    return Work (py::none())
        .run (
            [&] {
                return std::make_shared<ModesValue> (ModesValue { solveDevice (device.description, count, usesCache) });
            });
}

Eigen::VectorXd frequencies (const ModalModel& model)
{
    Eigen::VectorXd hertz (model.modes());

    for (Eigen::Index k = 0; k < model.modes(); ++k)
        hertz[k] = model.frequencyHz (k);

    return hertz;
}

std::vector<std::string> ceramicNames (const ModalModel& model)
{
    std::vector<std::string> names;

    for (const auto& ceramic : model.ceramics)
        names.push_back (ceramic.name);

    return names;
}

/** Columns of complex modes that lie behind those of their real parts. */
py::object imaginaryShapes (const py::object& self)
{
    const auto& model = self.cast<const ModesValue&>().model;
    return model.hasComplexModes() ? py::object (viewOf (model.shapes.rightCols (model.modes()), self)) : py::none();
}

py::object imaginaryParticipation (const py::object& self)
{
    const auto& model = self.cast<const ModesValue&>().model;
    return model.hasComplexModes() ? py::object (viewOf (model.participation.bottomRows (model.modes()), self))
                                   : py::none();
}

/** Where numbers lie in memory, for checking that arrays are views. */
py::dict addresses (const ModalModel& model)
{
    const auto address = [] (const double* numbers) { return reinterpret_cast<std::uintptr_t> (numbers); };
    py::dict all;
    all["angular_frequencies_rad_s"] = address (model.angularFrequencies.data());
    all["damping_ratios"] = address (model.dampingRatios.data());
    all["shapes"] = address (model.shapes.data());
    all["participation"] = address (model.participation.data());
    all["points_m"] = address (model.surface.points.data());
    return all;
}

py::bytes devicePicture (const ModesValue& modes, const PictureStyle& style)
{
    const auto& surface = modes.model.surface;
    constexpr int heightOnLine = 160;
    const auto height =
        surface.kind == SurfaceKind::plate ? plateFigureHeight (surface, style.width, 1, 1) : heightOnLine;
    return Work (py::none()).run ([&] { return picture (deviceChart (modes.model), style, height); });
}

py::bytes galleryPicture (const ModesValue& modes, int count, const PictureStyle& style)
{
    return Work (py::none())
        .run (
            [&]
            {
                return picture (modeGallery (modes.model, count), style,
                                comfortableGalleryHeight (modes.model, count, style.width));
            });
}

void bindArrays (py::class_<ModesValue, Modes>& bound)
{
    bound.def_property_readonly ("frequencies_Hz",
                                 [] (const ModesValue& value) { return arrayOf (frequencies (value.model)); });
    bound.def_property_readonly (
        "angular_frequencies_rad_s",
        viewProperty<ModesValue> ([] (const ModesValue& value) { return &value.model.angularFrequencies; }));
    bound.def_property_readonly ("damping_ratios", viewProperty<ModesValue> ([] (const ModesValue& value)
                                                                             { return &value.model.dampingRatios; }));
    bound.def_property_readonly (
        "shapes", viewProperty<ModesValue> ([] (const ModesValue& value)
                                            { return value.model.shapes.leftCols (value.model.modes()); }));
    bound.def_property_readonly ("shapes_imaginary", &imaginaryShapes);
    bound.def_property_readonly (
        "participation",
        viewProperty<ModesValue> ([] (const ModesValue& value)
                                  { return value.model.participation.topRows (value.model.modes()); }));
    bound.def_property_readonly ("participation_imaginary", &imaginaryParticipation);
    bound.def_property_readonly (
        "points_m", viewProperty<ModesValue> ([] (const ModesValue& value) { return &value.model.surface.points; }));
    bound.def_property_readonly (
        "masses_kg", viewProperty<ModesValue> ([] (const ModesValue& value) { return &value.model.surface.masses; }));
    bound.def_property_readonly (
        "frequency_errors",
        viewProperty<ModesValue> ([] (const ModesValue& value) { return &value.model.frequencyErrors; }));
    bound.def ("shapes_at", [] (const ModesValue& value, double x, double y)
               { return arrayOf (Eigen::VectorXd (shapesAt (value.model, x / milli, y / milli).transpose())); });
    bound.def ("addresses", [] (const ModesValue& value) { return addresses (value.model); });
}
} // namespace

void bindModes (py::module_& module)
{
    bindPictures (module);
    py::class_<ModesValue, Modes> modes (module, "Modes");
    modes.def_static ("solve", &solvedModes);
    modes.def_property_readonly ("device", [] (const ModesValue& value) { return value.model.name; });
    modes.def_property_readonly ("is_plate", [] (const ModesValue& value)
                                 { return value.model.surface.kind == SurfaceKind::plate; });
    modes.def_property_readonly ("ceramics", [] (const ModesValue& value) { return ceramicNames (value.model); });
    modes.def_property_readonly ("rigid_body_modes",
                                 [] (const ModesValue& value) { return value.model.rigidBodyModes; });
    modes.def_property_readonly ("warnings", [] (const ModesValue& value) { return value.model.warnings; });
    modes.def ("csv", [] (const ModesValue& value) { return encodeModeTable (value.model); });
    modes.def ("universal_file",
               [] (const ModesValue& value) { return py::bytes (encodeUniversalFile (modeSets (value.model))); });
    modes.def ("device_png", &devicePicture);
    modes.def ("gallery_png", &galleryPicture);
    bindArrays (modes);
}
} // namespace antinode
