#!/usr/bin/env python3
"""Writes the exports that unit/workbench/recording/test_csv_exports.cpp opens, and their truth.

    make_exports.py [FOLDER]

One loop with a sticking valve is simulated (values invented, the same on every machine);
each file spells its samples after the habits of one system: names, dates, marks, preambles,
gaps. truth.csv has t (s), u, y, sp of every sample. Files that are refused hold little more
than the bytes they begin with.
"""
import datetime as dt
import pathlib
import sys

import parted_exports
from write_workbook import cells, open_document, workbook

SAMPLES = 40
START = dt.datetime(2026, 5, 13, 14, 30, 0)
GERMAN = ["Jan", "Feb", "Mrz", "Apr", "Mai", "Jun", "Jul", "Aug", "Sep", "Okt", "Nov", "Dez"]
ENGLISH = ["Jan", "Feb", "Mar", "Apr", "May", "Jun", "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"]
HELD = range(10, 13)  # samples of y that some files lack


def loop():
    """(u, y, sp) by sample: a PI controller, a valve with stick band 4 %, one lag."""
    rows, stem, y, integral, sp, state = [], 44.0, 48.0, 45.0, 50.0, 1
    for k in range(SAMPLES):
        if k == 25:
            sp = 52.0
        error = sp - y
        integral += 0.12 * error
        u = integral + 0.4 * error
        if abs(u - stem) > 4.0:
            stem += (u - stem) * 0.8
        state = (state * 1103515245 + 12345) % 2**31
        y += 0.25 * (1.1 * stem - y) + (state / 2**31 - 0.5) * 0.1
        rows.append((round(u, 2), round(y, 2), sp))
    return rows


ROWS = loop()


def at(k, start=START, step=1.0):
    return start + dt.timedelta(seconds=k * step)


def point(value, digits=2):
    return f"{value:.{digits}f}"


def comma(value, digits=2):
    return point(value, digits).replace(".", ",")


def english_month(t):
    return f"{t.day:02d}-{ENGLISH[t.month - 1]}-{t:%y %H:%M:%S}"


def german_month(t):
    return f"{t.day:02d}-{GERMAN[t.month - 1]}-{t:%y %H:%M:%S}"


def us(t):
    return f"{t.month}/{t.day}/{t.year} {(t.hour - 1) % 12 + 1}:{t:%M:%S} {t:%p}"


def german(t):
    return f"{t:%d.%m.%Y %H:%M:%S}"


def iso(t):
    return f"{t:%Y-%m-%d %H:%M:%S}"


def epoch(t):
    return (t - dt.datetime(1970, 1, 1)).total_seconds()


def serial(t):
    return (t - dt.datetime(1899, 12, 30)).total_seconds() / 86400


def table(header, row, separator=",", rows=range(SAMPLES), end="\n"):
    """A text of header lines and the cells of row(k) for each sample."""
    lines = [header] if isinstance(header, str) else list(header)
    lines += [separator.join(row(k)) for k in rows]
    return end.join(lines) + end


def wide(time, number=point, order="uys"):
    def row(k):
        u, y, sp = ROWS[k]
        values = {"u": number(u), "y": number(y), "s": number(sp)}
        return [time(at(k))] + [values[c] for c in order]
    return row


def gaps(time, words, number=point):
    def row(k):
        u, y, _ = ROWS[k]
        return [time(at(k)), number(u), words[k % len(words)] if k in HELD else number(y)]
    return row


def long_rows(line, tags=("FIC101.OP", "FIC101.PV"), shift=0.0):
    lines = []
    for k in range(SAMPLES):
        for i, tag in enumerate(tags):
            lines.append(line(tag, at(k + i * shift), ROWS[k][i], k, i))
    return lines


def quoted(cells, separator=","):
    return separator.join(f'"{c}"' for c in cells)


FILES = {}


def export(name, text, encoding="utf-8", mark=b""):
    FILES[name] = mark + (text if isinstance(text, bytes) else text.encode(encoding))


