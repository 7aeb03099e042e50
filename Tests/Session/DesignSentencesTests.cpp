#include <antinode_session/DesignSentences.h>

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
