// The reader of the gateway's configuration, compiled in: the wheel has to work where the
// library of it is not installed.
#define TOML_IMPLEMENTATION
#include <toml++/toml.h>