def pi():
    export("pi-datalink.csv", table(",FIC101.OP,FIC101.PV,FIC101.SP", wide(english_month)))
    export("pi-datalink-german.csv",
           table(";FIC101.OP;FIC101.PV;FIC101.SP", wide(german_month, comma), ";", end="\r\n"))
    export("pi-bad-values.csv",
           table("Timestamp,FIC101.OP,FIC101.PV",
                 gaps(english_month, ["Bad Input", "I/O Timeout", "No Data"])))
    lines = long_rows(lambda tag, t, v, k, i: f"{tag},{english_month(t)},{v:.2f}")
    lines.insert(0, f"FIC101.OP,{english_month(at(-3600))},Pt Created")
    export("pi-archive-long.csv", "Tag,Timestamp,Value\n" + "\n".join(reversed(lines)) + "\n")
    export("pi-web-api-long.csv",
           "Name,Timestamp,Value,UnitsAbbreviation,Good,Questionable\n" + "\n".join(
               long_rows(lambda tag, t, v, k, i:
                         f"{tag},{t:%Y-%m-%dT%H:%M:%S}.0000000Z,{v:.2f},%,True,False")) + "\n")
    export("pi-compressed-pairs.csv", table(
        ["FIC101.OP,,FIC101.PV,", "Time,Value,Time,Value"],
        lambda k: [english_month(at(k)), point(ROWS[k][0]), english_month(at(k)),
                   point(ROWS[k][1])]))


def wonderware():
    export("wonderware-wide.csv",
           table("DateTime,FIC101.OP,FIC101.PV",
                 gaps(lambda t: f"{iso(t)}.0000000", ["NULL"])))
    body = long_rows(lambda tag, t, v, k, i:
                     f"{iso(t)}.000,{tag},{v:.2f},{0 if i == 1 and k in HELD else 192}")
    export("wonderware-history-long.csv", "DateTime,TagName,Value,OPCQuality\n" +
           "\n".join(body) + "\n\n(80 rows affected)\n")
    export("wonderware-intouch.csv", table(
        ["HistData export", "Node,HMI01", "", "$Date,$Time,FIC101_OUT,FIC101_PV"],
        lambda k: [f"{at(k):%m/%d/%Y}", f"{at(k):%H:%M:%S}", point(ROWS[k][0]),
                   point(ROWS[k][1])]))


def deltav():
    export("deltav-continuous.csv", table(
        '"Date/Time","FIC-101/PID1/OUT.CV","FIC-101/PID1/PV.CV","FIC-101/PID1/SP.CV"',
        lambda k: [f'"{c}"' for c in wide(us)(k)], end="\r\n"))
    export("deltav-units.csv", table(
        ",Timestamp,FIC-101/PID1/OUT.CV %,FIC-101/PID1/PV.CV m3/h,FIT-101/AI1/OUT.CV m3/h,"
        "TE-101/AI1/OUT.CV °C",
        lambda k: [str(k), f"{iso(at(k))}-04:00", point(ROWS[k][0]), point(ROWS[k][1]),
                   point(ROWS[k][1] + 0.3), point(20 + k / 50)]))
    export("deltav-utf16.txt", table(
        ["Process History View", "Area:\tAREA_A", "", "Time\tFIC-101/PID1/OUT\tFIC-101/PID1/PV"],
        wide(us, order="uy"), "\t", end="\r\n"), "utf-16-le", b"\xff\xfe")
    export("deltav-several-loops.csv", table(
        "Timestamp,FIC-101/PID1/OUT.CV,FIC-101/PID1/PV.CV,FIC-102/PID1/OUT.CV,FIC-102/PID1/PV.CV",
        lambda k: wide(iso, order="uy")(k) + ["50.00", "12.00"]))


