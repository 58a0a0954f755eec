// Compiled in builds with AddressSanitizer only. GLFW and Mesa unload libraries at the end, and what those never freed could then be
// put down to nobody: leaks are looked for after it, and a report's frames would be "<unknown module>". With the libraries kept, their
// leaks carry their names, and leak.supp can tell them from ours.
extern "C" int dlclose(void*) { return 0; }
