/* The board mps2-an386 that QEMU emulates: Cortex-M4F at 25 MHz. */
#include "board.h"

#include <stdint.h>
#include <string.h>

#define CLOCK_HZ 25000000
#define SYSTICK_CONTROL (*(volatile uint32_t *)0xE000E010)
#define SYSTICK_RELOAD (*(volatile uint32_t *)0xE000E014)
#define SYSTICK_VALUE (*(volatile uint32_t *)0xE000E018)
#define COPROCESSORS (*(volatile uint32_t *)0xE000ED88)

extern uint32_t data_begin[], data_end[], bss_begin[], bss_end[], stack_high[];
extern const uint32_t data_load[];
int main(void);

static int32_t debugger(int32_t operation, const void *argument) {
  register int32_t r0 __asm__("r0") = operation;
  register const void *r1 __asm__("r1") = argument;
  __asm__ volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
  return r0;
}

void board_text(const char *text) {
  debugger(0x04, text);
}

void board_number(float value) {
  char text[16];
  char *at = text + sizeof text;
  const int32_t hundredths = (int32_t)(value * 100.0f + (value < 0.0f ? -0.5f : 0.5f));
  uint32_t left = (uint32_t)(hundredths < 0 ? -hundredths : hundredths);
  *--at = '\0';
  for (int digits = 0; digits < 3 || left > 0; left /= 10) {
    *--at = (char)('0' + left % 10);
    if (++digits == 2) *--at = '.';
  }
  if (hundredths < 0) *--at = '-';
  board_text(at);
}

void board_start_timer(void) {
  SYSTICK_RELOAD = CLOCK_HZ / 1000000 * BOARD_TIMER_PERIOD_US - 1;
  SYSTICK_VALUE = 0;
  SYSTICK_CONTROL = 7; /* processor clock, interrupt, on */
}

void board_wait_for_interrupt(void) {
  __asm__ volatile("wfi");
}

void board_leave(int status) {
  const uint32_t block[] = {0x20026, (uint32_t)status};
  debugger(0x20, block);
  for (;;) {
  }
}

static void fault(void) {
  board_text("fault\n");
  board_leave(99);
}

void reset(void) {
  COPROCESSORS |= 0xFu << 20; /* floating point */
  __asm__ volatile("dsb\n isb" ::: "memory");
  memcpy(data_begin, data_load, (size_t)((char *)data_end - (char *)data_begin));
  memset(bss_begin, 0, (size_t)((char *)bss_end - (char *)bss_begin));
  main();
  fault();
}

typedef void (*handler)(void);
__attribute__((section(".vectors"), used)) static const struct {
  uint32_t *stack;
  handler handlers[15];
} vectors = {stack_high,
             {reset, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault,
              fault, fault, fault, board_timer}};
