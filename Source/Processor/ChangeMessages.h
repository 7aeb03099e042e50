#pragma once

#include <functional>
#include <memory>

namespace antinode
{
/** Calls a function on JUCE's message thread after something has changed, once for many changes. In a plug-in that
   thread is none of the host's, which makes and frees the plug-in meanwhile: so nothing is called before begin() or
   once end() has returned. */
class ChangeMessages
{
public:
    explicit ChangeMessages (std::function<void()> toCall);
    ~ChangeMessages();
    ChangeMessages (const ChangeMessages&) = delete;
    ChangeMessages& operator= (const ChangeMessages&) = delete;

    /** Calls from now on, and the first time for what has changed before. [any but the audio thread] */
    void begin();

    /** Waits for a call that is under way. [any but the audio thread] */
    void end();

    /** Something has changed. [any but the audio thread] */
    void post();

private:
    struct Link;

    std::shared_ptr<Link> link; ///< Messages keep it too.
};
} // namespace antinode
