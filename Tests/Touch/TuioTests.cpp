#include "OscWriter.h"

#include <antinode_touch/TouchMessages.h>

#include <catch2/catch.hpp>

#include <limits>

using namespace antinode;
using namespace std::string_literals;
using namespace std::string_view_literals;
using test::OscWriter;
using test::Packet;
using test::toPacket;

namespace
{
struct Cursor
{
    std::int32_t session;
    float x, y;
};

Packet alive (const std::vector<std::int32_t>& sessions)
{
    // The one message of TUIO with any number of arguments.
    auto text = std::string ("/tuio/2Dcur\0,s"sv) + std::string (sessions.size(), 'i');
    text.append (4 - text.size() % 4, '\0');
    text += "alive\0\0\0"sv;

    for (const auto session : sessions)
        for (int shift = 24; shift >= 0; shift -= 8)
            text += static_cast<char> (session >> shift & 0xff);

    return toPacket (text);
}

Packet frame (std::int32_t sequence, const std::vector<std::int32_t>& sessions, const std::vector<Cursor>& cursors,
              const std::string& source = {})
{
    std::vector<Packet> messages;

    if (! source.empty())
        messages.push_back (OscWriter::message ("/tuio/2Dcur", "source"s, source));

    messages.push_back (alive (sessions));

    for (const auto& cursor : cursors)
        messages.push_back (
            OscWriter::message ("/tuio/2Dcur", "set"s, cursor.session, cursor.x, cursor.y, 0.1F, 0.2F, 0.3F));

    messages.push_back (OscWriter::message ("/tuio/2Dcur", "fseq"s, sequence));
    return OscWriter::bundle (messages);
}

/** Reads frame after frame. */
struct Reader
{
    std::vector<Touch> operator() (const Packet& packet) { return messages.read (packet, now, counters); }
    int countTouches (const Packet& packet) { return static_cast<int> ((*this) (packet).size()); }

    TouchMessages messages;
    TouchCounters counters;
    TouchMessages::Time now {}; ///< It does not pass by itself.
};
} // namespace

// Source: https://www.tuio.org/?specification, TUIO 1.1: source application@address; alive; set s x y X Y m; fseq.
TEST_CASE ("A TUIO 1.1 bundle, to the byte: a new cursor is a touch, y turned over", "[touch]")
{
    Reader reader;
    const auto touches =
        reader (toPacket ("#bundle\0\x00\x00\x00\x00\x00\x00\x00\x01"
                          "\x00\x00\x00\x2c/tuio/2Dcur\0,ss\0source\0\0tracker@127.0.0.1\0\0\0"
                          "\x00\x00\x00\x1c/tuio/2Dcur\0,si\0alive\0\0\0\x00\x00\x00\x0c"
                          "\x00\x00\x00\x34/tuio/2Dcur\0,sifffff\0\0\0\0set\0\x00\x00\x00\x0c"
                          "\x3e\x80\x00\x00\x3e\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00"
                          "\x00\x00\x00\x1c/tuio/2Dcur\0,si\0fseq\0\0\0\0\x00\x00\x00\x01"sv));
    REQUIRE (touches.size() == 1);
    CHECK (touches[0] == Touch { TouchKind::focusAt, false, 0.25, 0.875, 1 });
    CHECK (reader.counters.faults == TouchCounters {}.faults);
}

TEST_CASE ("A cursor gives one touch, however it moves, and when it has vanished its number may come again", "[touch]")
{
    Reader reader;
    CHECK (reader.countTouches (frame (1, { 5 }, { { 5, 0.1F, 0.1F } })) == 1);
    CHECK (reader.countTouches (frame (2, { 5 }, { { 5, 0.9F, 0.9F } })) == 0);
    CHECK (reader.countTouches (frame (3, { 5 }, {})) == 0); // It rests.
    CHECK (reader.countTouches (frame (4, { 5, 6 }, { { 6, 0.5F, 0.5F } })) == 1);
    CHECK (reader.countTouches (frame (5, { 6 }, {})) == 0);
    CHECK (reader.countTouches (frame (6, { 5, 6 }, { { 5, 0.1F, 0.1F } })) == 1);
    CHECK (reader.countTouches (frame (7, {}, {})) == 0);
    CHECK (reader.countTouches (frame (8, { 6 }, { { 6, 0.5F, 0.5F } })) == 1);
    CHECK (reader.counters.faults == TouchCounters {}.faults);
}

