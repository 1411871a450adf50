/* Holds every function of stickband.h, to be looked at by abidiff; it is not run. */
int main(void) {
  return 0;
}
