"""Another program of the Lab Streaming Layer, by pylsl, for the tests of app.stream.

lsl-peer.py library                prints the file of liblsl that pylsl carries
lsl-peer.py send ID                sends a stream of the type EEG with the source id ID, one of markers,
                                   and ends with its standard input
lsl-peer.py receive NAME SOURCE    prints samples of the stream NAME whose source id contains SOURCE,
                                   a JSON list [time, values...] a line, until its standard input ends
"""
import json
import select
import sys

import pylsl


def ended(seconds=0):
    """Waits so long for the end of standard input and tells whether it has come."""
    return bool(select.select([sys.stdin], [], [], seconds)[0]) and not sys.stdin.readline()


def send(source):
    info = pylsl.StreamInfo("Amplifier", "EEG", 2, 100, pylsl.cf_float32, source)
    channels = info.desc().append_child("channels")
    for label in ("Cz", "Pz, left"):
        channel = channels.append_child("channel")
        channel.append_child_value("label", label)
        channel.append_child_value("unit", "microvolts")
    eeg = pylsl.StreamOutlet(info)
    markers = pylsl.StreamOutlet(
        pylsl.StreamInfo("Buttons", "Markers", 1, 0, pylsl.cf_string, source + "-buttons"))
    print("ready", flush=True)
    number = 0
    while not ended(0.01):
        eeg.push_sample([number, number + 0.5])
        if number % 10 == 0:
            markers.push_sample([f"button {number}, \u00e9"])
        number += 1


def receive(name, source):
    found = pylsl.resolve_bypred(f"name='{name}' and contains(source_id,'{source}')", 1, 20)
    if not found:
        sys.exit("no stream " + name)
    inlet = pylsl.StreamInlet(found[0])
    inlet.open_stream(20)
    info = inlet.info(20)
    labels = []
    channel = info.desc().child("channels").child("channel")
    for _ in range(info.channel_count()):
        labels.append(channel.child_value("label"))
        channel = channel.next_sibling()
    print(json.dumps([info.type()] + labels), flush=True)
    while not ended():
        sample, stamp = inlet.pull_sample(0.1)
        if sample is not None:
            print(json.dumps([stamp + inlet.time_correction(1)] + sample), flush=True)


if sys.argv[1] == "library":
    print(pylsl.lib.lib._name)
elif sys.argv[1] == "send":
    send(sys.argv[2])
else:
    receive(sys.argv[2], sys.argv[3])
