#include "plant.h"

#include <stdint.h>

#define SETPOINT 50.0f
#define GAIN 1.2f           /* of the controller */
#define RESET_SAMPLES 6.0f  /* its integral time */
#define LAG_SAMPLES 10.0f   /* of the process */
#define DEAD_SAMPLES 2
#define NOISE 0.1f /* of the converter, peak to peak, % */

static float noise(void) {
  static uint32_t state = 1;
  state = state * 1664525u + 1013904223u;
  return ((float)(state >> 8) / 16777216.0f - 0.5f) * NOISE;
}

void plant_sample(float *u, float *y) {
  static float stem = 45.0f, level = 45.0f, integral = 50.0f;
  static float delayed[DEAD_SAMPLES];
  static unsigned at;

  const float measured = level + noise();
  const float error = SETPOINT - measured;
  integral += GAIN * error / RESET_SAMPLES;
  const float output = integral + GAIN * error;

  const float ahead = output - stem;
  if (ahead > PLANT_STATIC_FRICTION) stem = output - PLANT_KINETIC_FRICTION;
  if (ahead < -PLANT_STATIC_FRICTION) stem = output + PLANT_KINETIC_FRICTION;

  const float flow = delayed[at];
  delayed[at] = stem;
  at = (at + 1) % DEAD_SAMPLES;
  level += (flow - level) / LAG_SAMPLES;
  *u = output;
  *y = measured;
}
