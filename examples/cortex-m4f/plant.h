/* Stands for the converters of a board: a simulated loop whose valve sticks. On hardware
 * `plant_sample` reads two analog inputs instead. */
#ifndef PLANT_H
#define PLANT_H

/* Controller output and process output now, %. Called once a sample. */
void plant_sample(float *u, float *y);

/* What the valve really does, % of u (He's model: it moves when u is further from the
 * stem than the static friction, and then up to the kinetic one). */
#define PLANT_STATIC_FRICTION 3.0f
#define PLANT_KINETIC_FRICTION 1.0f
#define PLANT_STICK_BAND (PLANT_STATIC_FRICTION + PLANT_KINETIC_FRICTION)

#endif
