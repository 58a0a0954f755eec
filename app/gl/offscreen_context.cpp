#include "app/gl/context.h"
#include "app/gl/loader.h"

#include <array>
#include <cstdlib>

#include <dlfcn.h>

namespace npsee::gl {
namespace {

// Values from GL/osmesa.h and GL/glcorearb.h. The library is opened when it is needed and not linked: `npsee --help` need
// not load a compiler of 100 MB, and a missing library becomes a message.
constexpr int kFormat = 0x22, kProfile = 0x33, kCoreProfile = 0x34, kMajor = 0x36, kMinor = 0x37, kDepthBits = 0x30;
constexpr int kRgba = 0x1908;
constexpr unsigned kUnsignedByte = 0x1401;
constexpr const char* kLibrary = "libOSMesa.so.8";

using OSMesaHandle = struct OSMesaContextStruct*;

struct Library {
  OSMesaHandle (*create)(const int* attributes, OSMesaHandle share) = nullptr;
  void (*destroy)(OSMesaHandle) = nullptr;
  unsigned char (*makeCurrent)(OSMesaHandle, void* buffer, unsigned type, int width, int height) = nullptr;
  FindFunction find = nullptr;
};

template <class Function>
bool resolve(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(::dlsym(library, name));
  return function != nullptr;
}

Expected<Library> openLibrary() {
  // NPSEE_OSMESA names another library, for machines that keep it elsewhere.
  const char* named = std::getenv("NPSEE_OSMESA");
  const char* name = named != nullptr && *named != '\0' ? named : kLibrary;
  void* handle = ::dlopen(name, RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) {
    const char* why = ::dlerror();
    return fail(ErrorKind::graphics, std::string("cannot draw without a display: ") + (why != nullptr ? why : name) + ".",
                "Install Mesa's offscreen library (Debian package libosmesa6), or name it in NPSEE_OSMESA.");
  }
  // Never closed: the driver keeps threads.
  Library library;
  if (!resolve(handle, "OSMesaCreateContextAttribs", library.create) || !resolve(handle, "OSMesaDestroyContext", library.destroy) ||
      !resolve(handle, "OSMesaMakeCurrent", library.makeCurrent) || !resolve(handle, "OSMesaGetProcAddress", library.find))
    return fail(ErrorKind::graphics, std::string("cannot draw without a display: ") + name + " is no OSMesa library of version 11.2 or later.",
                "Install Debian's libosmesa6, or unset NPSEE_OSMESA.");
  return library;
}

class OffscreenContext final : public Context {
 public:
  OffscreenContext(const Library& library, OSMesaHandle handle) : library_(library), handle_(handle) {}
  ~OffscreenContext() override { library_.destroy(handle_); }
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

  bool tryMakeCurrent() { return library_.makeCurrent(handle_, pixel_.data(), kUnsignedByte, 1, 1) != 0; }
  void makeCurrent() override {
    tryMakeCurrent();
    ensureFunctions(library_.find, this);
  }
  std::string description() const override { return describeDriver(); }
  FindFunction find() const { return library_.find; }

 private:
  Library library_;
  OSMesaHandle handle_;
  // OSMesa insists on a buffer; everything is drawn into framebuffer objects instead.
  std::array<unsigned char, 4> pixel_{};
};

}  // namespace

Expected<std::unique_ptr<Context>> makeOffscreenContext() {
  const auto library = openLibrary();
  if (!library) return tl::unexpected<Error>(library.error());
  const int attributes[] = {kFormat, kRgba, kDepthBits, 0, kProfile, kCoreProfile, kMajor, 3, kMinor, 3, 0};
  const OSMesaHandle handle = library->create(attributes, nullptr);
  const char* const remedy = "Unset GALLIUM_DRIVER and MESA_* variables, or install Debian's libosmesa6.";
  if (handle == nullptr) return fail(ErrorKind::graphics, "cannot draw without a display: OSMesa gives no OpenGL 3.3 core context.", remedy);
  auto context = std::make_unique<OffscreenContext>(*library, handle);
  if (!context->tryMakeCurrent()) return fail(ErrorKind::graphics, "cannot draw without a display: OSMesa's context cannot be used.", remedy);
  if (auto loaded = loadFunctions(context->find(), context.get()); !loaded) return tl::unexpected<Error>(loaded.error());
  return context;
}

}  // namespace npsee::gl
