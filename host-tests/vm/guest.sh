# Runs inside the emulated machine: the daemon on a real kernel's CAN, GPIO and converters.
# /stickbandd, /hal_probe, /loop.log (50 Hz), /loop.dbc; /stickband and
# /count_allocations.so where the host has built them. Prints one line for each check.

failures=0
check() { # NAME COMMAND...
  name=$1
  shift
  if "$@" >/tmp/check 2>&1; then
    echo "ok      $name"
  else
    echo "FAILED  $name"
    sed 's/^/          /' /tmp/check
    failures=$((failures + 1))
  fi
}
# within SECONDS COMMAND...: true as soon as the command is.
within() {
  left=$(($1 * 5))
  shift
  while ! "$@"; do
    left=$((left - 1))
    [ $left -gt 0 ] || return 1
    sleep 0.2
  done
}
says() { grep -q "$1" /tmp/log; }
# ask HEX...: over the kernel's own ISO-TP, into /tmp/answer.
ask() {
  : >/tmp/answer
  isotprecv -s 7E0 -d 7E8 -p CC:CC vcan0 >/tmp/answer 2>/dev/null &
  receiver=$!
  usleep 100000
  echo "$*" | isotpsend -s 7E0 -d 7E8 -p CC:CC vcan0
  within 3 test -s /tmp/answer
  kill $receiver 2>/dev/null
  wait $receiver 2>/dev/null
}
answers() { # "REQUEST" "PATTERN OF THE ANSWER"
  # On a busy host the receiver may not be there yet when the answer comes.
  ask $1
  [ -s /tmp/answer ] || ask $1
  cat /tmp/answer
  grep -q "$2" /tmp/answer
}
metric() { sed -n "s/^stickband_loop_$1{loop=\"$2\"[^}]*} //p" /disk/a.prom; }
metric_is() { [ "$(metric "$1" "$2")" = "$3" ]; }
level() { cat $lines/sim_gpio$1/value; }
level_is() { [ "$(level "$1")" = "$2" ]; }
current() { # CHIP µA: through 100 ohm, 1 mV for each count
  counts=$(($2 / 10))
  i2cset -f -y 0 0x5$1 0 $((counts % 256 * 256 + counts / 256)) w
}

ip link add dev vcan0 type vcan
ip link set vcan0 mtu 72 up
gpio=/sys/kernel/config/gpio-sim/chip0
mkdir -p $gpio/bank0
echo 8 >$gpio/bank0/num_lines
echo sim >$gpio/bank0/label
echo 1 >$gpio/live
lines=/sys/devices/platform/$(cat $gpio/dev_name)/$(cat $gpio/bank0/chip_name)
mkdir /disk
mount -t tmpfs -o size=128k tmp /disk
stub=/sys/bus/i2c/devices/i2c-0
analog=yes
grep -q stub $stub/name 2>/dev/null || analog=

loop() { # ID TAG
  cat <<TOML
[[loop]]
id = $1
tag = "$2"
span = [0.0, 100.0]
TOML
}
{
  cat <<TOML
[bus.can0]
backend = "socketcan"
interface = "vcan0"
[uds]
[broadcast]
[metrics]
path = "/disk/a.prom"
period_s = 1.0
[state]
path = "/disk/state"
period_s = 1.0
TOML
  loop 1 FIC-211
  cat <<TOML
sample_period_s = 0.02
stale_after_s = 2.0
u = { source = "can", dbc = "loop.dbc", message = "LoopOP", signal = "OP" }
y = { source = "can", dbc = "loop.dbc", message = "LoopPV", signal = "PV" }
sp = { source = "can", dbc = "loop.dbc", message = "LoopSP", signal = "SP" }
flag = { chip = "sim", line = 3 }
[loop.alarm]
on_delay_windows = 1
TOML
  if [ $analog ]; then
    for chip in 0 1; do echo adc121c 0x5$chip >$stub/new_device; done
    current 0 12000
    current 1 12000
    loop 2 PIC-7
    cat <<TOML
sample_period_s = 0.2
stale_after_s = 2.0
u = { source = "iio", name = "0-0050", channel = "voltage", scale = 1.0, shunt_ohm = 100.0, ne43 = true, debounce_s = 1.0 }
y = { source = "iio", name = "0-0051", channel = "voltage", scale = 1.0, shunt_ohm = 100.0, ne43 = true, debounce_s = 1.0 }
flag = { chip = "sim", line = 4, active_low = true }
TOML
  fi
} >/gateway.toml

check "the configuration and its devices are valid" /stickbandd --config /gateway.toml --check
check "an interface that is absent is refused" sh -c \
  'sed s/vcan0/vcan9/ /gateway.toml >/bad.toml; /stickbandd --config /bad.toml --check 2>/tmp/e; [ $? = 3 ] && grep -q "bad.toml:1: bus.can0: .*vcan9" /tmp/e'