TEST_CASE ("With a repeat distance a cursor gives a touch whenever it has gone so far since the last", "[touch]")
{
    Reader reader { TouchMessages ({ 0.2, 500 }), {}, {} };
    CHECK (reader.countTouches (frame (1, { 5 }, { { 5, 0.1F, 0.5F } })) == 1);
    CHECK (reader.countTouches (frame (2, { 5 }, { { 5, 0.25F, 0.5F } })) == 0);
    CHECK (reader.countTouches (frame (3, { 5 }, { { 5, 0.25F, 0.65F } })) == 1); // 0.21 from the first.
    CHECK (reader.countTouches (frame (4, { 5 }, { { 5, 0.1F, 0.55F } })) == 0);  // 0.18 from the second.
    CHECK (reader.countTouches (frame (5, { 5 }, { { 5, 0.25F, 0.4F } })) == 1);
}

TEST_CASE ("Old frames are dropped, repeated ones change nothing", "[touch]")
{
    Reader reader;
    CHECK (reader.countTouches (frame (10, { 1 }, { { 1, 0.1F, 0.1F } })) == 1);
    CHECK (reader.countTouches (frame (10, { 1 }, { { 1, 0.1F, 0.1F } })) == 0);
    CHECK (reader.counters.of (TouchFault::staleFrame) == 0);
    CHECK (reader.countTouches (frame (9, { 2 }, { { 2, 0.1F, 0.1F } })) == 0);
    CHECK (reader.counters.of (TouchFault::staleFrame) == 1);
    CHECK (reader.countTouches (frame (11, { 1 }, { { 1, 0.1F, 0.1F } })) == 0); // The old frame did not end cursor 1.
}

TEST_CASE ("A frame too large for a packet comes in several with the same fseq", "[touch]")
{
    Reader reader;
    CHECK (reader.countTouches (frame (10, { 1, 2 }, { { 1, 0.1F, 0.1F } })) == 1);
    CHECK (reader.countTouches (frame (10, { 1, 2 }, { { 2, 0.2F, 0.1F } })) == 1);
}

TEST_CASE ("A frame with fseq -1 counts and leaves the order as it is", "[touch]")
{
    Reader reader;
    CHECK (reader.countTouches (frame (10, {}, {})) == 0);
    CHECK (reader.countTouches (frame (-1, { 1 }, { { 1, 0.1F, 0.1F } })) == 1); // Its first frame was lost.
    CHECK (reader.countTouches (frame (-1, { 1 }, { { 1, 0.1F, 0.1F } })) == 0);
    CHECK (reader.countTouches (frame (9, { 1, 2 }, { { 2, 0.1F, 0.1F } })) == 0);
    CHECK (reader.counters.of (TouchFault::staleFrame) == 1);
    CHECK (reader.countTouches (frame (11, { 1, 2 }, { { 2, 0.1F, 0.1F } })) == 1);
}

TEST_CASE ("A source that is started anew begins from 1 and with new cursors", "[touch]")
{
    Reader reader;
    CHECK (reader.countTouches (frame (2147483647, { 1 }, { { 1, 0.1F, 0.1F } })) == 1);
    CHECK (reader.countTouches (frame (1, { 1 }, { { 1, 0.1F, 0.1F } })) == 1);
    CHECK (reader.countTouches (frame (2, { 1 }, { { 1, 0.1F, 0.1F } })) == 0);
    CHECK (reader.counters.of (TouchFault::staleFrame) == 0);
}