def ignition():
    export("ignition-tag-history.csv", table(
        '"t_stamp","FIC101/OP","FIC101/PV","FIC101/SP"',
        lambda k: [f'"{c}"' for c in wide(lambda t: f"{iso(t)}.000")(k)]))
    export("ignition-epoch-ms.csv", table(
        "t_stamp,[default]FIC101/OP,[default]FIC101/PV",
        wide(lambda t: f"{epoch(t) * 1000:.0f}", order="uy")))
    export("ignition-java-dates.csv", table(
        "Timestamp,FIC101/OP,FIC101/PV",
        wide(lambda t: f"{t:%a} {ENGLISH[t.month - 1]} {t:%d %H:%M:%S} CEST {t.year}",
             order="uy")))
    export("ignition-dataset.csv", table(
        ['"#NAMES"', '"t_stamp","FIC101/OP","FIC101/PV"', '"#TYPES"', '"date","D","D"',
         f'"#ROWS","{SAMPLES}"'],
        lambda k: [f'"{c}"' for c in
                   wide(lambda t: f"{ENGLISH[t.month - 1]} {t.day}, {t.year} "
                        f"{(t.hour - 1) % 12 + 1}:{t:%M:%S} {t:%p}", order="uy")(k)]))


def siemens():
    body = []
    for k in range(SAMPLES):
        for i, tag in enumerate(("FIC101_OP", "FIC101_PV")):
            body.append(f'"{tag}";"{german(at(k))}";{comma(ROWS[k][i])};1;'
                        f"{comma(serial(at(k)) * 1e6, 3)}")
    export("siemens-wincc-archive.csv",
           '"VarName";"TimeString";"VarValue";"Validity";"Time_ms"\r\n' + "\r\n".join(body) +
           f'\r\n"$RT_OFF$";"{german(at(SAMPLES))}";0;2;{comma(serial(at(SAMPLES)) * 1e6, 3)}\r\n')
    export("siemens-wincc-trend.csv", table(
        "FIC101\\OP Time;FIC101\\OP ValueY;FIC101\\PV Time;FIC101\\PV ValueY",
        lambda k: [german(at(k)) + ",000", comma(ROWS[k][0]), german(at(k)) + ",000",
                   comma(ROWS[k][1])], ";"))
    export("siemens-pcs7.csv", table(
        "Date/Time;FIC101/PID.MV#Value;FIC101/PID.PV#Value;FIC101/PID.SP#Value",
        wide(lambda t: german(t) + ",250", comma), ";", end="\r\n"))
    export("siemens-step7.csv", table(
        ["Regler FIC101", "Datum;Uhrzeit;LMN [%];PV_IN [m³/h];SP_INT [m³/h]"],
        lambda k: [f"{at(k):%d.%m.%y}", f"{at(k):%H:%M:%S}", comma(ROWS[k][0]),
                   comma(ROWS[k][1]), comma(ROWS[k][2])], ";"), "latin-1")


def yokogawa():
    export("yokogawa-centum.csv", table(
        ["Trend data", "Project,MYPJT", "Sampling,1 sec", "",
         "Date,Time,FIC101.MV,FIC101.PV,FIC101.SV", ",,%,M3/H,M3/H"],
        lambda k: [f"{at(k):%Y/%m/%d}", f"{at(k):%H:%M:%S}", point(ROWS[k][0]),
                   point(ROWS[k][1]), point(ROWS[k][2])]))
    export("yokogawa-recorder.csv", table(
        ["Model,GX20", "Serial,0000000", "Date,Time,msec,FIC101.OUT,FIC101.PV"],
        lambda k: [f"{at(k):%Y/%m/%d}", f"{at(k):%H:%M:%S}", "500", point(ROWS[k][0]),
                   point(ROWS[k][1])]))


def honeywell():
    export("honeywell-experion.csv", table(
        "Timestamp,FIC101.PIDA.OP,FIC101.DACA.PV,FIC101.PIDA.SP", wide(us)))
    body = long_rows(lambda tag, t, v, k, i:
                     f"{tag},{german(t)},{v:.2f},{0 if i == 1 and k in HELD else 100}")
    export("honeywell-phd-long.csv", "TAGNAME,TIMESTAMP,VALUE,CONFIDENCE\n" +
           "\n".join(body) + "\n")


