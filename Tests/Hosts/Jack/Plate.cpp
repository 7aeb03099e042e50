#include "Client.h"
#include "PlateBench.h"

#include <array>
#include <atomic>
#include <cstdio>
#include <exception>
#include <optional>
#include <semaphore>
#include <stdexcept>
#include <string>
#include <vector>

/** A device with an idle ceramic as a client of a JACK server, between the outputs and the first input of Antinode.
    Usage: antinode_jack_plate DEVICE FOCUS CERAMIC DRIFT_PERCENT JUMP_PERCENT JUMP_SECONDS LATENCY_MS SECONDS

    Says "ready" once it waits for Antinode. Times are from the first voltage on. When it is over it prints a line
    "TIME ERROR_PERCENT" for each focus, and "peak SHARE" of full scale. */
namespace
{
using namespace antinode::test;

class PlateClient
{
public:
    explicit PlateClient (const BenchSetup& setup)
    {
        bench.emplace (setup, client.sampleRate());
        inputs.resize (bench->ceramics());

        for (std::size_t i = 0; i < inputs.size(); ++i)
            ports.push_back (client.addPort ("in_" + std::to_string (i + 1), JackPortIsInput));

        sensor = client.addPort ("sensor", JackPortIsOutput);
        client.activate (process, shutDown, this);
    }

    PlateClient (const PlateClient&) = delete;
    PlateClient& operator= (const PlateClient&) = delete;

    const PlateBench& play()
    {
        for (std::size_t i = 0; i < ports.size(); ++i)
            client.connect ("Antinode:out_" + std::to_string (i + 1), jack_port_name (ports[i]));

        client.connect (jack_port_name (sensor), "Antinode:in_1");

        if (! ended.try_acquire_for (JackClient::longestWait))
            throw std::runtime_error ("nothing is played, or the server does not call any longer");

        if (isGoingOn)
            throw std::runtime_error ("the JACK server has ended");

        return *bench;
    }

private:
    static int process (jack_nframes_t frames, void* context)
    {
        static_cast<PlateClient*> (context)->take (frames);
        return 0;
    }

    static void shutDown (void* context) { static_cast<PlateClient*> (context)->ended.release(); }

    void take (jack_nframes_t frames)
    {
        auto* const heard = static_cast<float*> (jack_port_get_buffer (sensor, frames));

        for (std::size_t i = 0; i < ports.size(); ++i)
            inputs[i] = static_cast<const float*> (jack_port_get_buffer (ports[i], frames));

        const auto wasGoingOn = isGoingOn.exchange (bench->process (inputs.data(), heard, frames));

        if (wasGoingOn && ! isGoingOn)
            ended.release();
    }

    std::vector<jack_port_t*> ports;
    jack_port_t* sensor = nullptr;
    std::counting_semaphore<> ended { 0 };
    std::atomic<bool> isGoingOn { true };
    std::vector<const float*> inputs;
    std::optional<PlateBench> bench;
    JackClient client { "plate" }; ///< Closed first.
};

BenchSetup readSetup (const std::vector<std::string>& words)
{
    if (words.size() != 8)
        throw std::runtime_error (
            "usage: DEVICE FOCUS CERAMIC DRIFT_PERCENT JUMP_PERCENT JUMP_SECONDS LATENCY_MS SECONDS");

    std::array<double, 6> numbers {};

    for (std::size_t i = 0; i < numbers.size(); ++i)
        numbers[i] = std::stod (words[i + 2]);

    return { words[0],          words[1],         static_cast<Eigen::Index> (numbers[0]) - 1,
             numbers[1] / 100,  numbers[2] / 100, numbers[3],
             numbers[4] / 1000, numbers[5] };
}
} // namespace

int main (int count, char** arguments)
{
    try
    {
        const auto setup = readSetup ({ arguments + 1, arguments + count });
        PlateClient client (setup);
        std::printf ("ready\n");
        std::fflush (stdout);
        const auto& bench = client.play();

        for (const auto& focus : bench.foci())
            std::printf ("%.3f %.2f\n", focus.time, 100 * focus.error);

        std::printf ("peak %.4f\n", bench.peak());
        return 0;
    }
    catch (const std::exception& exception)
    {
        std::fprintf (stderr, "antinode_jack_plate: %s\n", exception.what());
        return 1;
    }
}
