/* interrupted: pushes samples from a timer interrupt that comes at ever other moments of
 * the main loop, which steps. Prints what came of it, and what the dearest push took. */
#include <stickband.h>

#include "board.h"

#define PUSHES 300000
#define SYSTICK ((volatile uint32_t *)0xE000E010) /* control, reload, value */
#define FIRST_US ((int64_t)1 << 40)               /* both words of a time are in use */

static stickband_storage_512 storage;
static stickband *loop;
static volatile int32_t pushes, taken;
static uint32_t dearest_ticks;

void board_timer(void) {
  static uint32_t random = 1;
  random = random * 1664525u + 1013904223u;
  SYSTICK[1] = 200 + (random >> 20); /* 125 to 2,700 instructions */
  if (pushes == PUSHES) return;
  const stickband_sample sample = {FIRST_US + pushes * (int64_t)1000000, 50.0f, 50.0f,
                                   50.0f, 1};
  const uint32_t before = SYSTICK[2];
  taken += stickband_push(loop, &sample);
  const uint32_t ticks = before - SYSTICK[2];
  if (ticks < SYSTICK[1] && ticks > dearest_ticks) dearest_ticks = ticks;
  ++pushes;
}

static void figure(const char *name, uint32_t value) {
  board_text(name);
  board_number((float)value);
  board_text("\n");
}

int main(void) {
  stickband_settings settings;
  stickband_default_settings(&settings);
  loop = stickband_init_512(&storage, &settings);
  SYSTICK[1] = 1000;
  SYSTICK[2] = 0;
  SYSTICK[0] = 7; /* processor clock, interrupt, on */
  while (pushes < PUSHES) stickband_step(loop, 1);
  SYSTICK[0] = 0;
  while (stickband_pending(loop) > 0) stickband_step(loop, 1);
  stickband_report report;
  stickband_get_report(loop, &report);
  figure("pushes ", (uint32_t)pushes);
  figure("taken ", (uint32_t)taken);
  figure("queue_refused ", report.queue_refused);
  figure("samples_accepted ", report.samples_accepted);
  figure("samples_refused ", report.samples_refused);
  /* 25 MHz against 64 ns an instruction: 0.625 instructions a tick. */
  figure("dearest_push_instructions ", dearest_ticks * 5 / 8);
  board_leave(0);
}
