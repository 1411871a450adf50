/* What the example needs of its board: a timer, and a debugger that shows text. */
#ifndef BOARD_H
#define BOARD_H

#define BOARD_TIMER_PERIOD_US 500000

/* Calls board_timer in an interrupt, every BOARD_TIMER_PERIOD_US from now on. */
void board_start_timer(void);
void board_timer(void);
void board_wait_for_interrupt(void);
/* Semihosting; for a board without a debugger, write to its serial port here. */
void board_text(const char *text);
/* With two decimals, within +-10 million. */
void board_number(float value);
/* Ends the emulator with this status. */
void board_leave(int status);

#endif
