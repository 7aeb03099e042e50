#pragma once

#include <antinode_session/DesignWorker.h>
#include <antinode_session/Documents.h>
#include <antinode_session/PlayReports.h>
#include <antinode_session/UserMessages.h>
#include <antinode_touch/TouchReceiver.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace antinode
{
class AudioHost;
class NumberParameter;

/** What of a program that plays, foci or fingers, commands reach. */
struct RemotePlayer
{
    /** What plays just now. */
    struct Present
    {
        std::shared_ptr<const DeviceDocument> device;
        std::shared_ptr<const FocusDocument> focusDocument; ///< None: none was loaded.
        std::shared_ptr<const ModalModel> model;            ///< None before the first device is solved.
        FocusDescription focus;                             ///< As it is designed, without touches.
        bool isSolving = false;
        std::string error; ///< Why the requested device cannot be played.
    };

    using Ready = std::function<void (const PreparedFocus&)>;

    const SampleClock& clock;
    PlayReports& reports;
    std::function<void (int slot, PrepareDesign, Ready)> prepare; ///< As InstrumentSession, as the next line.
    std::function<bool (int slot, double amplitude, std::uint32_t request, std::int64_t due)> play;
    std::function<Present()> present; ///< [any but the audio thread], as the next line.
    std::function<std::vector<UserMessage>()> messages;
    std::function<void (const std::shared_ptr<const DeviceDocument>&, const std::shared_ptr<const FocusDocument>&)>
        load;                                ///< One of them may be none. [message thread]
    NumberParameter* voltageLimit = nullptr; ///< V, 0: none is set; null: there is none to set.
};

/** OSC commands that load, prepare and play, and their answers: what a script controls an experiment by. Docs/Manual/
    remote.md lists them. Made and ended on the message thread; take() and answers() belong to one other thread. */
class RemoteControl : public std::enable_shared_from_this<RemoteControl>
{
public:
    /** @param hostToControl, player  outlive this @param arms  whether `/antinode/arm 1` arms [message thread] */
    RemoteControl (AudioHost& hostToControl, RemotePlayer playerToControl, bool arms)
        : host (hostToControl), player (std::move (playerToControl)), mayArm (arms)
    {
    }

    /** A command; faults are answered by the sentence that a file would get. [receiver's thread] */
    void take (const OscMessage&, const OscSender&);

    /** What is to be sent. [receiver's thread] */
    std::vector<OscAnswer> answers();

private:
    /** A command on its way. */
    struct Request
    {
        OscSender sender;
        std::string id, command;
        std::vector<OscArgument> arguments; ///< Without the id.
    };

    struct Place
    {
        int slot = 0;
        std::string state = "is being designed"; ///< Empty: it can play.
        std::uint64_t generation = 0;            ///< Of what was asked for.
    };

    struct Played
    {
        Request request;
        std::string place;
        std::int64_t clampedBefore = 0;
    };

    struct Loading
    {
        Request request;
        std::shared_ptr<const DeviceDocument> device;
        std::shared_ptr<const FocusDocument> focus;
        std::chrono::steady_clock::time_point asked = {};
        double voltageLimit = 0; ///< V, that was set then; 0: none.
    };

    using Arguments = std::vector<OscArgument>;

    void answer (const Request&, const std::string& address, Arguments);
    void attempt (const Request&, const std::function<void()>& action);
    void run (const Request&);
    void later (const Request&, void (RemoteControl::*command) (const Request&));
    void answerTo (const OscSender&, const Request&);
    void load (const Request&);
    void set (const Request&);
    void prepare (const Request&);
    void loadWaveforms (const Request&);
    void play (const Request&);
    void arm (const Request&);
    void subscribe (const Request&);
    void keep (const Request&, const std::string& name, PrepareDesign);
    FocusDescription presentFocus();
    void loadOnMessageThread (Loading);
    void keepLimit (double volts);
    void tellLoaded();
    void tellReports();
    void tellStatus();
    Arguments status();
    std::int64_t clampedSamples();
    std::int64_t dueSample (const OscArgument&);
    double systemSeconds (std::int64_t sample);

    AudioHost& host;
    RemotePlayer player;
    bool mayArm;
    std::mutex mutex; ///< For the next lines, which the threads of designs and of messages have, too.
    std::vector<OscAnswer> waiting;
    std::map<std::string, Place> places;
    std::vector<Loading> loading;

    std::map<std::uint32_t, Played> played; ///< Of the receiver's thread, as all that follows.
    std::map<OscSender, int> replyPorts;
    std::set<OscSender> subscribers;
    Arguments toldStatus;
    std::chrono::steady_clock::time_point lastStatus;
    std::uint32_t requests = 0;
    std::int64_t unnamed = 0;       ///< Commands without an id.
    juce::ThreadPool reading { 1 }; ///< Of files; ends before all above.
};
} // namespace antinode
