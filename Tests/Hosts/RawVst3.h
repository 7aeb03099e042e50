#pragma once

#include "Vst3HostObjects.h"

#include <Eigen/Core>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace antinode::test
{
/** The factory of the built VST3, which stays loaded to the end of the program. [main thread] */
Steinberg::IPluginFactory& vst3Factory();

/** One block that a host is about to play. */
struct Vst3Block
{
    int start = 0, count = 0; ///< Samples.
    EventList events;
    ParameterChanges changes;
};

/** The VST3 as a host sees it that knows nothing of JUCE. [main thread] */
class RawVst3
{
public:
    enum class Connection
    {
        direct,
        byMessages
    };

    struct Processing
    {
        double sampleRate = 48000;
        int longestBlock = 512;
        bool isOffline = true, isDouble = false;
    };

    /** Makes component and controller and connects them.
        @param ceramics  what ANTINODE_CERAMICS says meanwhile */
    explicit RawVst3 (int ceramics = 8, Connection = Connection::direct);
    ~RawVst3();
    RawVst3 (const RawVst3&) = delete;
    RawVst3& operator= (const RawVst3&) = delete;

    /** Asks for the speakers of the N lowest bits. @param monitors  0: its bus is switched off
        @return  whether the plug-in says that it has them now */
    bool setLayout (int ceramics, int monitors);

    /** Asks for the speakers of all buses, as VST3 wants it: of one input for the sensor, and of both outputs. */
    Steinberg::tresult arrange (Vst::SpeakerArrangement main, Vst::SpeakerArrangement monitor);

    void activate (const Processing&);
    void deactivate();

    /** Channels of a bus, also of one that is off. */
    int channels (int bus) const;
    bool isActive (int bus) const { return active[static_cast<std::size_t> (bus)]; }

    /** Plays blocks of a length until so many samples are played. @return  active channels x samples */
    Eigen::MatrixXd play (int samples, int block, const std::function<void (Vst3Block&)>& prepareBlock);

    /** The same with one note. */
    Eigen::MatrixXd play (int samples, int block, int noteAt, int note = 60);

    std::vector<Vst::ParameterInfo> parameters();

    /** The identifier of a parameter that is there. */
    Vst::ParamID parameter (const std::u16string& title);

    /** Whether note 60 reaches the first ceramics. */
    bool isPlaying() { return play (1024, 512, 0).topRows (2).cwiseAbs().maxCoeff() > 1e-3; }

    std::string state();
    bool setState (const std::string&);

    Vst::IComponent* component = nullptr;
    Vst::IAudioProcessor* processor = nullptr;
    Vst::IEditController* controller = nullptr;
    ComponentHandler handler;

private:
    template <typename Sample>
    void playBlock (Vst3Block&, Eigen::MatrixXd& played);
    void connect (Connection);

    Vst::HostApplication application;
    Vst::IConnectionPoint *componentEnd = nullptr, *controllerEnd = nullptr;
    std::unique_ptr<ConnectionProxy> toComponent, toController;
    std::vector<bool> active { true, true };
    Processing processing;
};

/** A note for a block. */
Vst::Event noteOn (int offset, int note, float velocity = 1);
} // namespace antinode::test
