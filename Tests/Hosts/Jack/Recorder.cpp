#include "Client.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <semaphore>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

/** Records ports of a JACK server. Usage: antinode_jack_recorder FILE SECONDS [freely] [FROM>TO]... PORT...

    Arguments FROM>TO are connected first; it waits for ports that do not exist yet. Freely: while it records, the
    server calls its clients as fast as they compute, and no clock counts. FILE becomes 32-bit floats, one channel after
   the other. It never waits without an end and says why it fails, which JACK's own recorder does not. */
namespace
{
using antinode::test::JackClient;

constexpr auto connectionMark = '>';

/** A client of the running server with a port and a block of memory for each channel. */
class Recorder
{
public:
    Recorder (std::size_t channels, double seconds)
    {
        length = static_cast<std::size_t> (std::lround (seconds * client.sampleRate()));
        recorded.assign (channels, std::vector<float> (length));

        for (std::size_t n = 0; n < channels; ++n)
            ports.push_back (client.addPort ("in_" + std::to_string (n + 1), JackPortIsInput));

        client.activate (process, shutDown, this);
    }

    Recorder (const Recorder&) = delete;
    Recorder& operator= (const Recorder&) = delete;

    void connect (const std::string& from, const std::string& to) { client.connect (from, to); }

    std::string portName (std::size_t channel) const { return jack_port_name (ports[channel]); }

    /** The samples by channel. */
    const std::vector<std::vector<float>>& record (bool runsFreely)
    {
        if (runsFreely)
            client.runFreely (true);

        isRecording = true;
        const auto hasEnded = ended.try_acquire_for (JackClient::longestWait);

        if (runsFreely)
            client.runFreely (false);

        if (! hasEnded)
            throw std::runtime_error ("recorded " + std::to_string (position) + " of " + std::to_string (length)
                                      + " samples; the server does not call any longer");

        if (position < length)
            throw std::runtime_error ("the JACK server has ended");

        return recorded;
    }

private:
    static int process (jack_nframes_t frames, void* context)
    {
        static_cast<Recorder*> (context)->take (frames);
        return 0;
    }

    static void shutDown (void* context) { static_cast<Recorder*> (context)->ended.release(); }

    void take (jack_nframes_t frames)
    {
        if (! isRecording || position == length)
            return;

        const auto taken = std::min<std::size_t> (frames, length - position);

        for (std::size_t n = 0; n < ports.size(); ++n)
        {
            const auto* samples = static_cast<const float*> (jack_port_get_buffer (ports[n], frames));
            std::copy_n (samples, taken, recorded[n].begin() + static_cast<std::ptrdiff_t> (position.load()));
        }

        position += taken;

        if (position == length)
            ended.release();
    }

    std::vector<std::vector<float>> recorded;
    std::vector<jack_port_t*> ports;
    std::size_t length = 0;
    std::atomic<std::size_t> position { 0 };
    std::atomic<bool> isRecording { false };
    std::counting_semaphore<> ended { 0 };
    JackClient client { "recorder" }; ///< Closed first.
};

void write (const std::string& path, const std::vector<std::vector<float>>& channels)
{
    std::ofstream file (path, std::ios::binary);

    for (const auto& channel : channels)
        file.write (reinterpret_cast<const char*> (channel.data()),
                    static_cast<std::streamsize> (channel.size() * sizeof (float)));

    if (! file.flush())
        throw std::runtime_error (path + " cannot be written");
}

void run (const std::string& path, double seconds, const std::vector<std::string>& names)
{
    std::vector<std::string> connections, recordedPorts;
    const auto runsFreely = names.front() == "freely";

    for (const auto& name : std::span (names).subspan (runsFreely ? 1 : 0))
        (name.find (connectionMark) == std::string::npos ? recordedPorts : connections).push_back (name);

    Recorder recorder (recordedPorts.size(), seconds);

    for (std::size_t n = 0; n < recordedPorts.size(); ++n)
        recorder.connect (recordedPorts[n], recorder.portName (n));

    for (const auto& connection : connections)
        recorder.connect (connection.substr (0, connection.find (connectionMark)),
                          connection.substr (connection.find (connectionMark) + 1));

    write (path, recorder.record (runsFreely));
}
} // namespace

int main (int count, char** arguments)
{
    try
    {
        if (count < 4)
            throw std::runtime_error ("usage: FILE SECONDS [freely] [FROM>TO]... PORT...");

        run (arguments[1], std::stod (arguments[2]), { arguments + 3, arguments + count });
        return 0;
    }
    catch (const std::exception& exception)
    {
        std::fprintf (stderr, "antinode_jack_recorder: %s\n", exception.what());
        return 1;
    }
}
