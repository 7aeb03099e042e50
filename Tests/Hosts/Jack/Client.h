#pragma once

#include <jack/jack.h>

#include <cerrno>
#include <chrono>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>

namespace antinode::test
{
/** A client of the running JACK server. It never waits without an end, and says why it fails. */
class JackClient
{
public:
    static constexpr auto longestWait =
        std::chrono::seconds (600); ///< Ends what would never end; no fact depends on it.

    explicit JackClient (const std::string& name) : client (jack_client_open (name.c_str(), JackNoStartServer, nullptr))
    {
        if (client == nullptr)
            throw std::runtime_error ("no connection to the JACK server");
    }

    double sampleRate() const { return jack_get_sample_rate (client.get()); }

    jack_port_t* addPort (const std::string& name, JackPortFlags direction)
    {
        return jack_port_register (client.get(), name.c_str(), JACK_DEFAULT_AUDIO_TYPE, direction, 0);
    }

    void activate (JackProcessCallback process, JackShutdownCallback shutDown, void* context)
    {
        jack_set_process_callback (client.get(), process, context);
        jack_on_shutdown (client.get(), shutDown, context);

        if (jack_activate (client.get()) != 0)
            throw std::runtime_error ("the JACK server does not activate the client");
    }

    /** Whether the server calls its clients as fast as they compute, and no clock counts (JACK's freewheel mode). */
    void runFreely (bool isFree)
    {
        if (jack_set_freewheel (client.get(), isFree ? 1 : 0) != 0)
            throw std::runtime_error ("the JACK server cannot run freely");
    }

    /** Waits for ports that do not exist yet, or whose client is not active yet. */
    void connect (const std::string& from, const std::string& to)
    {
        for (const auto end = std::chrono::steady_clock::now() + longestWait; ! isConnected (from, to);
             std::this_thread::sleep_for (std::chrono::milliseconds (20)))
            if (std::chrono::steady_clock::now() > end)
                throw std::runtime_error (hasPort (from) && hasPort (to)
                                              ? from + " cannot be connected to " + to
                                              : "the port " + (hasPort (from) ? to : from) + " does not appear");
    }

private:
    bool hasPort (const std::string& name) const { return jack_port_by_name (client.get(), name.c_str()) != nullptr; }

    bool isConnected (const std::string& from, const std::string& to)
    {
        if (! hasPort (from) || ! hasPort (to))
            return false;

        const auto code = jack_connect (client.get(), from.c_str(), to.c_str());
        return code == 0 || code == EEXIST;
    }

    struct Close
    {
        void operator() (jack_client_t* opened) const { jack_client_close (opened); }
    };

    std::unique_ptr<jack_client_t, Close> client;
};
} // namespace antinode::test
