#include "ResultClass.h"

#include <antinode_base/MessageText.h>

#include <cctype>

namespace antinode
{
namespace
{
/** How a field is declared in Python: its type, and its default as a literal. */
class Declaration
{
public:
    explicit Declaration (const Field& declared) : field (declared)
    {
        std::visit (*this, field.value);

        if (field.isRequired)
            otherwise.clear();
    }

    void operator() (const bool* value) { say ("bool", *value ? "True" : "False"); }
    void operator() (const int* value) { say ("int", std::to_string (*value)); }
    void operator() (const std::uint64_t* value) { say ("int", std::to_string (*value)); }
    void operator() (const double* value) { say ("float", fieldNumber (*value * field.perUnit)); }
    void operator() (const std::optional<int>*) { say ("Optional[int]", "None"); }
    void operator() (const std::optional<double>*) { say ("Optional[float]", "None"); }
    void operator() (const std::string* value) { say ("str", "'" + *value + "'"); }
    void operator() (const std::optional<std::string>*) { say ("Optional[str]", "None"); }
    void operator() (const std::filesystem::path*) { say (field.isRequired ? "Folder" : "Optional[Folder]", "None"); }
    void operator() (const std::vector<std::string>*) { say ("Sequence[str]", "()"); }
    void operator() (const std::vector<double>*) { say ("Sequence[float]", "()"); }
    void operator() (const std::vector<int>*) { say ("Iterable[int]", "()"); }
    void operator() (const WordFlag&) {}
    void operator() (const TextRows&) {}
    void operator() (const FocusSeries& value) { (*this) (value.focus); }
    void operator() (const FocusOrDesign&) { say ("Union[Source, _Focus, Design]", "'" + field.usual + "'"); }
    void operator() (const Eigen::MatrixX2d*) { say ("Iterable[Probe]", "()"); }
    void operator() (const std::optional<Eigen::MatrixXd>*) { say ("Any", "None"); }
    void operator() (const PlayFunction*) { say ("Optional[Callable[[Floats, int], Any]]", "None"); }
    void operator() (const std::vector<DeviceDescription>*) { say ("Iterable[Union[Source, _Device]]", "()"); }
    void operator() (const OptionalDevice&) { say ("Union[None, Source, _Device]", "None"); }
    void operator() (const FocusDescription*) { say ("Union[Source, _Focus]", "'" + field.usual + "'"); }
    void operator() (const std::vector<FocusDescription>*) { say ("Iterable[Union[Source, _Focus]]", "()"); }
    void operator() (const WaveformsDescription*) { say ("Union[Source, _Waveforms]", "'" + field.usual + "'"); }
    void operator() (const OptionalWaveforms&) { say ("Union[None, Source, _Waveforms]", "None"); }
    void operator() (const OptionalSheet&) { say ("Union[None, Folder, Excitation]", "None"); }

    void operator() (const std::vector<std::filesystem::path>*)
    {
        isVariadic = field.isPositional;
        say (isVariadic ? "Folder" : "Iterable[Folder]", isVariadic ? "" : "()");
    }

    void operator() (const NumberRows& rows)
    {
        const std::string row = rows.least == 1 ? "Probe" : "Sequence[float]";
        rows.repeats ? say ("Iterable[" + row + "]", "()") : say ("Optional[" + row + "]", "None");
    }

    void operator() (const DeviceDescription*)
    {
        const auto isNamed = field.otherwise.empty() && ! field.usual.empty();
        say (field.otherwise.empty() ? "Union[Source, _Device]" : "Union[None, Source, _Device]",
             isNamed ? "'" + field.usual + "'" : "None");
    }

    std::string type, otherwise;
    bool isVariadic = false;

private:
    void say (std::string declared, std::string usual)
    {
        type = std::move (declared);
        otherwise = std::move (usual);
    }