def abb():
    export("abb-800xa.txt", table(
        "Time\tFIC101:OUT\tFIC101:PV\tFIC101:SP",
        wide(lambda t: f"{t:%Y-%m-%dT%H:%M:%S}.000+02:00"), "\t"), "utf-16-be", b"\xfe\xff")
    export("abb-freelance.csv", table(
        ["Zeit;FIC101.OUT;FIC101.PV", "dd.mm.yyyy;%;m³/h"],
        gaps(german, ["---", "ungültig", "Fehler"], comma), ";"), "latin-1")


def aspen():
    export("aspen-ip21-wide.csv", table(
        "TS,FIC101.OP,FIC101.PV",
        wide(lambda t: f"{t.day:02d}-{ENGLISH[t.month - 1].upper()}-{t:%y %H:%M:%S}.0",
             order="uy")))
    lines = long_rows(lambda tag, t, v, k, i:
                      f"{tag}|{t.day:02d}-{ENGLISH[t.month - 1].upper()}-{t:%y %H:%M:%S}."
                      f"{t.microsecond // 100000}|{v:.2f}|{'Bad' if i == 1 and k in HELD else 'Good'}", shift=0.4)
    export("aspen-sqlplus-long.txt", "NAME|IP_TREND_TIME|IP_TREND_VALUE|IP_TREND_QSTATUS\n" +
           "\n".join(lines) + "\n")
    export("aspen-process-explorer.csv", table(
        ["Time,FIC101.OP,FIC101.PV", "Description,Feed valve,Feed flow", "Units,%,m3/h"],
        wide(iso, order="uy"), rows=reversed(range(SAMPLES))))


def excel():
    export("excel-german.csv", table(
        "Zeit;Stellgröße [%];Istwert [m³/h];Sollwert [m³/h]", wide(german, comma), ";",
        end="\r\n"), "latin-1")
    export("excel-us.csv", table("Time,OP,PV,SP", wide(us), end="\r\n"), mark=b"\xef\xbb\xbf")
    export("excel-serial.csv", table(
        "Date,Controller output (%),Process value (m3/h)",
        wide(lambda t: f"{serial(t):.9f}", order="uy")))
    export("excel-unicode-text.txt", table(
        "Datum/Zeit\tAusgang [%]\tIstwert [°C]", wide(german, comma, "uy"), "\t",
        end="\r\n"), "utf-16-le", b"\xff\xfe")
    export("excel-thousands.csv", table(
        "Zeit;FIC101 Stellwert;FIC101 Istwert",
        lambda k: [german(at(k)), comma(ROWS[k][0]),
                   f"{ROWS[k][1] * 100:,.2f}".translate(str.maketrans(",.", ".,"))], ";"))
    export("excel-sep-line.csv", "sep=;\n" + table("t;OP;PV", lambda k: [
        str(k), comma(ROWS[k][0]), comma(ROWS[k][1])], ";"))
    ambiguous = dt.datetime(2026, 4, 3, 14, 30, 0)
    export("excel-ambiguous-date.csv", table("Time,OP,PV", lambda k: [
        f"{at(k, ambiguous):%d/%m/%Y %H:%M:%S}", point(ROWS[k][0]), point(ROWS[k][1])]))
    midnight = dt.datetime(2026, 4, 3, 23, 59, 50)
    export("excel-british-midnight.csv", table("Time,OP,PV", lambda k: [
        f"{at(k, midnight):%d/%m/%Y %H:%M:%S}", point(ROWS[k][0]), point(ROWS[k][1])]))
    export("excel-two-digit-year.csv", table("Time,OP,PV", wide(
        lambda t: f"{t:%d/%m/%y %H:%M:%S}", order="uy")))
    export("excel-merged-heads.csv", table(
        ["Trend FIC101", ",FIC101.OP,,FIC101.PV,", "Time,Value,Status,Value,Status"],
        lambda k: [us(at(k)), point(ROWS[k][0]), "Good", point(ROWS[k][1]),
                   "Bad" if k in HELD else "Good"]))


