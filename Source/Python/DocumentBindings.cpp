#include "Bindings.h"
#include "Values.h"

#include <antinode_documents/DeviceFile.h>
#include <antinode_documents/FocusFile.h>
#include <antinode_documents/Inputs.h>
#include <antinode_documents/NamedDevice.h>
#include <antinode_documents/WaveformsFile.h>
#include <antinode_structure/DeviceKind.h>
#include <antinode_text/JsonReader.h>
#include <antinode_text/JsonText.h>

#include <nlohmann/json.hpp>

#include <pybind11/stl.h>

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
} // namespace antinode
