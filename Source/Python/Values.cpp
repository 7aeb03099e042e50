#include "Values.h"

#include "Module.h"
#include "ResultClass.h"

#include <antinode_base/Prefixes.h>
#include <antinode_documents/DeviceFile.h>
#include <antinode_documents/FocusFile.h>
#include <antinode_documents/Inputs.h>
#include <antinode_documents/Library.h>
#include <antinode_documents/SharedFields.h>
#include <antinode_documents/TableExport.h>
#include <antinode_documents/UniversalModes.h>
#include <antinode_documents/WaveformsFile.h>
#include <antinode_reports/ModesReport.h>
#include <antinode_reports/PlateCharts.h>
#include <antinode_responses/UniversalFile.h>
#include <antinode_structure/DeviceDescription.h>
#include <antinode_text/JsonReader.h>
#include <antinode_text/JsonText.h>
#include <antinode_text/OutputFolder.h>
#include <pybind11/stl.h>

#include <nlohmann/json.hpp>

#include <filesystem>

namespace antinode
{
namespace
{
namespace py = pybind11;

using Assignments = std::vector<std::string>;

/** Where a document comes from, and how errors name it. */
struct Source
{
    std::string nameOrFile; ///< Empty where the document itself was given.
    std::string text;       ///< The document.
    std::string word;       ///< "device", for what was given.

    std::string forErrors (LibraryKind kind) const
    {
        return nameOrFile.empty() ? word : documentSource (kind, nameOrFile);
    }

