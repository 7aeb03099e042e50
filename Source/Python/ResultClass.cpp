#include "ResultClass.h"

namespace antinode
{
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
