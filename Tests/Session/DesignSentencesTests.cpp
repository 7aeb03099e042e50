#include <antinode_session/UserMessages.h>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
DesignProgress progressWith (std::vector<int> failed)
{
    DesignProgress progress;
    progress.wanted = 129;
    progress.failedNotes = std::move (failed);
    progress.error = "why";
    return progress;
}
} // namespace

TEST_CASE ("Notes without a focus are counted, named and explained in one sentence", "[session]")
{
    CHECK (unplayableNotes (progressWith ({}), 48000).empty());
    CHECK (unplayableNotes (progressWith ({ 127 }), 48000)
           == "1 of 128 notes cannot be played at 48 kHz (note 127): why");
    CHECK (unplayableNotes (progressWith ({ 0, 1, 2, 127 }), 44100)
           == "4 of 128 notes cannot be played at 44.1 kHz (notes 0 to 2 and 127): why");
    CHECK (unplayableNotes (progressWith ({ 1, 3, 5, 7, 9, 11, 12, 20, 30 }), 8000)
           == "9 of 128 notes cannot be played at 8 kHz (notes 1, 3, 5, 7, 9, 11 to 12 and 2 more): why");
}

TEST_CASE ("A note that may be ignored is said calmly, many are not", "[session]")
{
    CHECK (unplayableNotesMessage (progressWith ({}), 48000).text.empty());
    CHECK (unplayableNotesMessage (progressWith ({ 63 }), 48000).urgency == Urgency::calm);
    std::vector<int> many;

    for (int note = 0; note < 64; ++note)
        many.push_back (note);

    CHECK (unplayableNotesMessage (progressWith (many), 48000).urgency == Urgency::caution);
}

TEST_CASE ("Messages stand with the worst first, each once", "[session]")
{
    std::vector<UserMessage> messages;
    addMessage (messages, Urgency::calm, "a");
    addMessage (messages, Urgency::warning, "b");
    addMessage (messages, Urgency::caution, "c");
    addMessage (messages, Urgency::warning, "");
    addMessage (messages, Urgency::warning, "d");
    addMessage (messages, Urgency::warning, "b");
    const std::vector<UserMessage> sorted {
        { Urgency::warning, "b" }, { Urgency::warning, "d" }, { Urgency::caution, "c" }, { Urgency::calm, "a" }
    };
    CHECK (worstFirst (messages) == sorted);
}
