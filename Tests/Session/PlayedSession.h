#pragma once

#include <antinode_documents/Library.h>
#include <antinode_session/FocusSettings.h>
#include <antinode_session/Session.h>
#include <nlohmann/json.hpp>

#include <Eigen/Core>

#include <array>
#include <atomic>
#include <vector>

namespace antinode::test
{
inline DeviceDocument deviceNamed (const std::string& name)
{
    return readDeviceDocument (loadDocument (LibraryKind::device, name), name);
}

inline FocusDocument focusNamed (const std::string& name)
{
    return readFocusDocument (loadDocument (LibraryKind::focus, name), name);
}

/** A session on the demonstrator whose parameters are a value. */
struct PlayedSession
{
    PlayedSession() : PlayedSession ("staple", "demonstrator") {}

    PlayedSession (const std::string& device, const std::string& focus)
        : PlayedSession (deviceNamed (device), focusNamed (focus))
    {
    }

    PlayedSession (const DeviceDocument& device, const FocusDocument& focus)
        : settings (settingsFromFocus (focus.description, deviceExtent (device.description), {})),
          thread (
              device, focus, [this] { return read(); }, [] {})
    {
    }

    PlaySettings read()
    {
        const std::lock_guard lock (mutex);
        return settings;
    }

    template <typename Change>
    void change (Change&& apply)
    {
        const std::lock_guard lock (mutex);
        apply (settings);
    }

    /** As an offline host does, which never plays a silent first block. */
    void prepare (double sampleRate)
    {
        session.prepare (sampleRate);
        session.waitUntilSettled (std::array { FocusEvent { 0, FocusEventKind::trigger, Session::spotNote, 1 } });
    }

    /** Plays blocks of 64 samples. @return  8 ceramics and 2 probes x samples */
    Eigen::MatrixXd play (int samples, std::vector<FocusEvent> events = {}, PlayControls controls = {})
    {
        constexpr int block = 64;
        Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> played (10, samples);

        for (int done = 0; done < samples; done += block)
        {
            std::vector<double*> channels;

            for (Eigen::Index i = 0; i < 10; ++i)
                channels.push_back (&played (i, done));

            session.process<double> ({ {},
                                       std::span (channels).first (8),
                                       std::span (channels).last (2),
                                       std::min (block, samples - done),
                                       events },
                                     controls);
            events.clear();
        }

        return played;
    }

    std::mutex mutex;
    PlaySettings settings;
    SessionThread<Session> thread;
    Session& session = *thread;
};
} // namespace antinode::test
