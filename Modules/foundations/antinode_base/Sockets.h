#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace antinode
{
/** Whether a text is an IPv4 address, for example 127.0.0.1. [any] */
bool isIpv4Address (const std::string&);

/** Waits until sockets have something to read, or have failed.
    @return  their places in the list; none after the time, or after a signal [worker] */
std::vector<std::size_t> waitForSockets (std::span<const int> sockets, int milliseconds);
} // namespace antinode