counter=
[ ! -e /count_allocations.so ] || counter=/tmp/allocations
LD_PRELOAD=${counter:+/count_allocations.so} STICKBAND_ALLOCATIONS=$counter \
  /stickbandd --config /gateway.toml 2>/tmp/log &
daemon=$!
check "it starts" within 10 says "<5>started"
[ ! $counter ] || cp $counter /tmp/allocations.started
check "a second one finds its state in use" sh -c \
  '/stickbandd --config /gateway.toml 2>/tmp/e; [ $? = 1 ] && grep -q "/disk/state" /tmp/e'
check "one with a state of its own finds the lines taken" sh -c \
  'sed s,/disk/state,/tmp/state, /gateway.toml >/own.toml; /stickbandd --config /own.toml 2>/tmp/e; [ $? = 1 ] && grep -q "sim line 3" /tmp/e'
check "the line belongs to it" sh -c 'gpioinfo | grep -q stickbandd'
check "the line is low at the start" level_is 3 0
[ ! $analog ] || check "an active-low line is high at the start" level_is 4 1

check "the kernel's ISO-TP gets its version" answers "22 F1 95" "^62 F1 95"
check "an unknown service is refused" answers "29 00" "^7F 29 11"
check "several objects at once" answers "22 F1 86 FD 11" "^62 F1 86 01 FD 11 46 49 43 2D 32 31 31"
check "the status frame is on the bus" sh -c 'candump -n 1 -T 3000 vcan0,191:7FF | grep -q 191'

# Several testers at once: one has sent the first frame of a long request and waits; one
# asks in a single frame; one begins a long request too.
candump -T 2500 vcan0,7E8:7FF >/tmp/both &
receiver=$!
cat >/tmp/both.log <<LOG
(1.000000) vcan0 7E0#100822F18622FD10
(1.010000) vcan0 7E0#023E00CCCCCCCCCC
(1.200000) vcan0 7E0#100822F18622FD10
LOG
usleep 300000
canplayer -I /tmp/both.log
wait $receiver
check "a single frame meanwhile is served" grep -q "02 7E 00" /tmp/both
check "a second long request is told to come again" grep -q "7F 22 21" /tmp/both
check "the server answers after it" answers "3E 00" "^7E 00"

echo "        (a loop of 2800 samples is played at 50 Hz)"
canplayer -l 3 -I /loop.log vcan0=can0 &
player=$!
check "its frames arrive" within 10 sh -c '[ "$(sed -n "s/^stickband_loop_frames{loop=\"1\"[^}]*} //p" /disk/a.prom)" -gt 100 ]'
if [ $analog ]; then
  sleep 2
  check "the currents are read: 12 mA is 50 %" metric_is u_pct 2 50
  current 0 2000
  check "2 mA: current low" within 5 metric_is input_status 2 2
  check "its DTC is confirmed" answers "19 02 08" "^59 02 7D.* 51 02 18 2D"
  current 0 22000
  check "22 mA: current high" within 5 metric_is input_status 2 3
  current 0 16000
  check "16 mA: good again" within 6 metric_is u_pct 2 75
  check "two faults were counted" metric_is ne43_faults 2 2
  [ ! $counter ] ||
    check "nothing was allocated since the start" cmp $counter /tmp/allocations.started
  echo 0x50 >$stub/delete_device
  check "the converter is gone: missing" within 8 metric_is input_status 2 1
  echo adc121c 0x50 >$stub/new_device
  current 0 16000
  check "the converter is back" within 12 metric_is input_status 2 0
fi

dd if=/dev/zero of=/disk/full bs=1k 2>/dev/null
check "a full disk is told" within 5 says "a.prom: cannot be written"
cp /disk/a.prom /tmp/before
sleep 2
check "the old textfile is whole" cmp /disk/a.prom /tmp/before
rm /disk/full
check "it is written again when there is room" within 5 sh -c '! cmp -s /disk/a.prom /tmp/before'

check "the flag is raised" within 90 says "FIC-211: FLAG RAISED"
check "the GPIO line is high" level_is 3 1
check "the verdict over ISO-TP is stiction" answers "22 FD 10" "^62 FD 10 04"
check "the verdict in the textfile is stiction" within 3 metric_is verdict 1 4
check "the DTC actuator stuck is confirmed" answers "19 02 08" "^59 02 7D.* 51 01 71 2D"
check "nothing was dropped" metric_is dropped 1 0
if [ -e /stickband ]; then
  check "the recording is pulled over the kernel's bus" \
    /stickband pull --can vcan0 --loop 1 -o /tmp/pulled.csv
  check "it holds samples" sh -c \
    'head -n 2 /tmp/pulled.csv; wc -l /tmp/pulled.csv; [ $(wc -l </tmp/pulled.csv) -gt 10 ]'
fi
kill $player 2>/dev/null
wait $player 2>/dev/null

