"""Exports whose times stand in parts, and those of what records events; for make_exports.py."""
import datetime as dt
import json


def stamp(t):
    return f"{t:%Y-%m-%dT%H:%M:%S}.000000+00:00"


def entity(name, values, start, k_missing):
    """States as the service writes them in short: only the first names its entity."""
    states = []
    for k, value in enumerate(values):
        state = "unavailable" if k in k_missing else f"{value:.2f}"
        one = {"state": state, "last_changed": stamp(start + dt.timedelta(seconds=k))}
        if k == 0:
            one = {"entity_id": name, "attributes": {"unit_of_measurement": "%"}, **one}
        states.append(one)
    return states


def exports(rows, start, missing):
    """(name, text) of each; `rows`: (u, y, sp) by sample, 1 s apart; y lacks `missing`."""
    at = [start + dt.timedelta(seconds=k) for k in range(len(rows))]
    pairs = [f"{u:.2f},{y:.2f}" for u, y, _ in rows]
    tags = ("sensor.fic101_op", "sensor.fic101_pv")
    yield "datevec.csv", "Year,Month,Day,Hour,Minute,Second,FIC101.OP,FIC101.PV\n" + "".join(
        f"{t.year},{t.month},{t.day},{t.hour},{t.minute},{t.second}.25,{p}\n"
        for t, p in zip(at, pairs))
    yield "date-hour-minute-second.csv", "Datum;Stunde;Minute;Sekunde;OP;PV\n" + "".join(
        f"{t:%d.%m.%Y};{t.hour};{t.minute};{t.second};{p.replace(',', ';').replace('.', ',')}\n"
        for t, p in zip(at, pairs))
    yield "hour-minute-second.csv", "HH,MM,SS,OP,PV\n" + "".join(
        f"{t.hour:02d},{t.minute:02d},{t.second:02d},{p}\n"
        for t, p in zip((t + dt.timedelta(hours=9, minutes=29, seconds=50) for t in at), pairs))
    yield "plc-durations.csv", "Time;gPid.Setpoint;gPid.Input;gPid.Output\n" + "".join(
        f"T#{k // 60}m{k % 60}s250ms;{sp:.2f};{y:.2f};{u:.2f}\n"
        for k, (u, y, sp) in enumerate(rows))
    yield "home-assistant.json", json.dumps(
        [entity(tags[0], [r[0] for r in rows], start, ()),
         entity(tags[1], [r[1] for r in rows], start, missing)]) + "\n"
    first = (start - dt.datetime(1970, 1, 1)).total_seconds()
    yield "home-assistant-socket.json", json.dumps(
        {tag: [{"s": "unknown" if i == 1 and k in missing else f"{rows[k][i]:.2f}",
                "a": {}, "lu": first + k + 0.25} for k in range(len(rows))]
         for i, tag in enumerate(tags)}) + "\n"
    events = sorted((k + 0.4 * i, i, rows[k][i]) for k in range(len(rows)) for i in range(2))
    yield "outer-join.csv", "Time [s],FIC101.OP,FIC101.PV\n" + "".join(
        f"{t:.1f},{value:.2f},\n" if i == 0 else f"{t:.1f},,{value:.2f}\n"
        for t, i, value in events)