def other():
    export("minutes.csv", table("t [min];u [%];y [bar]", lambda k: [
        comma(k / 60, 6), comma(ROWS[k][0]), comma(ROWS[k][1])], ";"))
    export("seconds-with-units.csv", table(["t,u,y,sp", "s,%,m3/h,m3/h"], lambda k: [
        str(k), *map(point, ROWS[k])]))
    export("epoch-seconds.csv", table("timestamp,op,pv", wide(
        lambda t: f"{epoch(t):.0f}", order="uy")))
    export("epoch-microseconds.csv", table("time,FIC101.CO,FIC101.PV", wide(
        lambda t: f"{epoch(t) * 1e6:.0f}", order="uy")))
    export("iso-basic.csv", table("Timestamp|FIC101.OUT|FIC101.MEAS", wide(
        lambda t: f"{t:%Y%m%dT%H%M%S}Z", order="uy"), "|"))
    export("bare-cr.csv", table("Time,OP,PV", wide(iso, order="uy"), end="\r"))
    autumn = dt.datetime(2026, 10, 25, 2, 59, 50)
    export("daylight-saving-end.csv", table("Time,OP,PV", lambda k: [
        iso(at(k, autumn) - dt.timedelta(hours=1 if k >= 10 else 0)), point(ROWS[k][0]),
        point(ROWS[k][1])]))
    spring = dt.datetime(2026, 3, 29, 1, 59, 50)
    export("daylight-saving-start.csv", table("Time,OP,PV", lambda k: [
        iso(at(k, spring) + dt.timedelta(hours=1 if k >= 10 else 0)), point(ROWS[k][0]),
        point(ROWS[k][1])], rows=reversed(range(SAMPLES))))
    midnight = dt.datetime(2026, 5, 13, 23, 59, 50)
    export("time-of-day.csv", table("Time,OP,PV", lambda k: [
        f"{at(k, midnight):%H:%M:%S}", point(ROWS[k][0]), point(ROWS[k][1])]))
    export("repeated-stamp.csv", table("Time,OP,PV", wide(iso, order="uy"),
                                       rows=sorted([*range(SAMPLES), 20])))
    export("excel-cut-seconds.csv", table("Time;OP;PV", lambda k: [
        f"{at(k, step=15):%d.%m.%Y %H:%M}", comma(ROWS[k][0]), comma(ROWS[k][1])], ";"))
    export("minutes-of-day.csv", table("Time;OP;PV", lambda k: [
        f"{at(k, midnight, step=15):%H:%M}", comma(ROWS[k][0]), comma(ROWS[k][1])], ";"))
    late = dt.datetime(2026, 5, 13, 23, 59, 30)
    export("minutes-seconds.csv", table("Time;OP;PV", lambda k: [
        f"{at(k, late):%M:%S},0", comma(ROWS[k][0]), comma(ROWS[k][1])], ";"))
    export("elapsed-hours.csv", table("Time,OP,PV", lambda k: [
        f"{23 + (3580 + k) // 3600}:{(3580 + k) // 60 % 60:02d}:{(3580 + k) % 60:02d}",
        point(ROWS[k][0]), point(ROWS[k][1])]))
    export("pandas-timedelta.csv", table(",OP,PV", lambda k: [
        f"{(86380 + k) // 86400} days {at(k, late + dt.timedelta(seconds=10)):%H:%M:%S}",
        point(ROWS[k][0]), point(ROWS[k][1])]))
    export("opc-quality.csv", table("Time,FIC101.OP,FIC101.PV,FIC101.PV.Quality", lambda k: [
        iso(at(k)), point(ROWS[k][0]), "0.00" if k in HELD else point(ROWS[k][1]),
        "0" if k in HELD else "192"]))
    export("own-names.csv", table("id,date,time,FT_115,LV_106", lambda k: [
        str(1000 - k), f"{at(k):%Y-%m-%d}", f"{at(k):%H:%M:%S}", point(ROWS[k][1]),
        point(ROWS[k][0])], rows=reversed(range(SAMPLES))))
    export("quoted-decimal-commas.csv", table("Zeit,OP,PV", lambda k: [
        f'"{c}"' for c in wide(german, comma, "uy")(k)]))
    export("code-for-no-value.csv", table("Time,OP,PV", gaps(iso, ["-9999", "32767"])))
    export("quality-french.csv", table("Horodatage;OP;PV;PV.Qualité", lambda k: [
        iso(at(k)), comma(ROWS[k][0]), "0,00" if k in HELD else comma(ROWS[k][1]),
        "Mauvaise" if k in HELD else "Bonne"], ";"))
    export("nan-cells.csv", table("Time,OP,PV", gaps(iso, ["NaN", "#N/A", ""])))