    std::string fallbackName() const
    {
        return nameOrFile.empty() ? word : std::filesystem::path (nameOrFile).stem().string();
    }
};

/** The document of a source with values set, each "targets.0.x_mm=24". */
nlohmann::json documentOf (LibraryKind kind, const Source& source, const Assignments& assignments)
{
    auto document =
        source.nameOrFile.empty() ? parseJson (source.text, source.word) : loadDocument (kind, source.nameOrFile);

    for (const auto& assignment : assignments)
        applyAssignment (document, assignment);

    return document;
}

/** The file of a device that a document names, from the folder of the document's own file, as an absolute name: so the
    document still names it when it is changed, kept elsewhere or sent to another process. */
void resolveDevice (nlohmann::json& document, const Source& source)
{
    if (source.nameOrFile.empty() || ! isFileName (source.nameOrFile) || ! document.is_object())
        return;

    const auto found = document.find ("device");

    if (found != document.end() && found->is_string() && isFileName (found->get<std::string>()))
        *found = std::filesystem::absolute (std::filesystem::path (source.nameOrFile).parent_path()
                                            / found->get<std::string>())
                     .lexically_normal()
                     .string();
}

/** The name or file of the device that a document names; empty: it names none. */
std::string deviceNamedBy (const nlohmann::json& document, const std::string& source)
{
    const JsonValue value (document, source);
    return value.isObject() ? readNamedDevice (value.find ("device")) : std::string();
}

DeviceValue deviceOf (const Source& source, const Assignments& assignments)
{
    auto document = documentOf (LibraryKind::device, source, assignments);
    auto description = readDevice (document, source.forErrors (LibraryKind::device));
    return { document.dump(), std::move (description) };
}

FocusValue focusOf (const Source& source, const Assignments& assignments)
{
    auto document = documentOf (LibraryKind::focus, source, assignments);
    resolveDevice (document, source);
    auto description = focusFromDocument (document, source.forErrors (LibraryKind::focus), source.fallbackName());
    return { document.dump(), std::move (description),
             deviceNamedBy (document, source.forErrors (LibraryKind::focus)) };
}

WaveformsValue waveformsOf (const Source& source, const Assignments& assignments)
{
    auto document = documentOf (LibraryKind::waveforms, source, assignments);
    resolveDevice (document, source);
    auto description = waveformsFromDocument (document, source.forErrors (LibraryKind::waveforms),
                                              source.nameOrFile.empty() ? "waveforms" : source.nameOrFile);
    return { document.dump(), std::move (description),
             deviceNamedBy (document, source.forErrors (LibraryKind::waveforms)) };
}

/** A value that is made from a name or file, or from the text of a document. */
template <typename Value>
auto bindDocument (py::module_& module, const char* name, const char* word,
                   Value (*make) (const Source&, const Assignments&))
{
    return py::class_<Value, std::shared_ptr<Value>> (module, name)
        .def_static ("load",
                     [make] (const std::string& nameOrFile, const Assignments& assignments) {
                         return std::make_shared<Value> (make ({ nameOrFile, {}, {} }, assignments));
                     })
        .def_static ("parse",
                     [make, word] (const std::string& text, const Assignments& assignments) {
                         return std::make_shared<Value> (make ({ {}, text, word }, assignments));
                     })
        .def_property_readonly ("name", [] (const Value& value) { return value.description.name; })
        .def_property_readonly ("document", [] (const Value& value) { return value.document; });
}

const char* kindOf (const DeviceValue& device)
{
    return deviceKind (device.description);
}
} // namespace

void bindDocuments (py::module_& module)
{
    bindDocument (module, "Device", "device", &deviceOf).def_property_readonly ("kind", &kindOf);
    bindDocument (module, "Focus", "focus", &focusOf)
        .def_property_readonly ("device", [] (const FocusValue& value) { return value.device; });
    bindDocument (module, "Waveforms", "waveforms", &waveformsOf)
        .def_property_readonly ("device", [] (const WaveformsValue& value) { return value.device; });
    module.def ("embedded_names",
                [] (const std::string& kind)
                {
                    return factoryNames (kind == "device"  ? LibraryKind::device
                                         : kind == "focus" ? LibraryKind::focus
                                                           : LibraryKind::waveforms);
                });
}

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

/** Columns or rows of complex modes that lie behind those of their real parts; else None. */
template <typename Part>
auto imaginary (const Part& part)
{
    return [part] (const ModesValue& value) -> std::optional<Eigen::MatrixXd>
    {
        if (! value.model.hasComplexModes())
            return {};

        return Eigen::MatrixXd (part (value.model));
    };
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

std::string devicePicture (const ModesValue& modes, const PictureStyle& style)
{
    const auto& surface = modes.model.surface;
    constexpr int heightOnLine = 160;
    const auto height =
        surface.kind == SurfaceKind::plate ? plateFigureHeight (surface, style.width, 1, 1) : heightOnLine;
    return picture (deviceChart (modes.model), style, height);
}

std::string galleryPicture (const ModesValue& modes, const PictureStyle& style)
{
    constexpr int count = 12;
    return picture (modeGallery (modes.model, count), style,
                    comfortableGalleryHeight (modes.model, count, style.width));
}
} // namespace

void bindModes (py::module_& module)
{
    using Value = ModesValue;
    constexpr const char* about =
        "The modes of a device: N_m modes, N_p points of the surface, N_b ceramics. Made by "
        ":meth:`antinode.Device.modes`.\n\n"
        "All arrays are read-only. Those that are not computed from others are views of the memory of the model, which "
        "they "
        "keep alive. Modes count from 0 here, and from 1 in files.\n\nSource: Docs/Theory.md, section 1.";
    bindPictures (module);
    ResultClass<Value> modes (module, "Modes", about);
    modes
        .isShownAs (
            [] (const Value& value)
            {
                return "Modes of '" + value.model.name + "': " + std::to_string (value.model.modes()) + " modes, "
                       + std::to_string (value.model.actuators()) + " ceramics";
            })
        .has ("device", "The name of the device.", [] (const Value& value) { return value.model.name; })
        .has ("frequencies_Hz", "N_m: the undamped frequencies, Hz, ascending.",
              [] (const Value& value) { return frequencies (value.model); })
        .has ("angular_frequencies_rad_s", "N_m: the same, rad/s. A view.",
              [] (const Value& value) -> const Eigen::VectorXd& { return value.model.angularFrequencies; })
        .has ("damping_ratios", "N_m: of critical damping. A view.",
              [] (const Value& value) -> const Eigen::VectorXd& { return value.model.dampingRatios; })
        .has ("participation", "N_m x N_b: modal force per volt, N kg^-1/2 / V. A view.",
              [] (const Value& value) { return value.model.participation.topRows (value.model.modes()); })
        .has ("participation_imaginary", "N_m x N_b: the imaginary part where modes are complex, else None.",
              imaginary ([] (const ModalModel& model) { return model.participation.bottomRows (model.modes()); }))
        .has ("shapes", "N_p x N_m: displacement normal to the surface, mass-normalised, kg^-1/2. A view.",
              [] (const Value& value) { return value.model.shapes.leftCols (value.model.modes()); })
        .has ("shapes_imaginary", "N_p x N_m: the imaginary part where modes are complex, else None.",
              imaginary ([] (const ModalModel& model) { return model.shapes.rightCols (model.modes()); }))
        .has ("points_m", "N_p x 2: x and y of the points, m. A view.",
              [] (const Value& value) -> const Eigen::MatrixX2d& { return value.model.surface.points; })
        .has ("masses_kg", "N_p: the mass that each point stands for, kg. A view.",
              [] (const Value& value) -> const Eigen::VectorXd& { return value.model.surface.masses; })
        .has ("frequency_errors",
              "N_m: the estimated relative error of each frequency; empty where it is unknown. A view.",
              [] (const Value& value) -> const Eigen::VectorXd& { return value.model.frequencyErrors; })
        .has ("ceramics", "N_b names, in the order of the channels.",
              [] (const Value& value) { return ceramicNames (value.model); })
        .has ("rigid_body_modes", "How many modes of frequency 0 there are, which are not listed.",
              [] (const Value& value) { return value.model.rigidBodyModes; })
        .has ("warnings", "Sentences about the accuracy of the model.",
              [] (const Value& value) { return value.model.warnings; })
        .does (
            "shapes_at(self, x_mm: float, y_mm: float = 0.0) -> Floats",
            "The shapes of all modes at one place, kg^-1/2: N_m values, or 2 N_m for complex modes, imaginary parts "
            "last.\n\nRaises:\n    InputError: the place is outside the surface.\n\n"
            "Source: Docs/Theory.md, section 1.5.",
            [] (const Value& value, double x, double y)
            { return arrayOf (Eigen::VectorXd (shapesAt (value.model, x / milli, y / milli).transpose())); },
            py::arg ("x_mm"), py::arg ("y_mm") = 0.0)
        .does (
            "to_csv(self, file: Folder) -> None", "Writes the table of ``antinode modes --csv``.",
            [] (const Value& value, const std::filesystem::path& file)
            { workAway ([&] { writeWholeFile (file, encodeModeTable (value.model)); }); },
            py::arg ("file"))
        .does (
            "to_universal_file(self, file: Folder) -> None",
            "Writes frequencies and shapes as ``antinode modes --uff``.",
            [] (const Value& value, const std::filesystem::path& file)
            { workAway ([&] { writeWholeFile (file, encodeUniversalFile (modeSets (value.model))); }); },
            py::arg ("file"))
        .draws ("png", pictureHelp, &galleryPicture)
        .does (
            "plot(self, mode: int = 0) -> Any", "The shape of a mode (from 0) as a Matplotlib figure.",
            [] (const py::object& self, int mode) { return plotBy ("plot_mode") (self, mode); }, py::arg ("mode") = 0);
    modes.bound.def ("__len__", [] (const Value& value) { return value.model.modes(); });
    modes.bound.def_static ("_solve", &solvedModes);
    modes.bound.def ("_device_png", [] (const Value& value, const PictureStyle& style)
                     { return py::bytes (Work (py::none()).run ([&] { return devicePicture (value, style); })); });
    modes.bound.def_property_readonly ("_is_plate", [] (const Value& value)
                                       { return value.model.surface.kind == SurfaceKind::plate; });
    modes.bound.def ("_addresses", [] (const Value& value) { return addresses (value.model); });
    keepStub ("    def __len__(self) -> int: ...\n"
              "    @staticmethod\n    def _solve(device: Device, count: Optional[int], cache: bool) -> Modes: ...\n"
              "    def _device_png(self, style: PictureStyle) -> bytes: ...\n"
              "    @property\n    def _is_plate(self) -> bool: ...\n");
}
} // namespace antinode
