/* Stickband for C: samples of one control loop in, a verdict on its valve out.
 *
 * Does the valve stick, on which stroke, and by how much? The answer rests on what every
 * controller has: its output u and the process output y. C99 or later; no heap, no
 * operating system, no clock, no global state. One object for each loop, in storage that
 * the caller owns.
 *
 *   static stickband_storage_512 storage;
 *   static stickband *loop;
 *
 *   int main(void) {
 *     stickband_settings settings;
 *     stickband_default_settings(&settings);
 *     settings.sample_period_us = 1000000;
 *     loop = stickband_init_512(&storage, &settings);
 *     start_timer();
 *     for (;;) {
 *       while (stickband_step(loop, 1)) {}          // idle time
 *       stickband_event event;
 *       while (stickband_poll(loop, &event)) tell(&event);
 *       wait_for_interrupt();
 *     }
 *   }
 *   void timer_interrupt(void) {
 *     stickband_sample sample = {now_us(), read_u(), read_y(), 0.0f, 0};
 *     stickband_push(loop, &sample);
 *   }
 *
 * Who may call what. `stickband_push` may interrupt any other call, and runs beside it on
 * another core: it puts the sample into a queue of STICKBAND_QUEUE, which the next
 * `stickband_step` empties. It neither waits nor turns interrupts off. There is one
 * pusher (interrupts of one priority, or one thread) and one of everything else (`step`,
 * `advance`, `poll`, `get_report`, `save`: one thread). `init` and `restore` come before both.
 *
 * How often `step`. No more than STICKBAND_QUEUE samples may come between two calls;
 * what finds the queue full is lost (`queue_refused`). And an evaluation has to be
 * through before a sixteenth of the window has come in new samples; else the window is
 * given up and begins anew (`overruns`): a loop that is always too slow never has a
 * verdict. So the budgets of the calls from one sample to the next have to add up to
 *
 *   window, samples              384   512   2048   4096
 *   units for each new sample    370   470    270    170
 *
 * of 100,000 instructions each: as counted, dearest of some recordings (docs/memory.md),
 * and a tenth. With twice that to spare at 100 million instructions a second a window of
 * 512 bears a sample a second.
 *
 * What is decided when, what a verdict rests on and what each call costs is in
 * ident/monitor.hpp; docs/firmware-kit.md has what it costs on a Cortex-M4F.
 *
 * Link with CMake: find_package(Stickband), target Stickband::c. On a bare board with 21 KiB
 * for a loop Stickband::c_small, which defines STICKBAND_SMALL and has the window of 512
 * alone; with 17 KiB Stickband::c_least, which defines STICKBAND_LEAST, too, and has the
 * window of 384 alone. Never mix two of them in one program.
 *
 * Versions are semantic: within one major version nothing here changes its meaning or
 * its layout, and storage does not grow. (Before 1.0.0: within one minor version.)
 */
#ifndef STICKBAND_H
#define STICKBAND_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* One loop. */
typedef struct stickband stickband;

/* Bytes of storage for a window of so many samples, by the size of a pointer. */
#if defined(STICKBAND_LEAST)
#define STICKBAND_BYTES_384 (sizeof(void *) == 4 ? 17024u : 17536u)
#elif defined(STICKBAND_SMALL)
#define STICKBAND_BYTES_512 (sizeof(void *) == 4 ? 21248u : 21760u)
#else
#define STICKBAND_BYTES_512 (sizeof(void *) == 4 ? 37888u : 38144u)
#define STICKBAND_BYTES_2048 (sizeof(void *) == 4 ? 65280u : 65536u)
#define STICKBAND_BYTES_4096 (sizeof(void *) == 4 ? 101632u : 101888u)
#endif

/* Samples that may wait for `stickband_step`. */
#define STICKBAND_QUEUE 16u

/* Enough for `stickband_save`. */
#define STICKBAND_MEMORY_BYTES 320u

/* Declare one, preferably static; do not touch its bytes, do not move it. */
#ifdef STICKBAND_LEAST
typedef union stickband_storage_384 {
  uint64_t alignment;
  unsigned char bytes[STICKBAND_BYTES_384];
} stickband_storage_384;
#else
typedef union stickband_storage_512 {
  uint64_t alignment;
  unsigned char bytes[STICKBAND_BYTES_512];
} stickband_storage_512;
#endif
#ifndef STICKBAND_SMALL
typedef union stickband_storage_2048 {
  uint64_t alignment;
  unsigned char bytes[STICKBAND_BYTES_2048];
} stickband_storage_2048;
typedef union stickband_storage_4096 {
  uint64_t alignment;
  unsigned char bytes[STICKBAND_BYTES_4096];
} stickband_storage_4096;
#endif

