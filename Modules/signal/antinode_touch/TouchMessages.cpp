#include "TouchMessages.h"

#include "OscPacket.h"

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
/** The numbers of a message; none if an argument is no number. */
std::vector<double> readNumbers (const OscMessage& message)
{
    std::vector<double> numbers;

    for (const auto& argument : message.arguments)
    {
        const auto number = toNumber (argument);

        if (! number)
            return {};

        numbers.push_back (*number);
    }

    return numbers;
}

/** Numbers of fingers are those of one hand or many; TUIO's are above all of them. */
bool isFingerNumber (double number)
{
    constexpr double most = 1000;
    return number >= 0 && number <= most && number == std::floor (number);
}

void readPlace (const OscMessage& message, bool inMillimetres, std::vector<Touch>& touches, TouchCounters& counters)
{
    const auto numbers = readNumbers (message);

    // A beam has no y; a fraction of nothing would be a guess.
    if (numbers.size() < (inMillimetres ? 1 : 2) || numbers.size() > 3)
        return counters.count (TouchFault::wrongArguments);

    Touch touch { TouchKind::focusAt, inMillimetres, numbers[0], 0, 1 };

    if (numbers.size() > 1)
        touch.y = numbers[1];

    if (numbers.size() > 2)
        touch.amplitude = numbers[2];

    if (const auto fault = findFault (touch))
        return counters.count (*fault);

    touch.amplitude = std::clamp (touch.amplitude, 0.0, 1.0);
    touches.push_back (touch);
}
} // namespace

void TouchMessages::readFinger (const OscMessage& message, std::vector<Touch>& touches, TouchCounters& counters)
{
    const auto numbers = readNumbers (message);

    if (numbers.size() != 3 || ! isFingerNumber (numbers[0]))
        return counters.count (TouchFault::wrongArguments);

    const Touch touch { TouchKind::rest, false, numbers[1], numbers[2], 1, static_cast<std::int64_t> (numbers[0]) };

    if (const auto fault = findFault (touch))
        return counters.count (*fault);

    fingers.insert (touch.finger);
    touches.push_back (touch);
}

void TouchMessages::readLift (const OscMessage& message, std::vector<Touch>& touches, TouchCounters& counters)
{
    const auto numbers = readNumbers (message);
    auto lifted = fingers;

    // Rather too many fingers are lifted than one too few.
    if (numbers.size() != message.arguments.size() || numbers.size() > 1
        || ! std::all_of (numbers.begin(), numbers.end(), isFingerNumber))
        counters.count (TouchFault::wrongArguments);
    else if (! numbers.empty())
        lifted = { static_cast<std::int64_t> (numbers[0]) };

    for (const auto finger : lifted)
    {
        fingers.erase (finger);
        touches.push_back ({ TouchKind::lift, false, 0, 0, 1, finger });
    }
}

std::vector<Touch> TouchMessages::read (std::span<const std::byte> bytes, Time now, TouchCounters& counters,
                                        std::vector<OscCommand>* commands)
{
    ++counters.packets;
    const auto packet = readOscPacket (bytes);

    if (packet.fault)
        counters.count (*packet.fault);

    for (int i = 0; i < packet.unknownTypes; ++i)
        counters.count (TouchFault::unknownType);

    std::vector<Touch> touches;

    for (const auto& message : packet.messages)
    {
        const auto isTouch = readMessage (message, now, touches, counters);

        // A stop is a touch, and is answered as a command.
        if (commands != nullptr && message.address.starts_with ("/antinode/")
            && (! isTouch || message.address == OscPacket::stop))
            commands->push_back ({ message, touches.size() });
        else if (! isTouch)
            counters.count (TouchFault::unknownAddress);
    }

    return touches;
}

std::vector<Touch> TouchMessages::endSilent (Time now)
{
    std::vector<Touch> touches;
    sources.endSilent (now, touches);
    return touches;
}

/** @return  false where it is no touch */
bool TouchMessages::readMessage (const OscMessage& message, Time now, std::vector<Touch>& touches,
                                 TouchCounters& counters)
{
    if (message.address == "/antinode/focus")
        readPlace (message, true, touches, counters);
    else if (message.address == "/antinode/touch")
        readPlace (message, false, touches, counters);
    else if (message.address == OscPacket::stop)
        touches.push_back ({ TouchKind::stopAll, false, 0, 0, 0 });
    else if (message.address == "/antinode/finger")
        readFinger (message, touches, counters);
    else if (message.address == OscPacket::lift)
        readLift (message, touches, counters);
    else if (message.address == TuioSources::address)
        sources.read (message, now, touches, counters);
    else
        return message.address.starts_with ("/tuio/");

    return true;
}
} // namespace antinode
