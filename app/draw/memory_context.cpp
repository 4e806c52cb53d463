#include <GL/osmesa.h>

#include "app/draw/context.hpp"

namespace app::draw {

namespace {

/// What OSMesa keeps, current as soon as it is made.
struct Memory {
    Memory() {
        const int wanted[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_DEPTH_BITS,
                              0,
                              OSMESA_PROFILE,
                              OSMESA_CORE_PROFILE,
                              OSMESA_CONTEXT_MAJOR_VERSION,
                              3,
                              OSMESA_CONTEXT_MINOR_VERSION,
                              3,
                              0};
        context = OSMesaCreateContextAttribs(wanted, nullptr);
        if (!context) throw DrawError("cannot draw: OSMesa gives no OpenGL 3.3 core context");
        make_current();
    }
    ~Memory() { OSMesaDestroyContext(context); }
    Memory(const Memory&) = delete;
    Memory& operator=(const Memory&) = delete;
    void make_current() {
        if (!OSMesaMakeCurrent(context, own, GL_UNSIGNED_BYTE, 16, 16))
            throw DrawError("cannot draw: OSMesa's context cannot be made current");
    }
    OSMesaContext context = nullptr;
    unsigned char own[16 * 16 * 4];  // the context wants a picture of its own; ours are larger and come and go
};

void* osmesa_function(const char* name) {
    return reinterpret_cast<void*>(OSMesaGetProcAddress(name));
}

// The memory comes first: its context is current when the functions are looked for.
class MemoryContext : private Memory, public Context {
  public:
    MemoryContext() : Context(osmesa_function) {}
    void make_current() override { Memory::make_current(); }
};

}  // namespace

std::unique_ptr<Context> memory_context() {
    return std::make_unique<MemoryContext>();
}

}  // namespace app::draw