/* Start from `stickband_default_settings`. Nothing is refused: values outside the ranges
 * are moved to the nearest bound; a span that is empty or not finite is 0 ... 100. */
typedef struct stickband_settings {
  int64_t sample_period_us;   /* nominal, us, 1 ... 2^40; default 1 s. The senders' may be
                                 5 % off, and jitter by a quarter of it */
  int64_t stale_after_us;     /* without a sample: a fault; us, 2 periods ... 2^61;
                                 0, default: 5 periods */
  float span_low;             /* lower end of the span of u, units of u; default 0 */
  float span_high;            /* upper end, units of u, above span_low; default 100 */
  int32_t gain_sign;          /* of the process, +1 or -1 where known; 0, default: not */
  int32_t longest_hold;       /* missing samples in a row filled with the last one,
                                 0 ... 16; default 3; after more a window begins anew */
  int32_t evaluate_every_pct; /* new samples, % of the window, 1 ... 100; default 25 */
  int32_t memory_pct;         /* of what earlier windows said that counts a window of
                                 new samples later, %, 0 ... 100; default 90 */
  int32_t first_cycles;       /* of u, before the first evaluation of a window that is not
                                 full, 2 ... 100; default 5 */
  int32_t on_delay_windows;   /* in a row for the alarm until it is up, 1 ... 1000;
                                 default 2 */
  int32_t off_delay_windows;  /* against it, none for it in between, until it is down,
                                 1 ... 1000; default 6 */
  float band_min_pct;         /* smallest stick band that alarms, % of span, 0 ... 100;
                                 default 0.5; four fifths of it keep the alarm up */
} stickband_settings;

typedef struct stickband_sample {
  int64_t t_us;   /* monotonic time, us, from any origin */
  float u;        /* controller output, units of u */
  float y;        /* process output, units of y */
  float sp;       /* setpoint, units of y; read where has_sp */
  int32_t has_sp; /* 1: the setpoint is known; else 0 */
} stickband_sample;

/* The status of every number below. */
enum {
  STICKBAND_NOT_EVALUATED = 0, /* no window was complete yet */
  STICKBAND_STICTION = 1,      /* sticks, then slips */
  STICKBAND_BACKLASH = 2,      /* deadband without slip jump */
  STICKBAND_NO_STICTION = 3,   /* the valve follows its signal */
  STICKBAND_UNDECIDED = 4,     /* the data cannot tell; the reason says what would help */
  STICKBAND_BAD_DATA = 5       /* the samples cannot be used */
};

/* What is wrong with the samples. */
enum {
  STICKBAND_FAULT_NONE = 0,
  STICKBAND_FAULT_STALE = 1,      /* none has come for too long, or their clock stands */
  STICKBAND_FAULT_NON_FINITE = 2, /* infinite, or no number */
  STICKBAND_FAULT_FROZEN_U = 3,   /* u holds one value while y moves */
  STICKBAND_FAULT_FROZEN_Y = 4    /* y holds one value while u moves */
};

enum {
  STICKBAND_OSCILLATION_STARTED = 0,
  STICKBAND_OSCILLATION_ENDED = 1,
  STICKBAND_STICTION_RAISED = 2, /* the alarm */
  STICKBAND_STICTION_CLEARED = 3,
  STICKBAND_EVENT_UNDECIDED = 4,
  STICKBAND_INPUT_FAULT = 5,
  STICKBAND_INPUT_RESTORED = 6
};

/* A number with its 95 % interval. Nothing of it means anything unless known is 1. */
typedef struct stickband_estimate {
  int32_t known;
  float value;
  float low;
  float high;
} stickband_estimate;

/* Travel of u after a reversal until the valve moves (stick band), and how far it then
 * jumps (slip jump); ascending: about to move with rising u. Units of u. */
typedef struct stickband_valve {
  stickband_estimate band_ascending;
  stickband_estimate band_descending;
  stickband_estimate jump_ascending;
  stickband_estimate jump_descending;
} stickband_valve;

