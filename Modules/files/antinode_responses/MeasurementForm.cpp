#include "MeasurementForm.h"

#include "MatlabFile.h"

#include <algorithm>
#include <array>

namespace antinode
{
namespace
{
bool isUniversal (std::string_view bytes)
{
    constexpr std::size_t preamble = 4096;
    const auto begin = bytes.substr (0, preamble);
    return begin.starts_with ("    -1") || begin.find ("\n    -1") != std::string_view::npos;
}

bool isMatlab (std::string_view bytes)
{
    return bytes.starts_with ("MATLAB") || bytes.starts_with ("\x89HDF") || bytes.substr (0, 128).ends_with ("IM")
           || bytes.substr (0, 128).ends_with ("MI") || isMatlabLevel4 (bytes);
}

/** Words like P3, point12, c1. */
bool isNumberedRole (const std::string& word)
{
    constexpr std::array<std::string_view, 7> roles { "p", "point", "node", "c", "d", "ceramic", "driver" };
    const auto letters = word.substr (0, word.find_first_of ("0123456789"));
    return letters.size() < word.size() && std::find (roles.begin(), roles.end(), letters) != roles.end();
}
} // namespace

MeasurementForm measurementForm (std::string_view bytes)
{
    for (const std::string_view mark : { "RIFF", "RF64", "BW64", "RIFX", "riff", "fLaC", "OggS", "caff" })
        if (bytes.starts_with (mark)) // What of these is not read, the reader of WAV files names.
            return MeasurementForm::wave;

    return isMatlab (bytes)      ? MeasurementForm::matlab
           : isUniversal (bytes) ? MeasurementForm::universal
                                 : MeasurementForm::text;
}

CsvHeading rolesInFileName (const std::string& source)
{
    std::string roles;

    for (const auto& word : splitWords (source.substr (0, source.rfind ('.'))))
        roles += isNumberedRole (word) ? word + " " : "";

    return csvHeading (roles);
}
} // namespace antinode
