/* A bare Cortex-M4F: a timer interrupt takes the samples, idle time identifies the valve.
 * Nothing ever turns interrupts off; the longest that the interrupt waits is its own
 * sample before. */
#include <stickband.h>

#include "board.h"
#include "plant.h"

/* An evaluation takes some 1.4e9 instructions (docs/memory.md), which must be through
 * before a sixteenth of the window has come (stickband.h): 90 s here, 9 s at 168 MHz. */
#define SAMPLE_PERIOD_S 4

static stickband_storage_512 storage;
static stickband *loop;

void board_timer(void) {
  static unsigned half_seconds;
  static int64_t now_us;
  now_us += BOARD_TIMER_PERIOD_US;
  if (++half_seconds < SAMPLE_PERIOD_S * 1000000 / BOARD_TIMER_PERIOD_US) return;
  half_seconds = 0;
  stickband_sample sample = {.t_us = now_us};
  plant_sample(&sample.u, &sample.y);
  stickband_push(loop, &sample);
}

static void tell_estimate(const char *name, const stickband_estimate *estimate) {
  if (!estimate->known) return;
  board_text(name);
  board_number(estimate->value);
  board_text(" (");
  board_number(estimate->low);
  board_text(" to ");
  board_number(estimate->high);
  board_text(")");
}

static void tell(const stickband_event *event) {
  board_number((float)(event->t_us / 1000000));
  board_text(" s: ");
  board_text(stickband_event_name(event->kind));
  tell_estimate(", stick band ascending ", &event->valve.band_ascending);
  tell_estimate(", descending ", &event->valve.band_descending);
  board_text("\n");
}

int main(void) {
  stickband_settings settings;
  stickband_default_settings(&settings);
  settings.sample_period_us = SAMPLE_PERIOD_S * 1000000;
  loop = stickband_init_512(&storage, &settings);
  board_start_timer();
  for (;;) {
    while (stickband_step(loop, 1)) {
    }
    stickband_event event;
    while (stickband_poll(loop, &event)) tell(&event);
    board_wait_for_interrupt();
  }
}
