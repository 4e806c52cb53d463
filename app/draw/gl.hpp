#pragma once
#include <GL/glcorearb.h>

#include <string>

#include "app/draw/surface.hpp"

namespace app::draw {

/// The functions of OpenGL 3.3 used here, by their names without "gl".
// clang-format off
#define CARREL_GL_FUNCTIONS(F) \
    F(ACTIVETEXTURE, ActiveTexture) \
    F(ATTACHSHADER, AttachShader) \
    F(BINDBUFFER, BindBuffer) \
    F(BINDFRAMEBUFFER, BindFramebuffer) \
    F(BINDTEXTURE, BindTexture) \
    F(BINDVERTEXARRAY, BindVertexArray) \
    F(BLENDFUNC, BlendFunc) \
    F(BUFFERDATA, BufferData) \
    F(BUFFERSUBDATA, BufferSubData) \
    F(CHECKFRAMEBUFFERSTATUS, CheckFramebufferStatus) \
    F(CLEAR, Clear) \
    F(COLORMASK, ColorMask) \
    F(COMPILESHADER, CompileShader) \
    F(CREATEPROGRAM, CreateProgram) \
    F(CREATESHADER, CreateShader) \
    F(CULLFACE, CullFace) \
    F(DELETEBUFFERS, DeleteBuffers) \
    F(DELETEFRAMEBUFFERS, DeleteFramebuffers) \
    F(DELETEPROGRAM, DeleteProgram) \
    F(DELETESHADER, DeleteShader) \
    F(DELETETEXTURES, DeleteTextures) \
    F(DELETEVERTEXARRAYS, DeleteVertexArrays) \
    F(DEPTHFUNC, DepthFunc) \
    F(DEPTHMASK, DepthMask) \
    F(DISABLE, Disable) \
    F(DRAWARRAYS, DrawArrays) \
    F(DRAWBUFFER, DrawBuffer) \
    F(DRAWELEMENTS, DrawElements) \
    F(ENABLE, Enable) \
    F(ENABLEVERTEXATTRIBARRAY, EnableVertexAttribArray) \
    F(FINISH, Finish) \
    F(FRAMEBUFFERTEXTURE2D, FramebufferTexture2D) \
    F(GENBUFFERS, GenBuffers) \
    F(GENFRAMEBUFFERS, GenFramebuffers) \
    F(GENTEXTURES, GenTextures) \
    F(GENVERTEXARRAYS, GenVertexArrays) \
    F(GETERROR, GetError) \
    F(GETPROGRAMINFOLOG, GetProgramInfoLog) \
    F(GETPROGRAMIV, GetProgramiv) \
    F(GETUNIFORMLOCATION, GetUniformLocation) \
    F(LINKPROGRAM, LinkProgram) \
    F(PIXELSTOREI, PixelStorei) \
    F(READBUFFER, ReadBuffer) \
    F(READPIXELS, ReadPixels) \
    F(SCISSOR, Scissor) \
    F(SHADERSOURCE, ShaderSource) \
    F(TEXIMAGE2D, TexImage2D) \
    F(TEXPARAMETERFV, TexParameterfv) \
    F(TEXPARAMETERI, TexParameteri) \
    F(UNIFORM1F, Uniform1f) \
    F(UNIFORM1I, Uniform1i) \
    F(UNIFORM2I, Uniform2i) \
    F(UNIFORM3FV, Uniform3fv) \
    F(UNIFORM4FV, Uniform4fv) \
    F(UNIFORMMATRIX4FV, UniformMatrix4fv) \
    F(USEPROGRAM, UseProgram) \
    F(VERTEXATTRIBPOINTER, VertexAttribPointer) \
    F(VIEWPORT, Viewport)
// clang-format on

/// OpenGL, as a context has found it.
struct Gl {
#define CARREL_GL_MEMBER(TYPE, name) PFNGL##TYPE##PROC name;
    CARREL_GL_FUNCTIONS(CARREL_GL_MEMBER)
#undef CARREL_GL_MEMBER
};

/// A picture on the graphics side, with depth; colour is left out where only depth is wanted.
class Target {
  public:
    /// depth_kind: GL_DEPTH_COMPONENT16, ...32F.
    Target(Gl& gl, int width, int height, bool with_color, int depth_kind = GL_DEPTH_COMPONENT32F);
    ~Target();
    Target(const Target&) = delete;
    Target& operator=(const Target&) = delete;
    /// All that is drawn from now on goes here.
    void draw_here() const;
    unsigned frame() const { return frame_; }  ///< Its framebuffer.
    const int width, height;
    unsigned color = 0, depth = 0;  ///< Textures.

  private:
    Gl& gl_;
    unsigned frame_ = 0;
};

/// Triangles on the graphics side.
class Buffers {
  public:
    explicit Buffers(Gl& gl);
    ~Buffers();
    Buffers(const Buffers&) = delete;
    Buffers& operator=(const Buffers&) = delete;
    /// Takes the place of what was there; keeps its room where it is enough.
    void fill(const Surface& surface);
    /// Draws so many indices from this one on.
    void draw(std::size_t first, std::size_t count) const;

  private:
    Gl& gl_;
    template <class T>
    void put(unsigned to, const std::vector<T>& values, std::size_t& room);
    unsigned array_ = 0, buffers_[2] = {};
    std::size_t rooms_[2] = {};  // bytes
};

/// Shaders, linked.
class Program {
  public:
    /// Throws DrawError, which has the compiler's words.
    /// defines: lines that come before both.
    Program(Gl& gl, const std::string& vertex, const std::string& fragment, const std::string& defines = "");
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;
    void use() const { gl_.UseProgram(id_); }
    void set(const char* name, int value) const { gl_.Uniform1i(at(name), value); }
    void set(const char* name, float value) const { gl_.Uniform1f(at(name), value); }
    void set(const char* name, int x, int y) const { gl_.Uniform2i(at(name), x, y); }
    void set(const char* name, const Vec3& value) const;
    void set(const char* name, const Eigen::Vector4f& value) const { gl_.Uniform4fv(at(name), 1, value.data()); }
    void set(const char* name, const Eigen::Matrix4d& value) const;
    void texture(const char* name, int unit, unsigned texture) const;

  private:
    int at(const char* name) const { return gl_.GetUniformLocation(id_, name); }
    Gl& gl_;
    unsigned id_;
};

}  // namespace app::draw
