#include "CsvHeading.h"

#include <antinode_base/MessageText.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace antinode
{
namespace
{
struct KindWord
{
    std::string_view word;
    CsvColumnKind kind;
};

constexpr std::array kindWords {
    KindWord { "frequency", CsvColumnKind::frequency },
    KindWord { "frequencies", CsvColumnKind::frequency },
    KindWord { "freq", CsvColumnKind::frequency },
    KindWord { "frequenz", CsvColumnKind::frequency },
    KindWord { "re", CsvColumnKind::real },
    KindWord { "real", CsvColumnKind::real },
    KindWord { "realteil", CsvColumnKind::real },
    KindWord { "im", CsvColumnKind::imaginary },
    KindWord { "imag", CsvColumnKind::imaginary },
    KindWord { "imaginary", CsvColumnKind::imaginary },
    KindWord { "imagin\xc3\xa4rteil", CsvColumnKind::imaginary },
    KindWord { "mag", CsvColumnKind::magnitude },
    KindWord { "mod", CsvColumnKind::magnitude },
    KindWord { "modulus", CsvColumnKind::magnitude },
    KindWord { "module", CsvColumnKind::magnitude },
    KindWord { "gain", CsvColumnKind::magnitude },
    KindWord { "amp", CsvColumnKind::magnitude },
    KindWord { "ampl", CsvColumnKind::magnitude },
    KindWord { "level", CsvColumnKind::magnitude },
    KindWord { "betrag", CsvColumnKind::magnitude },
    KindWord { "magnitude", CsvColumnKind::magnitude },
    KindWord { "abs", CsvColumnKind::magnitude },
    KindWord { "amplitude", CsvColumnKind::magnitude },
    KindWord { "db", CsvColumnKind::decibel },
    KindWord { "phase", CsvColumnKind::phase },
    KindWord { "ph", CsvColumnKind::phase },
    KindWord { "phi", CsvColumnKind::phase },
    KindWord { "angle", CsvColumnKind::phase },
    KindWord { "arg", CsvColumnKind::phase },
    KindWord { "coherence", CsvColumnKind::coherence },
    KindWord { "coh", CsvColumnKind::coherence },
};

constexpr std::array<std::string_view, 9> referenceWords { "c",   "ceramic",   "d",     "driver",  "u",
                                                           "ref", "reference", "input", "actuator" };
constexpr std::array<std::string_view, 8> pointWords { "p", "point", "node", "n", "resp", "response", "output", "pt" };
constexpr std::array<std::string_view, 17> emptyWords { "h",        "frf",      "h1",      "h2",  "hv",  "part",
                                                        "of",       "to",       "per",     "in",  "rel", "relative",
                                                        "transfer", "function", "complex", "lin", "unit" };

template <typename Words>
bool contains (const Words& words, std::string_view word)
{
    return std::find (words.begin(), words.end(), word) != words.end();
}

std::string_view leadingLetters (std::string_view word)
{
    return word.substr (0, std::min (word.find_first_of ("0123456789"), word.size()));
}

/** A word that is no name is noted for what it says; others are left. */
bool isUsed (std::string_view word, CsvHeading& heading)
{
    const auto* const kind =
        std::find_if (kindWords.begin(), kindWords.end(), [&] (const auto& each) { return each.word == word; });

    if (kind != kindWords.end())
    {
        const auto isWeaker = kind->kind == CsvColumnKind::magnitude && heading.kind == CsvColumnKind::decibel;
        const auto isReferred = word == "re" && heading.kind == CsvColumnKind::decibel; // "dB re 1 m/s^2"
        const auto isResponse = kind->kind == CsvColumnKind::frequency && heading.kind != CsvColumnKind::unknown;
        heading.kind = isWeaker || isReferred || isResponse ? heading.kind : kind->kind;
        return true;
    }

    constexpr std::array<std::string_view, 3> degreeSigns { "\xc2\xb0", "\xc2\xba", "grad" };
    const auto isDegree = word.starts_with ("deg") || contains (degreeSigns, word);
    heading.isDegrees = heading.isDegrees || isDegree;
    heading.isRadians = heading.isRadians || word.starts_with ("rad");
    return isDegree || word.starts_with ("rad") || contains (emptyWords, word);
}

void takeName (const std::string& name, std::string_view kind, CsvHeading& heading)
{
    const auto isReference = contains (referenceWords, kind);
    const auto isPoint = contains (pointWords, kind);

    if (isReference || (! isPoint && ! heading.point.empty()))
        heading.reference = heading.reference.empty() ? name : heading.reference;
    else
        heading.point = name;
}

void takeNames (const std::vector<std::string>& words, CsvHeading& heading)
{
    for (std::size_t i = 0; i < words.size(); ++i)
    {
        const auto letters = leadingLetters (words[i]);
        const auto isRole =
            letters == words[i] && (contains (referenceWords, letters) || contains (pointWords, letters));

        if (isRole && i + 1 < words.size() && leadingLetters (words[i + 1]).empty())
        {
            takeName (words[i + 1], letters, heading);
            ++i;
        }
        else if (! isRole)
            takeName (words[i], letters, heading);
    }
}

/** A unit and where it stands in a text. */
struct PlacedUnit
{
    ResponseUnit unit;
    std::size_t begin = 0, end = 0;
};

constexpr std::string_view opening = "([{", closing = ")]}";

bool isAnyOf (char character, std::string_view characters)
{
    return characters.find (character) != std::string_view::npos;
}

/** Quantities between the units of a ratio, "Acceleration (g) / Force (N)", as blanks. */
std::string withoutQuantities (std::string_view text)
{
    std::string lower (text), blanked (text);
    std::transform (lower.begin(), lower.end(), lower.begin(),
                    [] (unsigned char c) { return static_cast<char> (std::tolower (c)); });

    for (const std::string_view word : { "force", "voltage" })
        for (auto at = lower.find (word); at != std::string::npos; at = lower.find (word, at + 1))
            blanked.replace (at, word.size(), std::string (word.size(), ' '));

    return blanked;
}

/** Whether a part of a text has something that units have and words do not. */
bool looksLikeUnit (std::string_view part)
{
    return part.find_first_of ("/^([{") != std::string_view::npos || part.find ("-1") != std::string_view::npos
           || part.find ("-2") != std::string_view::npos || part.find (" per ") != std::string_view::npos;
}

/** Whether a part that begins here may be a unit: with a letter or a bracket, with 1/, or with any number behind "re".
 */
bool mayBegin (std::string_view text, std::size_t begin)
{
    const auto first = static_cast<unsigned char> (text[begin]);

    if (std::isdigit (first) == 0)
        return std::isalpha (first) != 0 || first >= 0x80 || isAnyOf (text[begin], opening);

    const auto words = splitWords (text.substr (0, begin));
    constexpr std::array<std::string_view, 5> referred { "re", "ref", "rel", "reference", "relative" };
    return text.substr (begin).starts_with ("1/") || (! words.empty() && contains (referred, words.back()));
}

/** The first unit of a response in a text, and of those that begin there the longest. */
std::optional<PlacedUnit> findUnit (std::string_view whole)
{
    constexpr std::string_view separators = " \t,;_:=\"";
    constexpr std::size_t longestText = 300, longestUnit = 60;
    const auto blanked = withoutQuantities (whole.substr (0, longestText));
    const std::string_view text = blanked;
    const auto isBoundary = [&] (std::size_t at) // Before this character.
    {
        return at == 0 || at == text.size() || isAnyOf (text[at - 1], separators) || isAnyOf (text[at], separators)
               || isAnyOf (text[at - 1], opening) || isAnyOf (text[at], opening) || isAnyOf (text[at - 1], closing)
               || isAnyOf (text[at], closing);
    };

    for (std::size_t begin = 0; begin < text.size(); ++begin)
        if (isBoundary (begin) && mayBegin (text, begin))
            for (auto end = std::min (text.size(), begin + longestUnit); end > begin; --end)
                if (const auto part = text.substr (begin, end - begin);
                    isBoundary (end) && ! isAnyOf (text[end - 1], separators) && looksLikeUnit (part))
                    if (const auto unit = responseUnit (part))
                        return PlacedUnit { *unit, begin, end };

    return std::nullopt;
}

/** What a text's words say of the quantity. */
std::optional<ResponseUnit> quantityInWords (std::string_view text)
{
    for (const auto& word : splitWords (text))
        if (const auto unit = quantityWord (word))
            return unit;

    return std::nullopt;
}

/** Whether a label in brackets is made of words that headings have in other places. */
bool hasOnlyKnownWords (std::string_view label)
{
    CsvHeading heading;
    constexpr std::array<std::string_view, 6> others { "hz", "khz", "s", "ms", "x", "y" };
    const auto words = splitWords (label);
    return std::all_of (words.begin(), words.end(),
                        [&] (const auto& word)
                        {
                            return isUsed (word, heading) || contains (others, word)
                                   || word.find_first_of ("0123456789") != std::string::npos;
                        });
}

/** A heading without what its decibels refer to: "dB re 1e-6", where no unit follows, has a number that is no name. */
std::string withoutReference (std::string text)
{
    for (const std::string_view mark : { "dB re", "dB (re", "dB(re", "dB, re" })
        if (const auto found = text.find (mark); found != std::string::npos)
            text.replace (found + 2, text.find_first_of (")]", found) - found - 2, " ");

    return text;
}

/** "|H|" is a magnitude; of "|Z|" and "arg(Z)" the letter is no name, other than in "|H21|". */
void takeFunctions (std::string& text)
{
    if (const auto bar = text.find ('|'), end = text.find ('|', bar + 1); bar != text.npos && end != text.npos)
    {
        const auto content = text.substr (bar + 1, end - bar - 1);
        const auto isName = content.find_first_of ("0123456789") != content.npos;
        text.replace (bar, end + 1 - bar, " magnitude " + (isName ? content : ""));
    }

    const auto isLetter = [&text] (std::size_t at)
    { return std::isalpha (static_cast<unsigned char> (text[at])) != 0; };

    for (std::size_t at = 1; at + 2 < text.size(); ++at)
        if (isAnyOf (text[at], opening) && isLetter (at - 1) && isLetter (at + 1) && isAnyOf (text[at + 2], closing))
            text[at + 1] = ' ';
}

/** The text in the first pair of brackets, "furlong/N"; empty where there is none. */
std::string_view contentOfBrackets (std::string_view text)
{
    const auto begin = text.find_first_of (opening), end = text.find_last_of (closing);
    return begin == std::string_view::npos || end == std::string_view::npos || end < begin
               ? std::string_view {}
               : text.substr (begin + 1, end - begin - 1);
}
} // namespace

std::vector<std::string> splitWords (std::string_view text)
{
    std::vector<std::string> words (1);

    for (const auto character : text)
        if (const auto byte = static_cast<unsigned char> (character); std::isalnum (byte) != 0 || byte >= 0x80)
            words.back() += static_cast<char> (std::tolower (byte));
        else if (! words.back().empty())
            words.emplace_back();

    if (words.back().empty())
        words.pop_back();

    return words;
}

std::optional<ResponseUnit> unitInText (std::string_view text)
{
    const auto words = quantityInWords (text);
    const auto placed = findUnit (text);

    if (! placed)
        return words;

    auto unit = placed->unit;

    if (! unit.drive && words && words->quantity == unit.quantity)
        unit.drive = words->drive;

    return unit;
}

std::string unknownUnitInText (std::string_view text)
{
    if (findUnit (text))
        return {};

    const auto lower = splitWords (text);
    const auto isStated = ! lower.empty() && (lower[0] == "unit" || lower[0] == "units");
    constexpr std::string_view none = " \t:=,;\"";
    const auto rest = text.substr (std::min (text.size(), text.find_first_of (none)));
    const auto content = contentOfBrackets (text);
    const auto label = trimmedText (isStated && content.empty() && rest.find_first_not_of (none) != rest.npos
                                        ? rest.substr (rest.find_first_not_of (none))
                                        : content);
    const auto isRatio = label.find_first_of ("/^") != std::string::npos;
    const auto isUnit = isStated || isRatio || quantityInWords (text).has_value();
    return isUnit && ! hasOnlyKnownWords (label) && isUnknownUnit (label) ? label : "";
}

CsvHeading csvHeading (std::string_view text)
{
    CsvHeading heading;
    heading.unit = unitInText (text);
    heading.unknownUnit = unknownUnitInText (text);
    std::string rest (text);

    if (const auto placed = findUnit (text))
        rest.replace (placed->begin, placed->end - placed->begin, " ");

    if (const auto label = heading.unknownUnit.empty() ? std::string::npos : rest.find (heading.unknownUnit);
        label != std::string::npos)
        rest.replace (label, heading.unknownUnit.size(), " ");

    takeFunctions (rest);
    auto words = splitWords (withoutReference (rest));
    std::erase_if (words, [&] (const auto& word) { return isUsed (word, heading) || quantityWord (word).has_value(); });
    takeNames (words, heading);
    return heading;
}
} // namespace antinode
