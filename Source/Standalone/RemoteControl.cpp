#include "RemoteControl.h"

#include "AudioHost.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_documents/FocusFile.h>
#include <antinode_documents/Inputs.h>
#include <antinode_documents/SkinThresholds.h>
#include <antinode_focus/FocusPlaces.h>
#include <antinode_text/JsonText.h>
#include <antinode_tracks/TrackDesign.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <string_view>
#include <utility>

namespace antinode
{
namespace
{
constexpr double millimetres = 1000, latestStart = 60; // s ahead that a play may be asked for
constexpr std::size_t mostIdentifier = 64;

[[noreturn]] void refuse (const std::string& where, const std::string& wrong)
{
    throw InputError (where, wrong);
}

double numberOf (const OscArgument& argument, const std::string& name)
{
    const auto number = toNumber (argument);

    if (! number || ! std::isfinite (*number))
        refuse (name, "is no finite number; allowed: the types i, f, h and d");

    return *number;
}

const std::string& textOf (const OscArgument& argument, const std::string& name)
{
    const auto* const text = std::get_if<std::string> (&argument);

    if (text == nullptr || text->empty())
        refuse (name, "is no text; allowed: the type s");

    return *text;
}

/** As JSON that applyAssignment takes. */
std::string valueText (const OscArgument& argument)
{
    if (const auto* const text = std::get_if<std::string> (&argument))
        return *text;

    if (const auto* const flag = std::get_if<bool> (&argument))
        return *flag ? "true" : "false";

    return nlohmann::json (numberOf (argument, "the value")).dump();
}

/** Keys of the first target may stand alone. */
void assign (nlohmann::json& focus, const std::string& key, const OscArgument& value)
{
    const auto isOfTarget = key.find ('.') == std::string::npos && ! focus.contains (key) && focus.contains ("targets")
                            && ! focus["targets"].empty()
                            && (focus["targets"][0].contains (key) || key.starts_with ("peak_"));
    applyAssignment (focus, (isOfTarget ? "targets.0." + key : key) + "=" + valueText (value));
}

nlohmann::json jsonOf (const FocusDescription& focus)
{
    return nlohmann::json (focusToJson (focus));
}

/** Waveforms as samples that are played from the trigger on. */
PrepareDesign preparesWaveforms (WaveformsDescription waveforms)
{
    return [waveforms = std::move (waveforms)] (const ModalModel& model, Playback playback)
    {
        TrackSettings settings;
        settings.sampleRate = playback.sampleRate;
        settings.threshold = findSkinThreshold ({});
        const auto design = designTracks (model, waveforms, settings);
        PreparedDesign prepared;
        prepared.program.allocation.resize (model.actuators(), 0);
        prepared.program.voltageLimits = voltageLimits (model);
        prepared.program.samples = design.voltages;
        auto& samples = *prepared.program.samples;
        samples.playback = playback;
        // Voltages begin before the waveforms: these begin as much later after the trigger.
        prepared.program.focusTime = std::max (0.0, -samples.firstTime);
        samples.firstTime += prepared.program.focusTime;
        prepared.peakVoltage = design.peaks.maxCoeff();
        prepared.captured = std::sqrt (std::max (0.0, 1 - design.error * design.error));
        const auto at = placeAt (waveforms.tracks.front().point, 0);
        prepared.at = { at.x, at.y };
        return prepared;
    };
}

/** A focus as JSON, by name, or of a file. */
FocusDescription focusOf (const std::string& text, const std::string& place)
{
    if (! text.starts_with ('{'))
        return focusDocument (text)->description;

    return readFocusDocument (parseJson (text, "the focus of " + inQuotes (place)), "the focus of " + inQuotes (place))
        .description;
}

using Command = std::pair<std::string_view, std::pair<std::size_t, std::size_t>>; ///< Least and most arguments.

constexpr std::size_t anyNumber = 256;
constexpr std::array<Command, 10> commands { { { "/antinode/load", { 1, 2 } },
                                               { "/antinode/set", { 2, 2 } },
                                               { "/antinode/prepare", { 2, anyNumber } },
                                               { "/antinode/waveforms", { 2, 2 } },
                                               { "/antinode/play", { 1, 3 } },
                                               { "/antinode/stop", { 0, anyNumber } },
                                               { "/antinode/status", { 0, 0 } },
                                               { "/antinode/subscribe", { 0, 1 } },
                                               { "/antinode/reply", { 1, 1 } },
                                               { "/antinode/arm", { 1, 1 } } } };

void checkCommand (const std::string& name, std::size_t arguments)
{
    const auto* const known =
        std::find_if (commands.begin(), commands.end(), [&] (const auto& each) { return each.first == name; });

    if (known == commands.end())
    {
        std::vector<std::string_view> names;
        std::transform (commands.begin(), commands.end(), std::back_inserter (names),
                        [] (const auto& each) { return each.first; });
        refuse (printable (name), "is no command" + didYouMean (name, names) + "; allowed: " + listed (names));
    }

    const auto [least, most] = known->second;

    if (arguments < least || arguments > most)
        refuse (name, "has " + std::to_string (arguments) + " arguments; allowed: " + std::to_string (least)
                          + (most == least      ? std::string()
                             : most < anyNumber ? " to " + std::to_string (most)
                                                : std::string (" or more")));
}
} // namespace

void RemoteControl::answer (const Request& request, const std::string& address, Arguments arguments)
{
    arguments.insert (arguments.begin(), request.id);
    const std::lock_guard lock (mutex);
    waiting.push_back ({ request.sender, { "/antinode/" + address, std::move (arguments) } });
}

void RemoteControl::take (const OscMessage& message, const OscSender& sender)
{
    Request request { sender, {}, message.address, message.arguments };
    const auto port = replyPorts.find (sender);

    if (port != replyPorts.end())
        request.sender.port = port->second;

    // The id is the last argument, a text that begins with '#'; commands without one are numbered.
    if (! request.arguments.empty())
        if (const auto* const id = std::get_if<std::string> (&request.arguments.back());
            id != nullptr && id->starts_with ('#'))
        {
            request.id = printable (*id, mostIdentifier);
            request.arguments.pop_back();
        }

    if (request.id.empty())
        request.id = "#" + std::to_string (++unnamed);

    attempt (request,
             [&]
             {
                 checkCommand (request.command, request.arguments.size());
                 request.command == "/antinode/reply" ? answerTo (sender, request) : run (request);
             });
}

void RemoteControl::attempt (const Request& request, const std::function<void()>& action)
{
    try
    {
        action();
    }
    catch (const std::exception& failure)
    {
        answer (request, "refused", { std::string (failure.what()) });
    }
}

void RemoteControl::run (const Request& request)
{
    const auto& name = request.command;

    if (name == "/antinode/load")
        return later (request, &RemoteControl::load);

    if (name == "/antinode/set")
        return later (request, &RemoteControl::set);

    if (name == "/antinode/prepare")
        return later (request, &RemoteControl::prepare);

    if (name == "/antinode/waveforms")
        return later (request, &RemoteControl::loadWaveforms);

    if (name == "/antinode/play")
        return play (request);

    if (name == "/antinode/arm")
        return arm (request);

    if (name == "/antinode/subscribe")
        return subscribe (request);

    if (name == "/antinode/status")
        return answer (request, "status", status());

    answer (request, "accepted", { name }); // A stop, which is a touch as well.
}

/** On a thread of its own: files may be long, and a stop must not wait for them. */
void RemoteControl::later (const Request& request, void (RemoteControl::*command) (const Request&))
{
    constexpr int most = 64;

    if (reading.getNumJobs() >= most)
        refuse (request.command, std::to_string (most) + " commands wait already; wait for their answers");

    answer (request, "accepted", { request.command });
    reading.addJob ([this, request, command] { attempt (request, [&] { (this->*command) (request); }); });
}

void RemoteControl::answerTo (const OscSender& sender, const Request& request)
{
    constexpr std::size_t most = 256;
    const auto port = numberOf (request.arguments[0], "/antinode/reply: the port");

    if (! (port >= 1 && port <= 65535))
        refuse ("/antinode/reply: the port", "is " + inWords (port) + "; allowed: 1 to 65535");

    if (replyPorts.size() >= most && ! replyPorts.contains (sender))
        refuse ("/antinode/reply", std::to_string (most) + " senders have named ports; allowed: as many");

    replyPorts[sender] = static_cast<int> (port);
    auto moved = request;
    moved.sender.port = static_cast<int> (port);
    answer (moved, "accepted", { request.command });
}

void RemoteControl::load (const Request& request)
{
    Loading wanted { request, deviceDocument (textOf (request.arguments[0], "/antinode/load: the device")), nullptr };

    if (request.arguments.size() > 1)
        wanted.focus = focusDocument (textOf (request.arguments[1], "/antinode/load: the focus"));

    loadOnMessageThread (std::move (wanted));
}

void RemoteControl::set (const Request& request)
{
    auto focus = jsonOf (presentFocus());
    assign (focus, textOf (request.arguments[0], "/antinode/set: the key"), request.arguments[1]);
    loadOnMessageThread (
        { request, nullptr, std::make_shared<const FocusDocument> (readFocusDocument (focus, "the focus")) });
}

/** The newest one that was asked for, without the touches that rest on the surface for a while. */
FocusDescription RemoteControl::presentFocus()
{
    {
        const std::lock_guard lock (mutex);

        if (! loading.empty() && loading.back().focus != nullptr)
            return loading.back().focus->description;
    }

    const auto now = player.present();

    if (now.focusDocument == nullptr)
        refuse ("focus", "none is loaded; load one with '/antinode/load DEVICE FOCUS'");

    return now.focus;
}

/** Another device has other limits: it is armed again by who may. The limit that was set stays where it is the lower.
 */
void RemoteControl::loadOnMessageThread (Loading wanted)
{
    {
        const std::lock_guard lock (mutex);
        wanted.asked = std::chrono::steady_clock::now();
        wanted.voltageLimit = player.voltageLimit != nullptr ? parameterValue (*player.voltageLimit) : 0;
        loading.push_back (wanted);
    }

    juce::MessageManager::callAsync (
        [weak = weak_from_this(), wanted = std::move (wanted)]
        {
            const auto self = weak.lock();

            if (self == nullptr)
                return;

            if (wanted.device != nullptr)
                self->host.arm().setValueNotifyingHost (0);

            self->player.load (wanted.device, wanted.focus);
            self->keepLimit (wanted.voltageLimit);
        });
}

/** @param volts  0: there was none */
void RemoteControl::keepLimit (double volts)
{
    if (volts > 0)
        if (const auto now = parameterValue (*player.voltageLimit); now == 0 || now > volts)
            setValue (*player.voltageLimit, volts);
}

void RemoteControl::prepare (const Request& request)
{
    const auto& arguments = request.arguments;
    const auto& name = textOf (arguments[0], "/antinode/prepare: the id of the place");

    if (const auto* const text = std::get_if<std::string> (&arguments[1]); text != nullptr && arguments.size() == 2)
        return keep (request, name, preparesFocus (focusOf (*text, name)));

    if (player.present().model == nullptr)
        refuse ("/antinode/prepare", "no device is solved yet; load one, or wait for '/antinode/loaded'");

    // A beam has no y.
    const auto hasY = arguments.size() > 2 && toNumber (arguments[2]).has_value();
    const auto x = numberOf (arguments[1], "/antinode/prepare: x") / millimetres;
    const auto y = hasY ? numberOf (arguments[2], "/antinode/prepare: y") / millimetres : 0.0;
    const auto keys = std::span (arguments).subspan (hasY ? 3 : 2);

    if (keys.size() % 2 != 0)
        refuse ("/antinode/prepare", "has a key without a value; allowed: ID X [Y] and any number of KEY VALUE");

    auto focus = jsonOf (movedTo (presentFocus(), x, y));

    for (std::size_t i = 0; i < keys.size(); i += 2)
        assign (focus, textOf (keys[i], "/antinode/prepare: a key"), keys[i + 1]);

    keep (request, name, preparesFocus (readFocusDocument (focus, "the focus of " + inQuotes (name)).description));
}

void RemoteControl::loadWaveforms (const Request& request)
{
    const auto& name = textOf (request.arguments[0], "/antinode/waveforms: the id of the place");
    keep (request, name,
          preparesWaveforms (
              antinode::loadWaveforms (textOf (request.arguments[1], "/antinode/waveforms: the file"), {})));
}

void RemoteControl::keep (const Request& request, const std::string& name, PrepareDesign design)
{
    auto slot = 0;
    std::uint64_t generation = 0;
    {
        const std::lock_guard lock (mutex);
        const auto next = static_cast<int> (places.size());

        if (! places.contains (name) && next >= FocusBank::mostPrepared)
            refuse (request.command,
                    "there are " + std::to_string (next) + " prepared places already; allowed: as many");

        auto& place = places.try_emplace (name, Place { next }).first->second;
        place.state = Place().state;
        slot = place.slot;
        generation = ++place.generation;
    }

    player.prepare (slot, std::move (design),
                    [weak = weak_from_this(), request, name, generation] (const PreparedFocus& made)
                    {
                        const auto self = weak.lock();

                        if (self == nullptr)
                            return;

                        {
                            const std::lock_guard lock (self->mutex);

                            auto& place = self->places[name];

                            if (place.generation != generation)
                                return; // Another one was asked for meanwhile.

                            place.state = made.error;
                        }

                        if (made.error.empty())
                            self->answer (request, "designed",
                                          { name, made.peakVoltage, made.captured, made.sensationLevel,
                                            made.focusSeconds, made.endSeconds });
                        else
                            self->answer (request, "refused", { made.error });
                    });
}

/** The sample of the session that a time means: h counts samples, d is in seconds since 1970, t is OSC's own. */
std::int64_t RemoteControl::dueSample (const OscArgument& argument)
{
    constexpr double from1900To1970 = 2208988800.0; // s
    const auto& clock = player.clock;
    const auto now = std::chrono::steady_clock::now();
    const auto present = clock.sampleAt (now);

    if (! present)
        refuse ("/antinode/play: the time", "no audio device runs");

    const auto rate = host.callback().sampleRate();
    // At that time the sample leaves the device, not only the program.
    auto due = *present - std::llround (host.outputLatency() * rate);

    if (const auto* const sample = std::get_if<std::int64_t> (&argument))
        due = *sample;
    else
    {
        auto seconds = 0.0;

        if (const auto* const tag = std::get_if<OscTimeTag> (&argument))
            seconds = static_cast<double> (tag->value >> 32U) - from1900To1970
                      + static_cast<double> (tag->value & 0xFFFFFFFFU) / 4294967296.0;
        else if (const auto* const number = std::get_if<double> (&argument);
                 number != nullptr && std::isfinite (*number))
            seconds = *number;
        else
            refuse ("/antinode/play: the time", "is of another type; allowed: h (a sample), d (s since 1970) or t");

        const auto system = std::chrono::duration<double> (std::chrono::system_clock::now().time_since_epoch()).count();
        due += std::llround (std::clamp (seconds - system, -1.0, 2 * latestStart) * rate);
    }

    if (static_cast<double> (due) > static_cast<double> (*present) + latestStart * rate)
        refuse ("/antinode/play: the time", "is more than " + inWords (latestStart) + " s ahead; allowed: as much");

    return due;
}

void RemoteControl::play (const Request& request)
{
    const auto& name = textOf (request.arguments[0], "/antinode/play: the id of the place");
    const auto amplitude =
        request.arguments.size() > 1 ? numberOf (request.arguments[1], "/antinode/play: the amplitude") : 1.0;

    if (! (amplitude >= 0 && amplitude <= 1))
        refuse ("/antinode/play: the amplitude", "is " + inWords (amplitude) + "; allowed: 0 to 1");

    const auto due = request.arguments.size() > 2 ? dueSample (request.arguments[2]) : 0;
    auto slot = 0;
    {
        const std::lock_guard lock (mutex);
        const auto place = places.find (name);

        if (place == places.end())
        {
            std::vector<std::string_view> names;
            std::transform (places.begin(), places.end(), std::back_inserter (names),
                            [] (const auto& each) -> std::string_view { return each.first; });
            refuse ("/antinode/play: " + inQuotes (name),
                    "was not prepared" + didYouMean (name, names) + "; prepare it with '/antinode/prepare'");
        }

        if (! place->second.state.empty())
            refuse ("/antinode/play: " + inQuotes (name), place->second.state);

        slot = place->second.slot;
    }

    if (host.router().isMuted())
        refuse ("/antinode/play", "all outputs are muted; release them in the window");

    if (! host.arm().get())
        refuse ("/antinode/play", "the outputs are not armed; arm them in the window or with --arm");

    if (++requests == 0)
        ++requests;

    // So many can begin in one block, and each of them is told.
    if (played.size() >= TriggerQueue::capacity || ! player.play (slot, amplitude, requests, due))
        refuse ("/antinode/play",
                "too many plays wait; allowed: " + std::to_string (TriggerQueue::capacity) + " at once");

    played[requests] = { request, name, clampedSamples() };
    answer (request, "accepted", { request.command });
}

void RemoteControl::arm (const Request& request)
{
    const auto wanted = numberOf (request.arguments[0], "/antinode/arm") != 0;

    if (wanted && ! mayArm)
        refuse ("/antinode/arm",
                "arms only where the program was started with --allow-remote-arm; arm in the window or "
                "with --arm");

    // At once, as all that makes safe; arming waits for what the window does.
    if (! wanted)
    {
        host.arm().setValueNotifyingHost (0);
        host.stopAll();
        return answer (request, "accepted", { request.command });
    }

    juce::MessageManager::callAsync (
        [weak = weak_from_this(), request]
        {
            if (const auto self = weak.lock())
            {
                self->host.arm().setValueNotifyingHost (1);
                self->answer (request, "accepted", { request.command });
            }
        });
}

void RemoteControl::subscribe (const Request& request)
{
    constexpr std::size_t most = 32;
    const auto wanted = request.arguments.empty() || numberOf (request.arguments[0], "/antinode/subscribe") != 0;

    if (! wanted)
        subscribers.erase (request.sender);
    else if (subscribers.size() < most || subscribers.contains (request.sender))
        subscribers.insert (request.sender);
    else
        refuse ("/antinode/subscribe", "there are " + std::to_string (most) + " subscribers already; allowed: as many");

    answer (request, "accepted", { request.command });
    answer (request, "status", status());
}

RemoteControl::Arguments RemoteControl::status()
{
    const auto now = player.present();
    const auto error = firstWarning (player.messages());
    auto prepared = 0;
    {
        const std::lock_guard lock (mutex);
        prepared = static_cast<int> (
            std::count_if (places.begin(), places.end(), [] (const auto& each) { return each.second.state.empty(); }));
    }
    return { std::string ("device"),   now.device != nullptr ? now.device->description.name : std::string(),
             std::string ("focus"),    now.focus.name,
             std::string ("solving"),  now.isSolving,
             std::string ("armed"),    static_cast<bool> (host.arm().get()),
             std::string ("muted"),    host.router().isMuted(),
             std::string ("rate_Hz"),  host.callback().sampleRate(),
             std::string ("prepared"), prepared,
             std::string ("warning"),  error };
}

std::int64_t RemoteControl::clampedSamples()
{
    std::int64_t sum = 0;

    for (int output = 0; output < OutputRouting::maximumOutputs; ++output)
        sum += host.router().meters().clampedSamples (output);

    return sum;
}

/** When a sample leaves the device, s since 1970. */
double RemoteControl::systemSeconds (std::int64_t sample)
{
    const auto time = player.clock.timeOf (sample);

    if (! time)
        return 0;

    const auto ahead = std::chrono::duration<double> (*time - std::chrono::steady_clock::now()).count();
    const auto now = std::chrono::duration<double> (std::chrono::system_clock::now().time_since_epoch()).count();
    return now + ahead + host.outputLatency();
}

void RemoteControl::tellReports()
{
    auto& reports = player.reports;

    while (const auto report = reports.take())
    {
        const auto found = played.find (report->request);

        if (found == played.end())
            continue;

        const auto& [request, place, clampedBefore] = found->second;

        if (report->kind == PlayReport::Kind::begun)
        {
            answer (
                request, "playing",
                { place, report->onset, report->focus, systemSeconds (report->onset), systemSeconds (report->focus) });
            continue;
        }

        if (report->kind == PlayReport::Kind::empty)
            answer (request, "refused", { "/antinode/play: " + inQuotes (place) + " has no design at the moment" });
        else
            answer (request, "finished",
                    { place, static_cast<double> (report->peakVolts), report->limitedSamples,
                      clampedSamples() - clampedBefore,
                      std::string (report->kind == PlayReport::Kind::stopped ? "stopped" : "finished") });

        played.erase (found);
    }
}

void RemoteControl::tellLoaded()
{
    std::vector<Loading> ended;
    std::optional<Loading> replaced;
    const auto now = player.present();
    {
        const std::lock_guard lock (mutex);
        const auto isOver = [&] (const Loading& each) {
            return each.device != nullptr ? now.device == each.device && ! now.isSolving
                                          : now.focusDocument == each.focus;
        };

        // One that another one has replaced is over, too.
        for (auto i = loading.size(); i-- > 0;)
            if (isOver (loading[i]))
            {
                const auto end = loading.begin() + static_cast<std::ptrdiff_t> (i) + 1;
                ended.assign (loading.begin(), end);
                loading.erase (loading.begin(), end);
                break;
            }

        constexpr auto patience = std::chrono::seconds (120);

        if (ended.empty() && ! loading.empty() && std::chrono::steady_clock::now() > loading.front().asked + patience)
        {
            replaced = loading.front();
            loading.erase (loading.begin());
        }
    }

    if (replaced)
        answer (replaced->request, "refused", { replaced->request.command + ": another one was loaded in its place" });

    for (const auto& each : ended)
    {
        keepLimit (each.voltageLimit); // A device that came alone has got a focus with a limit of its own.

        if (now.error.empty())
            answer (each.request, "loaded", { now.device->description.name, now.focus.name });
        else
            answer (each.request, "refused", { now.error });
    }
}

void RemoteControl::tellStatus()
{
    constexpr auto interval = std::chrono::milliseconds (50);
    const auto time = std::chrono::steady_clock::now();

    if (subscribers.empty() || time < lastStatus + interval)
        return;

    lastStatus = time;
    auto now = status();

    if (now == toldStatus)
        return;

    toldStatus = std::move (now);

    for (const auto& subscriber : subscribers)
        answer ({ subscriber, "#status", {}, {} }, "status", toldStatus);
}

std::vector<OscAnswer> RemoteControl::answers()
{
    tellReports();
    tellLoaded();
    tellStatus();
    std::vector<OscAnswer> taken;
    const std::lock_guard lock (mutex);
    taken.swap (waiting);
    return taken;
}
} // namespace antinode