TEST_CASE ("Each source has its own cursors and its own order", "[touch]")
{
    Reader reader;
    CHECK (reader.countTouches (frame (50, { 1 }, { { 1, 0.1F, 0.1F } }, "left@10.0.0.1")) == 1);
    CHECK (reader.countTouches (frame (7, { 1 }, { { 1, 0.1F, 0.1F } }, "right@10.0.0.2")) == 1);
    CHECK (reader.countTouches (frame (8, {}, {}, "right@10.0.0.2")) == 0);
    CHECK (reader.countTouches (frame (51, { 1 }, { { 1, 0.2F, 0.1F } }, "left@10.0.0.1")) == 0);
    CHECK (reader.countTouches (frame (1, { 1 }, { { 1, 0.2F, 0.1F } })) == 1); // Without a name: a third one.
}

TEST_CASE ("Of more than 16 sources the one that was silent longest is forgotten", "[touch]")
{
    Reader reader;
    const auto of = [] (int source) { return frame (-1, { 1 }, { { 1, 0.1F, 0.1F } }, std::to_string (source)); };

    for (int source = 0; source < 16; ++source)
        CHECK (reader.countTouches (of (source)) == 1);

    CHECK (reader.countTouches (of (0)) == 0);
    CHECK (reader.countTouches (of (16)) == 1); // In the place of source 1.
    CHECK (reader.countTouches (of (0)) == 0);
    CHECK (reader.countTouches (of (1)) == 1);
}

TEST_CASE ("A cursor from outside gives its touch where it enters the surface", "[touch]")
{
    Reader reader;
    CHECK (reader.countTouches (frame (1, { 1 }, { { 1, -0.1F, 0.5F } })) == 0);
    CHECK (reader.counters.of (TouchFault::outside) == 1);
    const auto touches = reader (frame (2, { 1 }, { { 1, 0.0F, 0.5F } }));
    REQUIRE (touches.size() == 1);
    CHECK (touches[0].x == 0);
    CHECK (reader.countTouches (frame (3, { 2 }, { { 2, std::numeric_limits<float>::quiet_NaN(), 0.5F } })) == 0);
    CHECK (reader.counters.of (TouchFault::notFinite) == 1);
}

TEST_CASE ("Frames without alive or fseq, and cursors that are not alive, give no touch", "[touch]")
{
    Reader reader;
    const auto set = OscWriter::message ("/tuio/2Dcur", "set"s, 1, 0.1F, 0.1F, 0.0F, 0.0F, 0.0F);
    const auto end = OscWriter::message ("/tuio/2Dcur", "fseq"s, 1);
    CHECK (reader.countTouches (OscWriter::bundle ({ set, end })) == 0);
    CHECK (reader.counters.of (TouchFault::brokenFrame) == 1);
    CHECK (reader.countTouches (end) == 0);
    CHECK (reader.counters.of (TouchFault::brokenFrame) == 2);
    CHECK (reader.countTouches (OscWriter::bundle ({ alive ({ 2 }), set, end })) == 0);
    CHECK (reader.counters.of (TouchFault::brokenFrame) == 3);
    CHECK (reader.countTouches (alive ({ 1 })) == 0);
    CHECK (reader.countTouches (OscWriter::bundle ({ alive ({ 1 }), set, end })) == 1); // The first has no fseq.
    CHECK (reader.counters.of (TouchFault::brokenFrame) == 4);
}