    const Field& field;
};

/** "device, *files, cache=True, progress=None". @param isTyped  with the types, as a stub has it */
std::string parametersOf (const std::vector<Field>& fields, bool isTyped)
{
    std::string positions, named, variadic;

    for (const auto& field : fields)
    {
        if (field.keyword.empty())
            continue;

        const Declaration declaration (field);
        const auto typed = field.keyword + (isTyped ? ": " + declaration.type : "");
        const auto whole =
            typed + (declaration.otherwise.empty() ? "" : (isTyped ? " = " : "=") + declaration.otherwise);

        if (declaration.isVariadic)
            variadic = "*" + typed + ", ";
        else
            (field.isPositional ? positions : named) += whole + ", ";
    }

    return positions + (variadic.empty() ? "*, " : variadic) + named
           + (isTyped ? "progress: ShownBy = None" : "progress=None");
}

std::string argumentText (const Field& field)
{
    const auto* const flag = std::get_if<bool*> (&field.value);
    auto sentence = field.text.substr (0, field.text.find (" (repeatable"));

    if (flag != nullptr && **flag && field.option.starts_with ("--")) // The option takes away.
        sentence =
            "False: " + std::string (1, static_cast<char> (std::tolower (sentence.front()))) + sentence.substr (1);

    if (std::holds_alternative<Eigen::MatrixX2d*> (field.value))
        sentence += ": x, or x and y, mm";

    if (const auto named = sentence.find (": an embedded name"); named != std::string::npos)
        sentence.replace (named, std::string::npos, ": a name, a file, a dict, or a value of the package");

    if (std::holds_alternative<FocusOrDesign> (field.value))
        sentence += "; or a :class:`Design`, which is played as it is";

    auto text = field.keyword + ": " + sentence;

    if (! field.words.empty())
        text += ": " + listed ({ field.words.begin(), field.words.end() });

    if (field.range)
        text += "; " + rangeInWords (*field.range);

    if (! field.otherwise.empty())
        text += (Declaration (field).otherwise == "None" ? "; None: " : "; default: ") + field.otherwise;

    return text;
}
} // namespace

std::string documented (const std::string& function, const TaskText& text, const std::vector<Field>& fields,
                        const std::string& result)
{
    keepStub ("def " + function + "(" + parametersOf (fields, true) + ") -> " + result + ": ...\n");
    auto documentation = function + "(" + parametersOf (fields, false) + ")\n--\n\n" + text.summary + ", as ``antinode "
                         + text.name + "``.\n\nArgs:\n";

    for (const auto& field : fields)
        if (! field.keyword.empty())
            documentation += "    " + argumentText (field) + ".\n";

    return documentation
           + "    progress: a function of the current step and its share, 0 to 1; True: a bar of tqdm if it is "
             "installed.\n\nReturns:\n    :class:`"
           + result
           + "`.\n\nRaises:\n    InputError: an argument is not allowed, or a file cannot be read.\n"
             "    LimitError: a focus is not reached within the limits of the device.\n"
             "    KeyboardInterrupt: Ctrl+C.\n\nSource: "
           + text.source + ".\n";
}

namespace
{
std::string& stubs()
{
    static std::string text;
    return text;
}
} // namespace

void keepStub (const std::string& text)
{
    stubs() += text;
}

const std::string& keptStubs()
{
    return stubs();
}

pybind11::object plotBy (const char* function)
{
    return pybind11::module_::import ("antinode._plots").attr (function);
}

pybind11::object toPython (const Json& json)
{
    return pybind11::module_::import ("json").attr ("loads") (json.text);
}

pybind11::object toPython (const DeviceText& device)
{
    return pybind11::module_::import ("antinode._documents").attr ("device") (toPython (Json { device.text }));
}

std::string withoutTypes (const std::string& signature)
{
    std::string plain;
    int depth = 0;
    bool isType = false;

    for (const auto letter : signature.substr (0, signature.rfind (" ->")))
    {
        depth += letter == '(' || letter == '[' ? 1 : letter == ')' || letter == ']' ? -1 : 0;

        if (letter == ':' && depth == 1)
            isType = true;
        else if ((letter == ',' && depth == 1) || (letter == '=' && depth == 1) || (letter == ')' && depth == 0))
            isType = false;

        if (! isType && (letter != ' ' || plain.ends_with (',')))
            plain += letter;
    }

    return plain;
}
} // namespace antinode