ip link set vcan0 down
check "the interface down is told" within 5 says "bus can0 is down"
check "the input is missing" within 5 metric_is input_status 1 1
check "a verdict that is unknown lowers the flag" within 3 level_is 3 0
ip link set vcan0 up
check "the interface up is told" within 8 sh -c '[ "$(grep -c "bus can0 is up" /tmp/log)" = 2 ]'
check "it answers again" answers "3E 00" "^7E 00"
cansend vcan0 20000040#0000000000000000
check "bus-off is told" within 3 says "is off: too many errors"
check "it answers after bus-off" answers "3E 00" "^7E 00"

kill -HUP $daemon
check "SIGHUP loads the configuration anew" within 5 says "configuration loaded anew"
check "it answers afterwards" answers "3E 00" "^7E 00"
grep VmHWM /proc/$daemon/status | sed 's/^/        /'
kill -TERM $daemon
wait $daemon
check "SIGTERM ends it with 0" test $? = 0
check "the line is given back" sh -c '! gpioinfo | grep -q stickbandd'
check "its state is kept" sh -c '[ "$(head -c 4 /disk/state)" = SBST ]'

# 29-bit identifiers: every tester address is let through, other targets are not.
sed -e '/^flag/d' -e '/^\[uds\]/a extended_ids = true' /gateway.toml >/extended.toml
/stickbandd --config /extended.toml 2>/tmp/log &
daemon=$!
check "it starts with 29-bit identifiers" within 10 says "<5>started"
replies() { # REQUEST "FRAME THAT COMES BACK, OR NONE"
  # On a busy host the receiver may not be there yet when the answer comes.
  for pause in 300000 1000000 3000000; do
    candump -n 1 -T $((pause / 1000 + 1500)) vcan0,18DA0010:1FFF00FF >/tmp/frames &
    receiver=$!
    usleep $pause
    cansend vcan0 $1
    wait $receiver
    [ ! -s /tmp/frames ] || break
    [ "$2" ] || break
  done
  cat /tmp/frames
  [ "$(sed 's/.*vcan0 *//; s/ *\[8\] */ /' /tmp/frames)" = "$2" ]
}
check "F1 asks, F1 is answered" replies 18DA10F1#023E00CCCCCCCCCC \
  "18DAF110 02 7E 00 CC CC CC CC CC"
check "another tester is answered at its address" replies 18DA1022#023E00CCCCCCCCCC \
  "18DA2210 02 7E 00 CC CC CC CC CC"
check "a functional request is answered" replies 18DB3322#023E00CCCCCCCCCC \
  "18DA2210 02 7E 00 CC CC CC CC CC"
check "a request to another target is not ours" replies 18DA11F1#023E00CCCCCCCCCC ""
check "the same bits in 11 are not ours" replies 0F1#023E00CCCCCCCCCC ""
check "the kernel has the mask in its filters" \
  grep -qi "98DA1000 *DFFFFF00" /proc/net/can/rcvlist_fil
confirmed() {
  replies 18DA10F1#03190208CCCCCCCC any || grep -q "59 02 7D 51 01 71" /tmp/frames
}
check "its state came back" sh -c '! grep -q "no saved state" /tmp/log'
check "the DTC is still confirmed" confirmed
kill -TERM $daemon
wait $daemon

# CAN FD: signals in the last bytes of 64; beside it classic frames; a link without it.
{
  cat <<TOML
[bus.can0]
backend = "socketcan"
interface = "vcan0"
[metrics]
path = "/disk/a.prom"
period_s = 1.0
TOML
  loop 1 FD
  cat <<TOML
sample_period_s = 0.2
u = { source = "can", frame_id = 0x321, start = 488, length = 8 }
y = { source = "can", frame_id = 0x322, start = 504, length = 8 }
sp = { source = "can", frame_id = 0x323, start = 0, length = 8 }
TOML
} >/fd.toml
zeros=$(printf '%0122d' 0)
/stickbandd --config /fd.toml 2>/tmp/log &
daemon=$!
check "it starts with signals of CAN FD" within 10 says "<5>started"
(
  for k in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15; do
    cansend vcan0 "321##1${zeros}28EE01"
    cansend vcan0 "322##0${zeros}EEEE3C"
    cansend vcan0 "323#0A"
    usleep 200000
  done
) &
player=$!
/stickbandd --learn --can vcan0 --seconds 2 >/tmp/learned 2>&1
check "u comes from byte 61" within 5 metric_is u_pct 1 40
check "y comes from byte 63" within 5 metric_is y_pct 1 60
check "sp comes in classic frames" within 5 metric_is sp_pct 1 10
check "learning lists them" grep -q " 321 .* 64 .*FD" /tmp/learned
wait $player
kill -TERM $daemon
wait $daemon
ip link set vcan0 down
ip link set vcan0 mtu 16 up
check "a link without CAN FD is refused for them" sh -c \
  '/stickbandd --config /fd.toml --check 2>/tmp/e; [ $? = 3 ] && grep -q "no CAN FD" /tmp/e'
sed 's/488/8/; s/504/8/' /fd.toml >/classic.toml
check "and serves for classic ones" /stickbandd --config /classic.toml --check
[ $failures = 0 ] || { echo "--- log"; cat /tmp/log; }
exit $failures
