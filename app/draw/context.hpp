#pragma once
#include <memory>
#include <stdexcept>

namespace app::draw {

/// Something cannot be drawn; one line that says why.
struct DrawError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct Gl;

/// Finds a function of OpenGL by its whole name, as SDL_GL_GetProcAddress does; nullptr where there is none.
using Loader = void* (*)(const char* name);

/// OpenGL 3.3 core: its functions, and the thing to make current before they are called.
class Context {
  public:
    /// Somebody else's context, say a window's, which is current now and in this thread at every later use.
    /// Throws DrawError: a function is missing.
    explicit Context(Loader load);
    virtual ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
    /// Makes it the one that is drawn with; somebody else's is so already.
    virtual void make_current() {}
    /// Its functions; gl.hpp names them.
    Gl& gl() { return *gl_; }

  private:
    std::unique_ptr<Gl> gl_;
};

/// One in memory, by Mesa's software OpenGL: needs neither a window nor a graphics card.
/// Throws DrawError: there is no OpenGL 3.3.
std::unique_ptr<Context> memory_context();

}  // namespace app::draw