typedef struct stickband_report {
  int32_t verdict;           /* STICKBAND_NOT_EVALUATED ...: of the newest window */
  int32_t reason;            /* for stickband_reason_text */
  int32_t raised;            /* 1: the alarm is up */
  int32_t oscillating;       /* 1: u or y oscillates now */
  int32_t fault;             /* STICKBAND_FAULT_NONE ... */
  int32_t suspect;           /* effect that the model lacks; for stickband_effect_name */
  stickband_valve valve;
  int64_t window_end_us;     /* newest sample of that window */
  uint32_t window_samples;
  float cycles;              /* of u, in the window */
  float period_s;            /* of u's oscillation; 0: none */
  float detectable_band;     /* smallest that would have shown, units of u; 0: none */
  float evidence_nats;       /* closed-loop evidence for a sticking valve; 0 unknown */
  float fit_percent;         /* of the physical valve's model, free simulation */
  float suspect_share;       /* of the squared error that the suspect explains, 0 ... 1 */
  uint32_t evaluations;      /* since init, as all that follow */
  uint32_t skipped_windows;  /* due while the evaluation before was going on */
  uint32_t samples_accepted;
  uint32_t samples_refused;  /* repeats, not finite, time going back */
  uint32_t queue_refused;    /* pushes that found the queue full */
  uint32_t gaps;
  uint32_t overruns;         /* windows given up: `step` too slow for the samples */
  uint32_t restarts;         /* windows given up: long gap, clock set back */
  uint32_t samples_filled;   /* missing ones, made up */
  uint32_t events_lost;      /* pushed out by newer ones before they were read */
  uint32_t input_faults;     /* told by STICKBAND_INPUT_FAULT */
} stickband_report;

typedef struct stickband_event {
  int64_t t_us;          /* on the clock of the samples */
  int32_t kind;          /* STICKBAND_OSCILLATION_STARTED ... */
  int32_t verdict;       /* of the window, for stiction_* and undecided */
  int32_t reason;        /* the same */
  int32_t fault;         /* for input_* */
  stickband_valve valve; /* for stiction_* */
} stickband_event;

/* What `stickband_restore` found. */
enum {
  STICKBAND_RESTORED = 0,
  STICKBAND_NO_MEMORY = 1,      /* not such bytes, or of another version or size */
  STICKBAND_DAMAGED = 2,        /* the check sum is another, or a value out of range */
  STICKBAND_OTHER_SETTINGS = 3, /* made with another span or sample period */
  STICKBAND_TOO_LATE = 4        /* a sample has been pushed */
};

/* "0.1.0", of the library that is linked. */
const char *stickband_version(void);

/* Fills in every default. */
void stickband_default_settings(stickband_settings *settings);

/* Makes a loop in its storage. Never fails. Nothing has to be given back. */
#ifdef STICKBAND_LEAST
stickband *stickband_init_384(stickband_storage_384 *storage,
                              const stickband_settings *settings);
#else
stickband *stickband_init_512(stickband_storage_512 *storage,
                              const stickband_settings *settings);
#endif
#ifndef STICKBAND_SMALL
stickband *stickband_init_2048(stickband_storage_2048 *storage,
                               const stickband_settings *settings);
stickband *stickband_init_4096(stickband_storage_4096 *storage,
                               const stickband_settings *settings);
#endif

/* Takes a sample: 1 taken, 0 refused and counted because the queue is full. Constant
 * time, under 100 instructions; may be called from an interrupt. */
int stickband_push(stickband *loop, const stickband_sample *sample);

/* Samples that wait in the queue. */
uint32_t stickband_pending(const stickband *loop);

/* Takes what waits and goes on with the evaluation by about `budget` units of 100,000
 * instructions of a Cortex-M4F: with a budget of 1 by 2 units at most, by 3.1 with a window
 * of 4,096 samples. Returns 1 while there is work: call again, or when there is time. */
int stickband_step(stickband *loop, int32_t budget);

/* Where a clock is at hand, from the thread of `step`: takes what waits, and finds out
 * that samples have stopped coming. `now_us` is on the clock of the samples. */
void stickband_advance(stickband *loop, int64_t now_us);

/* The oldest event that has not been read: 1, or 0 where there is none. */
int stickband_poll(stickband *loop, stickband_event *event);

/* What is known now. */
void stickband_get_report(const stickband *loop, stickband_report *report);

/* What is worth keeping over a restart (alarm, evidence of earlier windows), the same
 * bytes on every target. Returns how many; 0 where `room` is too small. */
size_t stickband_save(const stickband *loop, unsigned char *out, size_t room);

/* Takes it back between init and the first push, not later: STICKBAND_RESTORED, or why
 * not; then nothing has changed. `count` may reach beyond the saved bytes. `missed_s`:
 * time that has passed since it was saved, s, at least 0; the evidence fades with it. */
int stickband_restore(stickband *loop, const unsigned char *bytes, size_t count,
                      float missed_s);

/* Names of the contract ("stiction", "stiction_raised", "frozen_u", "valve.stiction") and
 * a sentence that a technician understands; "" for a number that is none. */
const char *stickband_verdict_name(int32_t verdict);
const char *stickband_event_name(int32_t kind);
const char *stickband_fault_name(int32_t fault);
const char *stickband_effect_name(int32_t suspect);
const char *stickband_reason_text(int32_t reason);

#ifdef __cplusplus
}
#endif

#endif
