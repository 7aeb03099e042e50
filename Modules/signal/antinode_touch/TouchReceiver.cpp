#include "TouchReceiver.h"

#include <antinode_base/InputError.h>
#include <antinode_base/System.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <system_error>

namespace antinode
{
bool TouchRateLimit::allows (Time now)
{
    while (! passed.empty() && now - passed.front() >= std::chrono::seconds (1))
        passed.pop_front();

    if (static_cast<std::int64_t> (passed.size()) >= perSecond)
        return false;

    passed.push_back (now);
    return true;
}

namespace
{
constexpr int pollMilliseconds = 20;         ///< Until the thread sees that it is to stop.
constexpr int answerMilliseconds = 2;        ///< Until what has happened is told, where somebody waits for it.
constexpr std::size_t largestPacket = 65536; ///< More than UDP can transport: nothing is truncated.

void check (const TouchPorts& ports)
{
    // juce::DatagramSocket takes what is no address for 255.255.255.255, and an empty one for the whole network.
    if (! isIpv4Address (ports.address))
        throw InputError ("Touch input",
                          "the address is \"" + ports.address + "\"; allowed: an IPv4 address, for example 127.0.0.1");

    for (const auto& sender : ports.senders)
        if (! isIpv4Address (sender))
            throw InputError ("Touch input",
                              "a sender is \"" + sender + "\"; allowed: an IPv4 address, for example 192.168.1.20");

    for (const auto port : { ports.oscPort, ports.tuioPort })
        if (port < TouchPorts::anyFree || port > 65535)
            throw InputError ("Touch input",
                              "a port is " + std::to_string (port) + "; allowed: 1 to 65535, or 0 for off");

    if (ports.oscPort == ports.tuioPort && ports.oscPort > 0)
        throw InputError ("Touch input", "the OSC and the TUIO port are both " + std::to_string (ports.oscPort)
                                             + "; allowed: two different ports");
}
} // namespace

TouchReceiver::TouchReceiver (const TouchPorts& ports, const TouchOptions& options, Callback callbackToUse,
                              OscControl controlToUse)
    : openPorts (ports), callback (std::move (callbackToUse)), messages (options), limit (options.touchesPerSecond),
      control (std::move (controlToUse))
{
    check (ports);
    openPorts.oscPort = open ("OSC", ports.oscPort);
    openPorts.tuioPort = open ("TUIO", ports.tuioPort);
    thread = std::thread ([this] { run(); });
}

TouchReceiver::~TouchReceiver()
{
    isStopping = true;
    thread.join();
}

int TouchReceiver::open (const char* name, int port)
{
    if (port == 0)
        return 0;

    auto socket = std::make_unique<juce::DatagramSocket>();

    // JUCE allows reuse from the start: on Linux two programs could then have a port, and one would receive nothing.
    socket->setEnablePortReuse (false);

    if (! socket->bindToPort (std::max (port, 0), openPorts.address))
    {
        const auto reason = errno;
        throw InputError (std::string (name) + " port" + (port > 0 ? " " + std::to_string (port) : ""),
                          reason == EADDRINUSE ? "is in use by another program; allowed: a free port, or 0 for off"
                                               : "cannot be opened on " + openPorts.address + ": "
                                                     + std::generic_category().message (reason));
    }

    sockets.push_back (std::move (socket));
    return sockets.back()->getBoundPort();
}

void TouchReceiver::run()
{
    std::vector<std::byte> buffer (largestPacket);
    std::vector<int> handles;
    handles.reserve (sockets.size());

    for (const auto& socket : sockets)
        handles.push_back (socket->getRawSocketHandle());

    // One wait for both sockets; juce's waits for one, and the other's touches would wait with it.
    while (! isStopping)
    {
        for (const auto i : waitForSockets (handles, control.answers ? answerMilliseconds : pollMilliseconds))
            receive (*sockets[i], buffer);

        try
        {
            for (const auto& touch : messages.endSilent (Clock::now()))
                forward (touch);

            answer();
        }
        catch (const std::exception&)
        {
            ++current.failures;
        }

        publish();
    }
}

/** Touches and commands of a packet in their order: a stop ends what was asked for before it. */
void TouchReceiver::receive (juce::DatagramSocket& socket, std::vector<std::byte>& buffer)
{
    try
    {
        juce::String address;
        OscSender sender;
        const auto size = socket.read (buffer.data(), static_cast<int> (buffer.size()), false, address, sender.port);
        sender.address = address.toStdString();
        std::vector<OscCommand> commands;
        const auto touches = messages.read (std::span (buffer).first (static_cast<std::size_t> (std::max (size, 0))),
                                            Clock::now(), current, control.take ? &commands : nullptr);
        auto next = touches.begin();

        for (const auto& [message, touchesBefore] : commands)
        {
            for (; next != touches.begin() + static_cast<std::ptrdiff_t> (touchesBefore); ++next)
                forward (*next);

            take (message, sender);
        }

        std::for_each (next, touches.end(), [this] (const auto& touch) { forward (touch); });
        answer();
    }
    catch (const std::exception&)
    {
        ++current.failures;
    }

    publish();
}

void TouchReceiver::take (const OscMessage& message, const OscSender& sender)
{
    const auto& known = openPorts.senders;

    if (! sender.address.starts_with ("127.") && std::find (known.begin(), known.end(), sender.address) == known.end())
        ++current.strangers;
    else if (! commandLimit.allows (Clock::now()))
        ++current.limited;
    else
        control.take (message, sender);
}

/** From the socket for OSC: its port is the one that senders know. */
void TouchReceiver::answer()
{
    if (! control.answers)
        return;

    for (const auto& [to, message] : control.answers())
    {
        const auto packet = writeOscMessage (message);
        sockets.front()->write (juce::String (to.address), to.port, packet.data(), static_cast<int> (packet.size()));
    }
}

void TouchReceiver::publish()
{
    const std::lock_guard lock (mutex);
    published = current;
}

void TouchReceiver::forward (const Touch& touch)
{
    if (touch.kind == TouchKind::focusAt && ! limit.allows (Clock::now()))
    {
        ++current.limited;
        return;
    }

    try
    {
        ++current.touches;
        callback (touch);
    }
    catch (...)
    {
        ++current.failures;
    }
}

TouchCounters TouchReceiver::counters() const
{
    const std::lock_guard lock (mutex);
    return published;
}
} // namespace antinode
