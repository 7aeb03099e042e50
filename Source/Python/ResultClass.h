#pragma once

#include "Arrays.h"
#include "Pictures.h"
#include "Work.h"

#include <antinode_tasks/Field.h>
#include <pybind11/complex.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace antinode
{
/** The docstring of a task's function, which begins with its signature as inspect reads it; its stub is kept for
    `_stubs`. [any] */
std::string documented (const std::string& function, const TaskText&, const std::vector<Field>&,
                        const std::string& result);

/** The file of a device, which Python sees as a Device. */
struct DeviceText
{
    std::string text;
};

/** JSON, which Python sees as what it says. */
struct Json
{
    std::string text;
};

/** Adds to the types that the package declares: `_antinode.pyi` is made of them. [any] */
void keepStub (const std::string&);

/** All types that were kept. [any] */
const std::string& keptStubs();

/** A function of the package's `_plots`. [any] with the GIL */
pybind11::object plotBy (const char* function);

pybind11::object toPython (const DeviceText&);
pybind11::object toPython (const Json&);

/** "save(self, file: str) -> None" as inspect reads it: "save(self, file)". [any] */
std::string withoutTypes (const std::string& signature);

template <typename Value>
concept DenseNumbers = requires (const Value& value)
{
    []<typename Derived> (const Eigen::DenseBase<Derived>&) {}(value);
};

/** How a value is declared in Python. */
template <typename Value>
std::string typeInPython()
{
    if constexpr (DenseNumbers<Value>)
        return std::is_same_v<typename Value::Scalar, double> ? "Floats" : "Complexes";
    else if constexpr (std::is_same_v<Value, DeviceText>)
        return "_Device";
    else if constexpr (std::is_same_v<Value, Json>)
        return "dict[str, Any]";
    else if constexpr (std::is_same_v<Value, bool>)
        return "bool";
    else if constexpr (std::is_integral_v<Value>)
        return "int";
    else if constexpr (std::is_floating_point_v<Value>)
        return "float";
    else if constexpr (std::is_convertible_v<Value, std::string>)
        return "str";
    else if constexpr (requires {
                           typename Value::value_type;
                           Value().push_back (typename Value::value_type {});
                       })
        return "list[" + typeInPython<typename Value::value_type>() + "]";
    else if constexpr (requires {
                           typename Value::value_type;
                           Value().has_value();
                       })
        return "Optional[" + typeInPython<typename Value::value_type>() + "]";
    else
        return "Any";
}

/** A class of Python that shows a C++ value: each member is described, typed and bound in one place.
    [any] with the GIL */
template <typename Value>
class ResultClass
{
public:
    ResultClass (pybind11::module_& module, const std::string& name, const char* about)
        : bound (module, name.c_str(), pybind11::dynamic_attr(), about)
    {
        keepStub ("class " + name + ":\n");
        // Values do not change: a copy is the value itself.
        bound.def ("__copy__", [] (const pybind11::object& self) { return self; });
        bound.def ("__deepcopy__", [] (const pybind11::object& self, const pybind11::dict&) { return self; });
    }

    /** A property. Matrices that are given by reference, and blocks of them, are views.
        @param type  of Python; empty: by what the getter gives */
    template <typename Getter>
    ResultClass& has (const char* name, const char* about, const Getter& getter, std::string type = {})
    {
        using Given = std::invoke_result_t<Getter, const Value&>;
        keepStub ("    @property\n    def " + std::string (name) + "(self) -> "
                  + (type.empty() ? typeInPython<std::remove_cvref_t<Given>>() : type) + ": ...\n");
        bound.def_property_readonly (
            name,
            [getter] (const pybind11::object& self)
            { return shownBy<Given> (getter (self.cast<const Value&>()), self); },
            about);
        return *this;
    }

    /** A function. @param signature  with types: "save(self, file: Folder) -> None" */
    template <typename Function, typename... Extra>
    ResultClass& does (const std::string& signature, const std::string& about, const Function& function,
                       const Extra&... extra)
    {
        pybind11::options options;
        options.disable_function_signatures();
        keepStub ("    def " + signature + ": ...\n");
        const auto plain = withoutTypes (signature);
        bound.def (plain.substr (0, plain.find ('(')).c_str(), function, (plain + "\n--\n\n" + about).c_str(),
                   extra...);
        return *this;
    }

    /** The text between "<antinode." and ">". */
    template <typename Text>
    ResultClass& isShownAs (const Text& text)
    {
        bound.def ("__repr__", [text] (const Value& value) { return "<antinode." + text (value) + ">"; });
        return *this;
    }

    /** A picture by a function of the package's `_plots`. */
    ResultClass& plots (const char* function, const std::string& about)
    {
        return does ("plot(self) -> Any", about,
                     [function] (const pybind11::object& self) { return plotBy (function) (self); });
    }

    /** Pictures by a function of the value and a style; `png` is what notebooks show, too. */
    template <typename Draw>
    ResultClass& draws (const std::string& name, const std::string& about, const Draw& draw)
    {
        if (name == "png")
            showsInNotebooks ([draw] (const Value& value, const PictureStyle& style) { return draw (value, style); });

        return does (
            name + "(self, *, " + std::string (sizeArguments) + ") -> bytes", about,
            [draw] (const Value& value, int width, int height, float scale, const std::optional<std::string>& theme)
            {
                const auto style = styleOf (theme, width, height, scale);
                return drawn ([&] { return draw (value, style); });
            },
            pybind11::kw_only(), pybind11::arg ("width") = usualWidth, pybind11::arg ("height") = 0,
            pybind11::arg ("scale") = 1.0F, pybind11::arg ("theme") = pybind11::none());
    }

    /** The figures of its report: `figures`, and pictures of them. @param first  the one that notebooks show */
    template <typename Report>
    ResultClass& reports (const Report& report, int first = 0)
    {
        has ("figures", "The captions of the figures, in the order of the report.",
             [report] (const Value& value)
             { return Work (pybind11::none()).run ([&] { return figureCaptions (report (value)); }); });
        showsInNotebooks ([report, first] (const Value& value, const PictureStyle& style)
                          { return figurePicture (report (value), first, style); });
        return does (
            "png(self, *, " + std::string (sizeArguments) + ", figure: Optional[int] = None) -> bytes", figureHelp,
            [report, first] (const Value& value, int width, int height, float scale,
                             const std::optional<std::string>& theme, std::optional<int> figure)
            {
                const auto style = styleOf (theme, width, height, scale);
                return drawn ([&] { return figurePicture (report (value), figure.value_or (first), style); });
            },
            pybind11::kw_only(), pybind11::arg ("width") = usualWidth, pybind11::arg ("height") = 0,
            pybind11::arg ("scale") = 1.0F, pybind11::arg ("theme") = pybind11::none(),
            pybind11::arg ("figure") = pybind11::none());
    }

    /** "save(self, WHERE: Folder) -> None", by a function of the value and the path. */
    template <typename Save>
    ResultClass& saves (const std::string& where, const std::string& about, const Save& save)
    {
        return does (
            "save(self, " + where + ": Folder) -> None", about + "\n\nRaises:\n    InputError: it cannot be written.",
            [save] (const Value& value, const std::filesystem::path& path) { workAway ([&] { save (value, path); }); },
            pybind11::arg (where.c_str()));
    }

    pybind11::class_<Value, std::shared_ptr<Value>> bound;

private:
    static constexpr const char* sizeArguments =
        "width: int = 760, height: int = 0, scale: float = 1.0, theme: Optional[str] = None";
    static constexpr int usualWidth = 760;

    static PictureStyle styleOf (const std::optional<std::string>& theme, int width = usualWidth, int height = 0,
                                 float scale = 1)
    {
        return { width, height, scale, theme.value_or (usualTheme()) };
    }

    template <typename Draw>
    static pybind11::bytes drawn (const Draw& draw)
    {
        return Work (pybind11::none()).run (draw);
    }

    template <typename Draw>
    void showsInNotebooks (const Draw& draw)
    {
        bound.def ("_repr_png_",
                   [draw] (const Value& value)
                   {
                       const auto style = styleOf ({}); // Asks Python, which the drawing does not hold.
                       return drawn ([&] { return draw (value, style); });
                   });
    }

    template <typename Given>
    static pybind11::object shownBy (Given&& given, const pybind11::object& self)
    {
        using Plain = std::remove_cvref_t<Given>;

        if constexpr (std::is_same_v<Plain, DeviceText> || std::is_same_v<Plain, Json>)
            return toPython (given);
        else if constexpr (DenseNumbers<Plain>)
        {
            if constexpr (std::is_lvalue_reference_v<
                              Given> || ! std::is_base_of_v<Eigen::PlainObjectBase<Plain>, Plain>)
                return viewOf (given, self);
            else
                return arrayOf (std::move (given));
        }
        else if constexpr (requires {
                               requires DenseNumbers<typename Plain::value_type>;
                               given.has_value();
                           })
            return given ? pybind11::object (arrayOf (std::move (*given))) : pybind11::none();
        else if constexpr (std::is_base_of_v<pybind11::object, Plain>)
            return given;
        else
            return pybind11::cast (std::forward<Given> (given));
    }
};
} // namespace antinode
