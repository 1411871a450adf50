# Facts, one a line, to Markdown tables of at most 80 columns:
#   time NAME MICROSECONDS | peer WAY COUNT SECONDS AIC FIT DISAGREEMENTS
#   instructions COUNT     | skipped PROGRAM     | build MACHINE COMPILER

$1 == "time" { time[$2] = $3; note_size($2) }
$1 == "peer" { peer_count = $3; peer_s[$2] = $4; aic[$2] = $5; fit[$2] = $6; wrong[$2] = $7 }
$1 == "instructions" { instructions = $2 }
$1 == "build" { build = $2 ", compiler " $3 }
$1 == "skipped" { skipped[$2] = 1 }

# AXIS/PART/SIZE, in the order of appearance.
function note_size(name,   piece) {
  if (split(name, piece, "/") != 3 || piece[3] !~ /^[0-9]+$/) return
  sizes[piece[1] "/" piece[2]] = sizes[piece[1] "/" piece[2]] " " piece[3]
}

function digits(value) {
  if (value >= 100) return sprintf("%.0f", value)
  if (value >= 10) return sprintf("%.1f", value)
  return sprintf("%.2f", value)
}

function duration(us) {
  if (us == "") return "-"
  if (us < 1) return digits(us * 1000) " ns"
  if (us < 1000) return digits(us) " us"
  if (us < 1000000) return digits(us / 1000) " ms"
  return digits(us / 1e6) " s"
}

function row(title, name, per,   a, b) {
  a = time[name "/f64"]; b = time[name "/f32"]
  printf "| %-44s | %9s | %9s | %5s |\n", title, duration(a == "" ? "" : a / per),
         duration(b == "" ? "" : b / per), a != "" && b != "" ? sprintf("%.2f", b / a) : "-"
}

# Least squares of log(time) over log(size).
function exponent(part,   piece, n, i, x, y, sx, sy, sxx, sxy) {
  n = split(sizes[part], piece, " ")
  for (i = 1; i <= n; i++) {
    x = log(piece[i]); y = log(time[part "/" piece[i]])
    sx += x; sy += y; sxx += x * x; sxy += x * y
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx)
}

function scaling(title, part,   piece, n) {
  n = split(sizes[part], piece, " ")
  if (n < 2) return
  printf "| %-32s | %4s - %-4s | %8s | %8s | %5.2f |\n", title, piece[1], piece[n],
         duration(time[part "/" piece[1]]), duration(time[part "/" piece[n]]), exponent(part)
}

function goal(text, met) { print "- " text ": " (met ? "met" : "NOT MET") "." }

END {
  if (build != "") print "Measured on one machine: " build ".\n"
  if (("push/detector/f64") in time) {
    print "| one core, 2,800 samples of Example 5.1       |   float64 |   float32 | ratio |"
    print "|:---------------------------------------------|----------:|----------:|------:|"
    row("oscillation detector, one push", "push/detector", 2800)
    row("sample window, one push", "push/window", 2800)
    row("Monitor::push", "push/monitor", 2800)
    row("all lagged sums, one pass", "part/sums", 1)
    row("one structure, Steps 1-2 and simulation", "part/structure", 1)
    row("one refinement step", "part/refinement", 1)
    row("two-path structure search, refined", "identify/two_path", 1)
    row("linear structure search, refined", "identify/linear", 1)
    row("physical valve search", "identify/valve", 1)
    row("whole Identifier::run", "identify/run", 1)
    print ""
  }
  if (("length/sums") in sizes) {
    print "| grows with                       | from - to   |    first |     last |   exp |"
    print "|:---------------------------------|:-----------:|---------:|---------:|------:|"
    scaling("samples: lagged sums", "length/sums")
    scaling("samples: Steps 1-2", "length/iteration")
    scaling("samples: one refinement step", "length/refinement")
    scaling("samples: two-path search", "length/search")
    scaling("samples: Identifier::run", "length/run")
    scaling("segments: Steps 1-2", "knots/iteration")
    scaling("segments: one refinement step", "knots/refinement")
    scaling("na = nb: Steps 1-2", "orders/iteration")
    scaling("na = nb: one refinement step", "orders/refinement")
    print ""
  }
  ours = time["peer/list/f64"]
  if ("plain" in peer_s) {
    printf "| %-35s | %10s | %5s | %7s | %7s |\n", "same " peer_count " structures, one thread",
           "time", "ratio", "AIC off", "fit off"
    print "|:------------------------------------|-----------:|------:|--------:|--------:|"
    printf "| %-35s | %10s | %5s | %7s | %7s |\n", "stickband, float64", duration(ours), 1, "-", "-"
    printf "| %-35s | %10s | %5.0f | %7s | %7s |\n", "Octave, lsqnonneg, plain",
           duration(peer_s["plain"] * 1e6), peer_s["plain"] * 1e6 / ours, aic["plain"], fit["plain"]
    printf "| %-35s | %10s | %5.0f | %7s | %7s |\n", "Octave, reduced by qr first",
           duration(peer_s["triangle"] * 1e6), peer_s["triangle"] * 1e6 / ours,
           aic["triangle"], fit["triangle"]
    print ""
    if (wrong["plain"] + wrong["triangle"] > 0)
      print "NOT THE SAME: " wrong["plain"] "/" wrong["triangle"] \
            " structures stable on one side only.\n"
  }
  if ("octave" in skipped) print "Octave peer: skipped, octave-cli is not installed.\n"
  if (instructions != "")
    printf "Instructions of one two-path search, float64: %.0f million.\n\n", instructions / 1e6
  if ("valgrind" in skipped) print "Instruction count: skipped, valgrind is not installed.\n"
  if (("identify/two_path/f64") in time)
    goal("two-path search of 2,800 samples in at most 0.5 s", time["identify/two_path/f64"] <= 5e5)
  if ("plain" in peer_s) {
    goal("at least 100 times as fast as the plain Octave peer", peer_s["plain"] * 1e6 >= 100 * ours)
    goal("the peer computes the same, to 1e-4 in AIC", aic["plain"] < 1e-4 && !wrong["plain"])
  }
}
