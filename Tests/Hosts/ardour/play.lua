-- Plays one note of Antinode 32 in a headless session and records all its outputs. FOLDER, in the environment, gets the session.
local channels, rate = 10, 48000
local solving, rolling, playing = 8, 1, 2 -- s
local session = create_session (os.getenv ("FOLDER"), "antinode", rate)
local info = ARDOUR.LuaAPI.new_plugin_info ("https://antinode.example/plugins/antinode-32", ARDOUR.PluginType.LV2)
assert (not info:isnil (), "Antinode 32 is not in LV2_PATH")

local function count (kind, n)
    return ARDOUR.ChanCount (ARDOUR.DataType (kind), n)
end

-- Not with strict outputs: Ardour then gives an instrument two of them, whatever it has.
local last, normal = ARDOUR.PresentationInfo.max_order, ARDOUR.TrackMode.Normal
local play = session:new_midi_track (count ("midi", 1), count ("audio", channels), false, info, nil, nil, 1, "play", last,
                                     normal, true):front ()
local record = session:new_audio_track (channels, channels, nil, 1, "record", last, normal, false):front ()
assert (play:n_outputs ():n_audio () == channels, "the instrument has not all of its outputs")

-- Ardour pans an instrument of many outputs as if they were loudspeakers round a listener.
play:panner_shell ():set_bypassed (true)

for k = 0, channels - 1 do
    local failure = play:output ():audio (k):connect (record:input ():audio (k):name ())
    assert (failure == 0, "an output cannot be connected")
end

sleep (solving)
record:rec_enable_control ():set_value (1, PBD.GroupControlDisposition.NoGroup)
session:maybe_enable_record ()
session:request_roll (ARDOUR.TransportRequestSource.TRS_UI)
sleep (rolling)
assert (session:actively_recording (), "the session does not record")
local note = C.ByteVector ():add ({ 0x90, 60, 127 }):to_array ()
play:to_track ():to_midi_track ():write_immediate_event (Evoral.EventType.MIDI_EVENT, 3, note)
sleep (playing)
session:request_stop (false, false, ARDOUR.TransportRequestSource.TRS_UI)
sleep (1)
session:save_state ("")
close_session ()
