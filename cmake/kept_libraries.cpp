// Part of the program in sanitized builds only: libraries that are closed stay loaded, so that LeakSanitizer
// can say whose a leak is. The Vulkan loader closes the driver's before the leaks are looked for, and
// nameless ones cannot be told from Plume's.
extern "C" int dlclose(void*) {
  return 0;
}