def trends():
    """What dashboards, laboratories and calculation programs write."""
    export("grafana.csv", table('"Time","FIC101.OP","FIC101.PV"', lambda k: [
        iso(at(k)), f"{point(ROWS[k][0])} %", f"{point(ROWS[k][1])} m³/h"]))
    head = ["#group,false,false,true,true,false,false,true,true",
            "#datatype,string,long,dateTime:RFC3339,dateTime:RFC3339,dateTime:RFC3339,double,"
            "string,string", "#default,_result,,,,,,,",
            ",result,table,_start,_stop,_time,_value,_field,_measurement"]
    hours = "2026-05-13T00:00:00Z,2026-05-14T00:00:00Z"
    export("influx-annotated.csv", "\n".join(head + [
        f",,{i},{hours},{at(k):%Y-%m-%dT%H:%M:%S}Z,{point(ROWS[k][i])},{name},FIC101"
        for i, name in enumerate(("OP", "PV")) for k in range(SAMPLES)]) + "\n")
    export("labview.lvm", table([
        "LabVIEW Measurement\t", "Separator\tTab", "Decimal_Separator\t.", "X_Columns\tOne",
        "Date\t2026/05/13", "Time\t14:30:00", "***End_of_Header***\t", "\t", "Channels\t2\t",
        "Samples\t40\t40\t", "Y_Unit_Label\t%\t%", "X_Dimension\tTime\tTime",
        "X0\t0.0\t0.0", "Delta_X\t1.0\t1.0", "***End_of_Header***\t",
        "X_Value\tOP\tPV\tComment"], lambda k: [
            f"{k}.000000", point(ROWS[k][0]), point(ROWS[k][1]), ""], "\t", end="\r\n"))
    export("labview-no-times.lvm", table([
        "LabVIEW Measurement\t", "Separator\tTab", "Decimal_Separator\t,", "X_Columns\tNo",
        "Date\t2026/05/13", "Time\t14:30:00,0", "***End_of_Header***\t", "\t", "Channels\t2\t",
        "Samples\t40\t40\t", "X_Dimension\tTime\tTime", "X0\t0,0000E+0\t0,0000E+0",
        "Delta_X\t1,000000\t1,000000", "***End_of_Header***\t", "X_Value\tOP\tPV\tComment"],
        lambda k: ["", comma(ROWS[k][0]), comma(ROWS[k][1])], "\t", end="\r\n"))
    both = lambda key, *values: ";".join(f"{key};{v}" for v in (values * 2)[:2])
    export("twincat-scope.csv", table([
        "Name;FIC101", "Starttime of export;132959733843760000;2026-05-13;14:30:00.000", "", "",
        both("Name", "MAIN.FIC101.OP", "MAIN.FIC101.PV"), both("SymbolComment", ""),
        both("Data-Type", "REAL64"), both("SampleTime[ms]", 1000),
        both("SymbolName", "MAIN.FIC101.OP", "MAIN.FIC101.PV"), both("Offset", 0),
        both("ScaleFactor", 1), both("Unit", "(None)"), both("Unit ScaleFactor", 1),
        both("Unit Offset", 0), ""], lambda k: [
            f"{1000 * k}", point(ROWS[k][0]), f"{1000 * k}", point(ROWS[k][1])], ";", end="\r\n"))
    export("matlab-durations.csv", table("Time,OP,PV", lambda k: [
        f"{k} sec", point(ROWS[k][0]), point(ROWS[k][1])]))
    export("blanks.dat", table("#   t       OP       PV", lambda k: [
        f"{k:8.2f}", f"{point(ROWS[k][0]):>8}", f"{point(ROWS[k][1]):>8}"], " "))
    export("french.csv", table("Horodatage;FIC101.Sortie;FIC101.Mesure;FIC101.Consigne", wide(
        lambda t: f"{t:%d/%m/%Y %H:%M:%S}", comma), ";"))
    export("ge-ifix.csv", "\n".join(["Tagname,TimeStamp,Value,DataQuality", *long_rows(
        lambda tag, t, v, k, i: f"PLANT.{tag}.F_CV,{t:%m/%d/%Y %H:%M:%S}.000,{point(v)},Good")])
        + "\n")


