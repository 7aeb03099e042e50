#pragma once

#include <Processor/AntinodeProcessor.h>

#include <functional>
#include <set>
#include <string>
#include <vector>

namespace antinode
{
/** Undo and redo of the user's changes to a processor: one entry per gesture. What a host automates makes no entry and
   is not undone, and neither is arming: nothing but its own switch puts voltage on the ceramics. All of it: [message
   thread] */
class History : private juce::AudioProcessorParameter::Listener
{
public:
    explicit History (AntinodeProcessor&);
    ~History() override;

    /** Does something that is no gesture of a parameter, as one entry. */
    void record (const std::function<void()>& change);

    /** Forgets the drift that is followed, as one entry. */
    void resetDrift();

    /** The next gesture makes an entry of its own, even if it follows the last one closely. */
    void closeEntry() { mayJoin = false; }

    bool canUndo() const { return position > 0; }
    bool canRedo() const { return position < entries.size(); }
    void undo();
    void redo();

private:
    /** The changes of an entry: unchanged parameters are left out. */
    struct Entry
    {
        SessionState before, after;
        juce::uint32 time = 0;                        ///< ms
        std::shared_ptr<const KnownDrift> drift = {}; ///< That was forgotten; none: it was not.
    };

    void parameterValueChanged (int, float) override {}
    void parameterGestureChanged (int index, bool isStarting) override;
    void add (SessionState before, const std::set<std::string>* gestured);
    void push (Entry);
    void apply (const SessionState& wanted, const SessionState& present);

    AntinodeProcessor& processor;
    std::vector<Entry> entries;
    std::size_t position = 0; ///< The number of entries that are done.
    SessionState atStart;     ///< Of the gesture that goes on.
    std::set<std::string> gestured;
    int gestures = 0;
    bool mayJoin = false, isApplying = false;
};
} // namespace antinode
