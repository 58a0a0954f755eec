/* An OSMesa that fails: NPSEE_OSMESA names this library, FAULTY_GL says how, FAULTY_GL_AFTER after how many calls of that kind that went well,
 * FAULTY_GL_CALLS how many then fail (else all).
 *
 *   context       no context is made
 *   current       it cannot be made current
 *   version       it is of OpenGL 3.2
 *   compile       shaders do not compile
 *   link          programs do not link
 *   framebuffer   framebuffer objects are not supported
 *   memory        a draw runs out of the driver's memory
 *   lost          the context is lost while drawing: from then on nothing is drawn and every question is answered by an error
 *   uploads       buffers cannot be filled for want of memory
 *   textures      textures cannot be made for want of memory
 *
 * All else is the real library's. Preloaded (LD_PRELOAD) it does the same to the window of GLFW. */

#define _GNU_SOURCE

#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>

typedef void (*function)(void);
typedef struct context* handle;

enum { kOutOfMemory = 0x0505, kContextLost = 0x0507, kCompileStatus = 0x8B81, kLinkStatus = 0x8B82, kUnsupported = 0x8CDD, kVersion = 0x1F02, kMajor = 0x821B, kMinor = 0x821C };

static void* real_library(void) {
  static void* library = NULL;
  if (library == NULL) library = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
  if (library == NULL) exit(99);
  return library;
}

static function real_symbol(const char* name) {
  function out = NULL;
  void* found = dlsym(real_library(), name);
  memcpy(&out, &found, sizeof out);
  return out;
}

/* Set where it is GLFW that looks functions up. */
static function (*window_functions)(const char*) = NULL;

static function real_gl(const char* name) {
  if (window_functions != NULL) return window_functions(name);
  return ((function(*)(const char*))real_symbol("OSMesaGetProcAddress"))(name);
}

static int fault(const char* kind) {
  const char* chosen = getenv("FAULTY_GL");
  return chosen != NULL && strcmp(chosen, kind) == 0;
}

/* One more call of the chosen kind: whether its time has come. */
static int due(void) {
  static int calls = 0;
  const char *after = getenv("FAULTY_GL_AFTER"), *count = getenv("FAULTY_GL_CALLS");
  const int past = calls++ - (after != NULL ? atoi(after) : 0);
  return past >= 0 && (count == NULL || past < atoi(count));
}

static unsigned pending = 0;
static int lost = 0;

static unsigned get_error(void) {
  const unsigned out = pending;
  if (lost) return kContextLost;
  pending = 0;
  return out != 0 ? out : ((unsigned (*)(void))real_gl("glGetError"))();
}

static void get_shader(unsigned shader, unsigned what, int* value) {
  ((void (*)(unsigned, unsigned, int*))real_gl("glGetShaderiv"))(shader, what, value);
  if (what == kCompileStatus && fault("compile") && due()) *value = 0;
}

static void get_program(unsigned program, unsigned what, int* value) {
  ((void (*)(unsigned, unsigned, int*))real_gl("glGetProgramiv"))(program, what, value);
  if (what == kLinkStatus && fault("link") && due()) *value = 0;
}

static unsigned check_framebuffer(unsigned target) {
  if (fault("framebuffer") && due()) return kUnsupported;
  return ((unsigned (*)(unsigned))real_gl("glCheckFramebufferStatus"))(target);
}

static const unsigned char* get_string(unsigned name) {
  if (name == kVersion) return (const unsigned char*)"3.2 (Core Profile) faulty";
  return ((const unsigned char* (*)(unsigned))real_gl("glGetString"))(name);
}

static void get_integer(unsigned name, int* value) {
  ((void (*)(unsigned, int*))real_gl("glGetIntegerv"))(name, value);
  if (name == kMajor) *value = 3;
  if (name == kMinor) *value = 2;
}

/* Whether this call does its work. */
static int goes_well(void) {
  if (lost) return 0;
  if (!due()) return 1;
  if (fault("lost")) lost = 1;
  else pending = kOutOfMemory;
  return 0;
}

