#include <Processor/DeviceProcessor.h>
#include <Processor/ParameterSet.h>
#include <Processor/ParameterTypes.h>
#include <antinode_session/DeviceRounds.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <atomic>

using namespace antinode;

// A new role is what stands here: a session, parameters, a processor, and the line that says what its states are.
namespace
{
constexpr SessionRole steadyRole { "antinode.steady/1" };

struct SteadySnapshot
{
    std::shared_ptr<const DeviceDocument> device;
    std::shared_ptr<const ModalModel> model;
    bool isSolving = false;
    std::string error;
};

struct SteadyControls
{
    bool isArmed = true;
    double share = 0; ///< Of full scale.
};

/** The same voltage at each ceramic, all the time. */
class SteadySession : public DeviceRounds<SteadySnapshot, int, double>
{
public:
    using DeviceRounds::DeviceRounds;

    void prepare (double sampleRate) { ask (sampleRate); }

    template <typename Sample>
    void process (const AudioBlock<Sample>& block, const SteadyControls& controls)
    {
        block.silence();

        for (std::size_t i = 0; controls.isArmed && i < std::min (block.outputs.size(), ceramics.load()); ++i)
            std::fill_n (block.outputs[i], block.count, static_cast<Sample> (controls.share));
    }

private:
    void work() override
    {
        if (takeDocument())
            solve ([this] { ceramics = static_cast<std::size_t> (present.model->actuators()); });
    }

    void clear() override {}

    std::atomic<std::size_t> ceramics { 0 };
};

class SteadyParameters : public ParameterSet
{
public:
    SteadyParameters (juce::AudioProcessor& processor, const SurfaceSource&)
    {
        GroupBuilder group (processor, "output", "Output", ordered);
        share = group.number ("share", "Share", "", { 0, 1 }, 0.5, unitTexts ("", 3));
        bypassed = group.flag ("bypass", "Bypass", false, "bypassed", "playing");
        group.addToProcessor();
        begin();
    }

    int settings() const { return 0; }
    SteadyControls controls() const { return { ! bypassed->get(), share->get() }; }

private:
    NumberParameter* share;
};

class SteadyProcessor : public RoleProcessor<SteadySession, SteadyParameters>
{
public:
    SteadyProcessor()
        : RoleProcessor ({ {}, { "Ceramics", 10 } }, wrapperType_Undefined, steadyRole, deviceDocument ("beam"))
    {
        start (std::tuple { *device() });
    }

    ~SteadyProcessor() override { close(); }

    SessionState state() const override { return { device(), {}, parameters().values() }; }
    void setState (const SessionState& wanted, bool) override
    {
        parameters().setValues (wanted.parameters);
        keep (wanted.device);
        session().load (wanted.device);
    }

    const juce::String getName() const override { return "Steady"; }
    double getTailLengthSeconds() const override { return 0; }
    juce::AudioProcessorEditor* createEditor() override { return nullptr; }
    bool hasEditor() const override { return false; }

private:
    Playing playing() const override { return { session().snapshot()->model, session().snapshot()->error }; }
};

juce::AudioBuffer<float> played (SteadyProcessor& processor)
{
    juce::AudioBuffer<float> buffer (10, 64);
    juce::MidiBuffer midi;
    processor.setNonRealtime (true);
    processor.prepareToPlay (48000, 64);
    processor.processBlock (buffer, midi);
    return buffer;
}
} // namespace

TEST_CASE ("A new role is one file: it plays, is bypassed, and keeps states of its own", "[plugin][role]")
{
    SteadyProcessor processor, other;
    processor.parameters().setValues ({ { "share", 0.25 } });
    const auto heard = played (processor);
    CHECK (heard.getSample (5, 63) == 0.25F);
    CHECK (heard.getMagnitude (6, 0, 64) == 0); // The beam has 6 ceramics.
    juce::MemoryBlock kept;
    processor.getStateInformation (kept);
    other.setStateInformation (kept.getData(), static_cast<int> (kept.getSize()));
    CHECK (other.warning().isEmpty());
    CHECK (played (other).getSample (0, 0) == 0.25F);
    processor.parameters().bypass() = true;
    CHECK (played (processor).getMagnitude (0, 64) == 0);
    const std::string foreign = R"({"schema":"antinode.plate/1"})";
    processor.setStateInformation (foreign.data(), static_cast<int> (foreign.size()));
    CHECK (processor.warning().startsWith ("The saved state could not be read; nothing was changed: "));
}
