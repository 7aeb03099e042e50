-- Makes a session with three tracks, Antinode Touch behind them and a track that records its outputs, and plays it: Scripts/session.
-- Environment: FOLDER gets the session, TRACKS has drum.f32, bass.f32 and lead.f32 (mono floats), SECONDS is their length, CERAMICS the
-- number of outputs. Ardour can import files in its window only: so each track records silence, which its samples then replace.
local seconds, ceramics = tonumber (os.getenv ("SECONDS")), tonumber (os.getenv ("CERAMICS"))
local names = { "drum", "bass", "lead" }
local fingers, rate = 8, 48000 -- inputs of Antinode Touch, Hz
local solving, rolling, ringing = 6, 1, 1 -- s
local session = create_session (os.getenv ("FOLDER"), "antinode", rate)
local last, normal = ARDOUR.PresentationInfo.max_order, ARDOUR.TrackMode.Normal
local nobody = PBD.GroupControlDisposition.NoGroup
local byUser = ARDOUR.TransportRequestSource.TRS_UI

local function record (tracks, length)
    for _, track in ipairs (tracks) do
        track:rec_enable_control ():set_value (1, nobody)
    end
    session:goto_start (false)
    sleep (rolling)
    session:maybe_enable_record ()
    session:request_roll (byUser)
    sleep (rolling)
    assert (session:actively_recording (), "the session does not record")
    sleep (length)
    session:request_stop (false, false, byUser)
    sleep (rolling)
    session:disable_record (false)
    for _, track in ipairs (tracks) do
        track:rec_enable_control ():set_value (0, nobody)
    end
end

local function fill (name)
    local path = os.getenv ("FOLDER") .. "/interchange/ardour/audiofiles/Take1_" .. name .. "-1.wav"
    local source = assert (io.open (os.getenv ("TRACKS") .. "/" .. name .. ".f32", "rb"))
    local file = assert (io.open (path, "r+b"))
    local _, behind = file:read (4096):find ("data", 1, true)
    file:seek ("set", behind + 4)
    file:write (source:read ("a"))
    file:close ()
    source:close ()
end

local tracks = {}
for k, name in ipairs (names) do
    tracks[k] = session:new_audio_track (1, 1, nil, 1, name, last, normal, false):front ()
end
record (tracks, seconds)
for _, name in ipairs (names) do
    fill (name)
end

local bus = session:new_audio_route (fingers, ceramics, nil, 1, "fingers", ARDOUR.PresentationInfo.Flag.AudioBus, last):front ()
local touch = ARDOUR.LuaAPI.new_plugin (session, os.getenv ("PLUGIN"), ARDOUR.PluginType.LV2, "session")
assert (not touch:isnil (), "Antinode Touch is not in LV2_PATH")
assert (bus:add_processor_by_index (touch, 0, nil, true) == 0, "Antinode Touch does not fit the bus")
assert (bus:n_outputs ():n_audio () == ceramics, "the bus has not all outputs")
bus:panner_shell ():set_bypassed (true) -- they are no loudspeakers
local voltages = session:new_audio_track (ceramics, ceramics, nil, 1, "voltages", last, normal, false):front ()

for k, track in ipairs (tracks) do
    track:output ():disconnect_all (nil)
    assert (track:output ():audio (0):connect (bus:input ():audio (k - 1):name ()) == 0, "a track cannot be connected")
end
for k = 0, ceramics - 1 do
    assert (bus:output ():audio (k):connect (voltages:input ():audio (k):name ()) == 0, "an output cannot be connected")
end

sleep (solving)
record ({ voltages }, seconds + ringing)
session:save_state ("")
close_session ()
