#include "DesignSentences.h"

#include <cstdio>

namespace antinode
{
namespace
{
constexpr int maximumRanges = 6;  // that are named
constexpr int ignorablePart = 10; // of the notes: one in so many

/** "0 to 3, 9 and 127", the last ones in a number where there are many. */
std::string inWords (const std::vector<int>& notes)
{
    std::vector<std::string> ranges;
    std::size_t named = 0;

    while (named < notes.size() && ranges.size() < maximumRanges)
    {
        const auto first = named++;

        while (named < notes.size() && notes[named] == notes[named - 1] + 1)
            ++named;

        ranges.push_back (std::to_string (notes[first])
                          + (named - first > 1 ? " to " + std::to_string (notes[named - 1]) : ""));
    }

    if (named < notes.size())
        ranges.push_back (std::to_string (notes.size() - named) + " more");

    std::string text;

    for (std::size_t i = 0; i < ranges.size(); ++i)
        text += (i == 0 ? "" : i + 1 == ranges.size() ? " and " : ", ") + ranges[i];

    return text;
}
} // namespace

std::string unplayableNotes (const DesignProgress& progress, double sampleRate)
{
    const auto& notes = progress.failedNotes;

    if (notes.empty())
        return {};

    char rate[32];
    std::snprintf (rate, sizeof rate, "%g", sampleRate / 1000);
    return std::to_string (notes.size()) + " of " + std::to_string (progress.wanted - 1) + " notes cannot be played at "
           + rate + " kHz (" + (notes.size() == 1 ? "note " : "notes ") + inWords (notes) + "): " + progress.error;
}

UserMessage unplayableNotesMessage (const DesignProgress& progress, double sampleRate)
{
    const auto failed = static_cast<int> (progress.failedNotes.size());
    return { ignorablePart * failed <= progress.wanted ? Urgency::calm : Urgency::caution,
             unplayableNotes (progress, sampleRate) };
}
} // namespace antinode