static void draw_arrays(unsigned mode, int first, int count) {
  if (goes_well()) ((void (*)(unsigned, int, int))real_gl("glDrawArrays"))(mode, first, count);
}
static void draw_elements(unsigned mode, int count, unsigned type, const void* indices) {
  if (goes_well()) ((void (*)(unsigned, int, unsigned, const void*))real_gl("glDrawElements"))(mode, count, type, indices);
}
static void draw_elements_base_vertex(unsigned mode, int count, unsigned type, const void* indices, int base) {
  if (goes_well()) ((void (*)(unsigned, int, unsigned, const void*, int))real_gl("glDrawElementsBaseVertex"))(mode, count, type, indices, base);
}
static void draw_arrays_instanced(unsigned mode, int first, int count, int instances) {
  if (goes_well()) ((void (*)(unsigned, int, int, int))real_gl("glDrawArraysInstanced"))(mode, first, count, instances);
}
static void draw_elements_instanced(unsigned mode, int count, unsigned type, const void* indices, int instances) {
  if (goes_well()) ((void (*)(unsigned, int, unsigned, const void*, int))real_gl("glDrawElementsInstanced"))(mode, count, type, indices, instances);
}
static void read_pixels(int x, int y, int width, int height, unsigned format, unsigned type, void* pixels) {
  if (goes_well()) ((void (*)(int, int, int, int, unsigned, unsigned, void*))real_gl("glReadPixels"))(x, y, width, height, format, type, pixels);
}
static void buffer_data(unsigned target, long size, const void* data, unsigned usage) {
  if (goes_well()) ((void (*)(unsigned, long, const void*, unsigned))real_gl("glBufferData"))(target, size, data, usage);
}
static void texture_image(unsigned target, int level, int internal, int width, int height, int border, unsigned format, unsigned type, const void* pixels) {
  if (goes_well()) ((void (*)(unsigned, int, int, int, int, int, unsigned, unsigned, const void*))real_gl("glTexImage2D"))(target, level, internal, width, height, border, format, type, pixels);
}

static function or_real(const char* name, int chosen, function ours) { return chosen ? ours : real_gl(name); }

__attribute__((visibility("default"))) function OSMesaGetProcAddress(const char* name) {
  const int draws = fault("lost") || fault("memory");
  if (strcmp(name, "glGetError") == 0) return (function)get_error;
  if (strcmp(name, "glGetShaderiv") == 0) return (function)get_shader;
  if (strcmp(name, "glGetProgramiv") == 0) return (function)get_program;
  if (strcmp(name, "glCheckFramebufferStatus") == 0) return (function)check_framebuffer;
  if (strcmp(name, "glGetString") == 0) return or_real(name, fault("version"), (function)get_string);
  if (strcmp(name, "glGetIntegerv") == 0) return or_real(name, fault("version"), (function)get_integer);
  if (strcmp(name, "glDrawArrays") == 0) return or_real(name, draws, (function)draw_arrays);
  if (strcmp(name, "glDrawElements") == 0) return or_real(name, draws, (function)draw_elements);
  if (strcmp(name, "glDrawElementsBaseVertex") == 0) return or_real(name, draws, (function)draw_elements_base_vertex);
  if (strcmp(name, "glDrawArraysInstanced") == 0) return or_real(name, draws, (function)draw_arrays_instanced);
  if (strcmp(name, "glDrawElementsInstanced") == 0) return or_real(name, draws, (function)draw_elements_instanced);
  if (strcmp(name, "glReadPixels") == 0) return or_real(name, draws, (function)read_pixels);
  if (strcmp(name, "glBufferData") == 0) return or_real(name, fault("uploads"), (function)buffer_data);
  if (strcmp(name, "glTexImage2D") == 0) return or_real(name, fault("textures"), (function)texture_image);
  return real_gl(name);
}

__attribute__((visibility("default"))) function glfwGetProcAddress(const char* name) {
  void* found = dlsym(RTLD_NEXT, "glfwGetProcAddress");
  memcpy(&window_functions, &found, sizeof found);
  return OSMesaGetProcAddress(name);
}

__attribute__((visibility("default"))) handle OSMesaCreateContextAttribs(const int* attributes, handle share) {
  return fault("context") ? NULL : ((handle(*)(const int*, handle))real_symbol("OSMesaCreateContextAttribs"))(attributes, share);
}

__attribute__((visibility("default"))) void OSMesaDestroyContext(handle context) { ((void (*)(handle))real_symbol("OSMesaDestroyContext"))(context); }

__attribute__((visibility("default"))) unsigned char OSMesaMakeCurrent(handle context, void* buffer, unsigned type, int width, int height) {
  if (fault("current")) return 0;
  return ((unsigned char (*)(handle, void*, unsigned, int, int))real_symbol("OSMesaMakeCurrent"))(context, buffer, type, width, height);
}
