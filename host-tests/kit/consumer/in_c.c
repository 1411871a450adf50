#include <stickband.h>

int main(void) {
  static stickband_storage_512 storage;
  stickband_settings settings;
  stickband_sample sample = {0, 50.0f, 50.0f, 0.0f, 0};
  stickband_report report;
  stickband *loop;
  stickband_default_settings(&settings);
  loop = stickband_init_512(&storage, &settings);
  for (; sample.t_us < 100000000; sample.t_us += 1000000) {
    if (!stickband_push(loop, &sample)) return 1;
    while (stickband_step(loop, 1)) {
    }
  }
  stickband_get_report(loop, &report);
  return report.samples_accepted == 100 && report.verdict == STICKBAND_NOT_EVALUATED ? 0
                                                                                     : 1;
}
