#pragma once

#include <antinode_base/BackgroundThread.h>

#include <functional>
#include <memory>
#include <mutex>
#include <utility>

namespace antinode
{
/** What a session's thread calls of its owner. The owner may leave while the thread goes on: from then on nothing of it
   is called.
    @tparam Settings  what its parameters say */
template <typename Settings>
class SessionOwner
{
public:
    /** Both are called on the session's thread and must not block. */
    SessionOwner (std::function<Settings()> read, std::function<void()> changed)
        : readSettings (std::move (read)), onChange (std::move (changed))
    {
    }

    /** What the parameters say; what they said before where the owner has left. [worker] */
    Settings settings (const Settings& before)
    {
        const std::lock_guard lock (mutex);
        return hasLeft ? before : readSettings();
    }

    /** Tells of a change. [worker] */
    void tell() { call (onChange); }

    /** Calls a function of the owner's. @return  false where the owner has left, and nothing was called [worker] */
    template <typename Function>
    bool call (const Function& function)
    {
        const std::lock_guard lock (mutex);

        if (! hasLeft)
            function();

        return ! hasLeft;
    }

    /** Waits for a call that is under way. [any but the audio thread] */
    void leave()
    {
        const std::lock_guard lock (mutex);
        hasLeft = true;
    }

private:
    std::function<Settings()> readSettings;
    std::function<void()> onChange;
    std::recursive_mutex mutex; ///< What is called may load another device and so on.
    bool hasLeft = false;
};

/** A session with a thread of its own. Both may go on for a moment after this: then the thread ends as soon as its work
    looks at the watch, and frees the session.
    @tparam Session  run() works until leave() */
template <typename Session>
class SessionThread
{
public:
    /** Starts it. @param arguments  the session's [worker] */
    template <typename... Arguments>
    explicit SessionThread (Arguments&&... arguments)
        : session (std::make_shared<Session> (std::forward<Arguments> (arguments)...)),
          thread ([kept = session] { kept->run(); })
    {
    }

    ~SessionThread() { session->leave(); }
    SessionThread (const SessionThread&) = delete;
    SessionThread& operator= (const SessionThread&) = delete;

    Session& operator*() const { return *session; }
    Session* operator->() const { return session.get(); }

private:
    std::shared_ptr<Session> session;
    BackgroundThread thread;
};
} // namespace antinode