// Source: TuioClient::processOSC of TUIO's reference client for C++: state lasts from message to message, whatever the
// packets; an fseq takes what came before it.
TEST_CASE ("The messages of a frame may come in packets of their own, and a lost fseq costs no place", "[touch]")
{
    TouchOptions options;
    options.cursorsRest = true;
    Reader reader { TouchMessages (options), {}, {} };
    const auto source = OscWriter::message ("/tuio/2Dcur", "source"s, "pad@here"s);
    const auto set = [] (float x) { return OscWriter::message ("/tuio/2Dcur", "set"s, 1, x, 0.25F, 0.0F, 0.0F, 0.0F); };
    const auto end = [] (int sequence) { return OscWriter::message ("/tuio/2Dcur", "fseq"s, sequence); };

    for (const auto& packet : { source, alive ({ 1 }), set (0.5F) })
        CHECK (reader.countTouches (packet) == 0);

    const auto down = reader (end (1));
    REQUIRE (down.size() == 1);
    CHECK (down[0].x == 0.5);
    CHECK (down[0].y == 0.75);
    CHECK (reader.counters.faults == TouchCounters {}.faults);

    for (const auto& packet : { source, alive ({ 1 }), set (0.625F), source, alive ({ 1 }) })
        CHECK (reader.countTouches (packet) == 0);

    const auto moved = reader (end (3));
    REQUIRE (moved.size() == 1);
    CHECK (moved[0].x == 0.625);
    CHECK (reader.counters.of (TouchFault::brokenFrame) == 1);

    // Nothing of a frame that is not ended goes to another source.
    for (const auto& packet : { source, alive ({ 1 }), set (0.75F),
                                OscWriter::message ("/tuio/2Dcur", "source"s, "wall@there"s), alive ({ 1 }) })
        CHECK (reader.countTouches (packet) == 0);

    CHECK (reader.countTouches (end (1)) == 0);
}

TEST_CASE ("Places without end and without fseq take no more memory than a frame", "[touch]")
{
    Reader reader;
    const auto set = OscWriter::message ("/tuio/2Dcur", "set"s, 1, 0.5F, 0.25F, 0.0F, 0.0F, 0.0F);

    for (std::size_t i = 0; i < 2 * TuioSources::maximumCursors + 1; ++i)
        CHECK (reader.countTouches (set) == 0);

    CHECK (reader.counters.of (TouchFault::brokenFrame) == 2);
}

TEST_CASE ("What a source holds ends with it: after three seconds without a frame, or when it begins again", "[touch]")
{
    using namespace std::chrono_literals;
    TouchOptions options;
    options.cursorsRest = true;
    Reader reader { TouchMessages (options), {}, {} };
    const auto lifted = [&reader] (TouchMessages::Time::duration passed)
    {
        reader.now += passed;
        return reader.messages.endSilent (reader.now).size();
    };
    const auto down = [&reader] (std::int32_t sequence, const std::string& source) {
        return reader (frame (sequence, { 1 }, { { 1, 0.5F, 0.5F } }, source));
    };

    CHECK (down (1, "pad@here").size() == 1);
    CHECK (lifted (2900ms) == 0);
    CHECK (reader.countTouches (frame (2, { 1 }, {}, "pad@here")) == 0); // What is alive, again.
    CHECK (lifted (2900ms) == 0);
    CHECK (lifted (200ms) == 1);
    CHECK (lifted (5s) == 0);
    CHECK (down (3, "pad@here").size() == 1); // It was only asleep.

    // One that begins again under another name cannot be told from a second one, so the old one has to end.
    CHECK (down (1, "pad@here, again").size() == 1);
    CHECK (lifted (2900ms) == 0);
    CHECK (reader.countTouches (frame (2, { 1 }, {}, "pad@here, again")) == 0);
    CHECK (lifted (200ms) == 1);

    // One that begins again is seen at its first frame, and where that is lost at the next one that comes so late.
    for (std::int32_t sequence = 3; sequence < 60; ++sequence)
        down (sequence, "pad@here, again");

    const auto again = down (1, "pad@here, again");
    REQUIRE (again.size() == 2);
    CHECK (again[0].kind == TouchKind::lift);
    CHECK (again[1].kind == TouchKind::rest);
    CHECK (down (60, "pad@here, again").size() == 1);
    reader.now += 500ms;
    CHECK (down (2, "pad@here, again").size() == 2);
    CHECK (reader.counters.of (TouchFault::staleFrame) == 0);
}