def workbooks():
    words = ["Time", "FIC101.OP", "FIC101.PV", "FIC101.SP"]
    head = cells(4, *(("s", i) for i in range(4)))
    sampled = [cells(5 + k, ("1", repr(serial(at(k)))), ("4", point(ROWS[k][0])),
                     ("4", point(ROWS[k][1])), ("0", point(ROWS[k][2])))
               for k in range(SAMPLES)]
    export("workbook.xlsx", workbook(
        [("Cover", [cells(1, ("i", "Trend of FIC101"))]),
         ("Data", [cells(1, ("i", "Trend of FIC101")), head, *sampled])], words))
    export("workbook-german.xlsx", workbook([("Tabelle1", [
        cells(1, ("i", "Datum"), ("i", "Uhrzeit"), ("i", "Stellwert [%]"), ("i", "Istwert [m³/h]")),
        *(cells(2 + k, ("2", int(serial(at(k)))), ("3", repr(serial(at(k)) % 1)),
                ("0", point(ROWS[k][0])),
                ("0", None if k in HELD else point(ROWS[k][1])))
          for k in range(SAMPLES))])]))
    export("workbook-two-sheets.xlsx", workbook(
        [("Monday", [head, *sampled]), ("Tuesday", [head, *sampled])], words))
    alarms = [cells(1 + k, ("i", "HI" if k else "Alarm"), ("i", f"TIC{k}")) for k in range(SAMPLES)]
    export("workbook-one-fits.xlsx", workbook(
        [("Alarms", alarms), ("Data", [head, *sampled])], words))
    export("workbook.ods", open_document([
        ("Cover", [["Trend of FIC101"]]),
        ("Data", [["Time", "FIC101.OP", "FIC101.PV"],
                  *([at(k), ROWS[k][0], None if k in HELD else ROWS[k][1]]
                    for k in range(SAMPLES))])]))


def three_decimals(value):
    return comma(value, 3)


def digits():
    """Commas with three decimals throughout; dates and times as bare numbers."""
    export("abb-three-decimals.csv", table(
        ["Log Name;FIC101,MAIN:FIC101.Out;FIC101,MAIN:FIC101.PV", "Time;Value;Value"],
        wide(german, three_decimals, "uy"), ";", end="\r\n"))
    def beside(date, clock, start=START):
        return lambda k: [date(at(k, start)), clock(at(k, start)), point(ROWS[k][0]),
                          point(ROWS[k][1])]
    export("date-and-clock-digits.csv", table("Date,Time,OP,PV", beside(
        lambda t: f"{t:%Y%m%d}", lambda t: f"{t.hour * 10000 + t.minute * 100 + t.second}",
        dt.datetime(2026, 5, 13, 23, 59, 50))))
    export("excel-day-and-fraction.csv", table("Date,Time,OP,PV", beside(
        lambda t: f"{int(serial(t))}", lambda t: f"{serial(t) % 1:.10f}")))
    export("rockwell-trend.csv", table(
        ['"Controller Name:","PLC1"', '"Trend Name:","FIC101"', '"Trend Tags:",2',
         '"Sample Period:","1000"," ms"', 'Header:,"Date","Time","FIC101.CV","FIC101.PV"'],
        lambda k: ["Data:", us(at(k)).split()[0], f'"{at(k):%H:%M:%S};250"',
                   point(ROWS[k][0]), point(ROWS[k][1])], end="\r\n"))


