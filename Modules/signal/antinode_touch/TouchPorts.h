#pragma once

#include <string>

namespace antinode
{
/** UDP ports: 0 = off, 1 to 65535, or `anyFree`. Each takes OSC and TUIO alike; they are two because senders have two
    customs. */
struct TouchPorts
{
    static constexpr int anyFree = -1;

    int oscPort = 9000;
    int tuioPort = 3333;

    /** IPv4, of the listening interface: 127.0.0.1 accepts this computer only, 0.0.0.0 the whole network. */
    std::string address = "127.0.0.1";

    /** What TUIO cursors rest on the surface: a kind of finger. Empty: they play foci. */
    std::string finger = {};
};
} // namespace antinode