TEST_CASE ("TUIO messages with wrong arguments are counted", "[touch]")
{
    const auto fseq = OscWriter::message ("/tuio/2Dcur", "fseq"s, 1);

    for (const auto& bad :
         { OscWriter::message ("/tuio/2Dcur"), OscWriter::message ("/tuio/2Dcur", 1),
           OscWriter::message ("/tuio/2Dcur", "dance"s), OscWriter::message ("/tuio/2Dcur", "set"s, 1, 0.5F),
           OscWriter::message ("/tuio/2Dcur", "set"s, 1.0F, 0.1F, 0.1F, 0.0F, 0.0F, 0.0F),
           OscWriter::message ("/tuio/2Dcur", "set"s, 1, "0.1"s, 0.1F, 0.0F, 0.0F, 0.0F),
           OscWriter::message ("/tuio/2Dcur", "alive"s, 1.0F), OscWriter::message ("/tuio/2Dcur", "fseq"s, 1.0F),
           OscWriter::message ("/tuio/2Dcur", "fseq"s), OscWriter::message ("/tuio/2Dcur", "source"s, 7) })
    {
        Reader reader;
        CHECK (reader.countTouches (OscWriter::bundle ({ alive ({ 1 }), bad, fseq })) == 0);
        CHECK (reader.counters.of (TouchFault::wrongArguments) == 1);
        CHECK (reader.counters.of (TouchFault::brokenFrame) == 0);
    }
}

TEST_CASE ("Other TUIO profiles, which trackers send as well, are passed over", "[touch]")
{
    Reader reader;
    CHECK (reader.countTouches (OscWriter::message ("/tuio/2Dobj", "alive"s)) == 0);
    CHECK (reader.counters.faults == TouchCounters {}.faults);
}

TEST_CASE ("Where cursors rest as fingers, each says where it is and when it leaves", "[touch]")
{
    TouchOptions options;
    options.cursorsRest = true;
    Reader reader { TouchMessages (options), {}, {} };
    const auto down = reader (frame (1, { 7, 8 }, { { 7, 0.25F, 0.5F }, { 8, 0.75F, 0.5F } }, "pad@here"));
    REQUIRE (down.size() == 2);
    CHECK (down[0].kind == TouchKind::rest);
    CHECK (down[0].finger != down[1].finger);

    // What is too short a move is for whoever lets them rest to say: they know the other fingers.
    CHECK (reader.countTouches (frame (2, { 7, 8 }, { { 7, 0.251F, 0.5F } }, "pad@here")) == 1);
    const auto moved = reader (frame (3, { 7, 8 }, { { 7, 0.26F, 0.5F } }, "pad@here"));
    REQUIRE (moved.size() == 1);
    CHECK (moved[0].finger == down[0].finger);
    CHECK (moved[0].x == Approx (0.26));

    // The same session of another source is another finger.
    const auto other = reader (frame (1, { 7 }, { { 7, 0.5F, 0.1F } }, "wall@there"));
    REQUIRE (other.size() == 1);
    CHECK (other[0].finger != down[0].finger);

    const auto up = reader (frame (4, { 8 }, {}, "pad@here"));
    REQUIRE (up.size() == 1);
    CHECK (up[0].kind == TouchKind::lift);
    CHECK (up[0].finger == down[0].finger);

    // A source that starts again has lifted all.
    reader (frame (500, { 8 }, {}, "pad@here"));
    const auto again = reader (frame (1, { 8 }, { { 8, 0.75F, 0.5F } }, "pad@here"));
    REQUIRE (again.size() == 2);
    CHECK (again[0].kind == TouchKind::lift);
    CHECK (again[1].kind == TouchKind::rest);
}