def spellings():
    """Dates of other habits, headings with the separator in them, points of InfluxDB."""
    def rows(time):
        return lambda k: [time(at(k)), point(ROWS[k][0]), point(ROWS[k][1])]
    export("ordinal-dates.csv", table("Time,OP,PV", rows(lambda t: f"{t:%Y-%jT%H:%M:%S}")))
    export("japanese-era.csv", table("日時,OP,PV", rows(
        lambda t: f"令和{t.year - 2018}年{t.month}月{t.day}日 {t:%H:%M:%S}")))
    export("japanese-era-letters.csv", table("日時,OP,PV", rows(
        lambda t: f"R{t.year - 2018}/{t.month}/{t.day} {t:%H:%M:%S}")))
    export("dotted-clock.csv", table("Date,Time,OP,PV", lambda k: [
        f"{at(k):%d.%m.%Y}", f"{at(k):%H.%M.%S}", point(ROWS[k][0]), point(ROWS[k][1])]))
    early = dt.timedelta(hours=6, minutes=25)  # 8.05: dates as well
    export("dotted-clock-alone.csv", table("Time,OP,PV", rows(lambda t: f"{t - early:%H.%M.%S}")))
    export("opc-ua-nodes.csv", table(
        "Time;ns=2;s=FIC101.OP;ns=2;s=FIC101.PV", rows(lambda t: f"{t:%Y-%m-%d %H:%M:%S}"), ";"))
    first = int(START.replace(tzinfo=dt.timezone.utc).timestamp())
    export("influx-line-protocol.txt", "# DML\n" + "".join(
        f'loop,area=North\\ 4,tag=FIC101 op={point(ROWS[k][0])},mode="AUTO, \\"x\\"" {first + k}000000000\n'
        f'loop,area=North\\ 4,tag=FIC101 pv={point(ROWS[k][1])},scan={k}i {first + k}000000000\n'
        for k in range(SAMPLES)))


def refused():
    export("yokogawa-min-max.csv", table(
        ['"Tag","","FIC101.PV","","FIC101.OP",""', '"Date","Time","Min","Max","Min","Max"'],
        lambda k: [f"{at(k):%Y/%m/%d}", f"{at(k):%H:%M:%S}", point(ROWS[k][1] - 0.1),
                   point(ROWS[k][1] + 0.1), point(ROWS[k][0] - 0.1), point(ROWS[k][0] + 0.1)]))
    export("controller-words.csv", table("Time,CV,PV,MV", lambda k: [
        iso(at(k)), point(ROWS[k][1]), point(ROWS[k][1]), point(ROWS[k][0])]))
    def typo(k):
        u, y, _ = ROWS[k]
        return [str(k), point(u), "12..3" if k == 7 else point(y)]
    export("typo.csv", table("t,u,y", typo))
    export("mostly-bad.csv", table("Time,OP,PV", lambda k: [
        iso(at(k)), point(ROWS[k][0]), "Bad" if k > 5 else point(ROWS[k][1])]))
    export("no-controller-output.csv", table("Time,FIC101.PV,FIC101.SP", wide(iso, order="ys")))
    export("two-days-in-one.csv", table("Time,OP,PV", lambda k: [
        iso(at(k % 20)), point(ROWS[k][0]), point(ROWS[k][1])]))
    export("damaged.xlsx", b"PK\x03\x04\x14\x00\x06\x00[Content_Types].xml")
    export("workbook.xls", b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1" + bytes(16))
    export("table.xls", "<html><body><table><tr><td>Time</td></tr></table></body></html>")
    export("frame.parquet", b"PAR1\x15\x00\x15\x00PAR1")


def main():
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent)
    for write in (pi, wonderware, deltav, ignition, siemens, yokogawa, honeywell, abb, aspen,
                  excel, other, trends, digits, workbooks, spellings, refused):
        write()
    FILES.update((n, t.encode()) for n, t in parted_exports.exports(ROWS, START, HELD))
    export("truth.csv", table("t,u,y,sp", lambda k: [str(k), *map(point, ROWS[k])]))
    for name, data in FILES.items():
        (folder / name).write_bytes(data)
    print(f"{len(FILES)} files in {folder}")


if __name__ == "__main__":
    main()
