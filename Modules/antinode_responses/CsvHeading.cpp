#include "CsvHeading.h"

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
    KindWord { "re", CsvColumnKind::real },
    KindWord { "real", CsvColumnKind::real },
    KindWord { "im", CsvColumnKind::imaginary },
    KindWord { "imag", CsvColumnKind::imaginary },
    KindWord { "imaginary", CsvColumnKind::imaginary },
    KindWord { "mag", CsvColumnKind::magnitude },
    KindWord { "magnitude", CsvColumnKind::magnitude },
    KindWord { "abs", CsvColumnKind::magnitude },
    KindWord { "amplitude", CsvColumnKind::magnitude },
    KindWord { "db", CsvColumnKind::decibel },
    KindWord { "phase", CsvColumnKind::phase },
    KindWord { "angle", CsvColumnKind::phase },
    KindWord { "arg", CsvColumnKind::phase },
    KindWord { "coherence", CsvColumnKind::coherence },
    KindWord { "coh", CsvColumnKind::coherence },
};

constexpr std::array<std::string_view, 9> referenceWords { "c",   "ceramic",   "d",     "driver",  "u",
                                                           "ref", "reference", "input", "actuator" };
constexpr std::array<std::string_view, 8> pointWords { "p", "point", "node", "n", "resp", "response", "output", "pt" };
constexpr std::array<std::string_view, 10> emptyWords { "h",    "frf", "h1", "h2",       "hv",
                                                        "part", "of",  "to", "transfer", "function" };

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
        heading.kind = isWeaker ? heading.kind : kind->kind;
        return true;
    }

    heading.isDegrees = heading.isDegrees || word.starts_with ("deg");
    heading.isRadians = heading.isRadians || word.starts_with ("rad");
    return word.starts_with ("deg") || word.starts_with ("rad") || contains (emptyWords, word);
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

/** Parts of a text that could be units: between blanks, commas, underscores, colons, equals signs; and in square
    brackets. */
std::vector<std::string_view> unitCandidates (std::string_view text)
{
    constexpr std::string_view separators = " \t,;_:=[]{}\"";
    std::vector<std::string_view> candidates;

    for (auto begin = text.find_first_not_of (separators); begin != std::string_view::npos;)
    {
        const auto end = std::min (text.find_first_of (separators, begin), text.size());
        candidates.push_back (text.substr (begin, end - begin));
        begin = text.find_first_not_of (separators, end);
    }

    return candidates;
}

bool looksLikeUnit (std::string_view candidate)
{
    return candidate.find_first_of ("/^(") != std::string_view::npos && responseUnit (candidate).has_value();
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
    for (const auto candidate : unitCandidates (text))
        if (looksLikeUnit (candidate))
            return responseUnit (candidate);

    for (const auto& word : splitWords (text))
        if (const auto unit = quantityWord (word))
            return unit;

    return std::nullopt;
}

CsvHeading csvHeading (std::string_view text)
{
    CsvHeading heading;
    heading.unit = unitInText (text);
    std::string rest;

    for (const auto candidate : unitCandidates (text))
        if (! looksLikeUnit (candidate))
            rest += std::string (candidate) + ' ';

    auto words = splitWords (rest);
    std::erase_if (words, [&] (const auto& word) { return isUsed (word, heading) || quantityWord (word).has_value(); });
    takeNames (words, heading);
    return heading;
}
} // namespace antinode
