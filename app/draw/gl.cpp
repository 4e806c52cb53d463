#include "app/draw/gl.hpp"

#include "app/draw/context.hpp"

namespace app::draw {

Context::Context(Loader load) : gl_(std::make_unique<Gl>()) {
#define CARREL_GL_LOAD(TYPE, name)                                     \
    gl_->name = reinterpret_cast<PFNGL##TYPE##PROC>(load("gl" #name)); \
    if (!gl_->name) throw DrawError("cannot draw: OpenGL has no gl" #name);
    CARREL_GL_FUNCTIONS(CARREL_GL_LOAD)
#undef CARREL_GL_LOAD
}

Context::~Context() = default;

static unsigned texture_of(Gl& gl, int width, int height, int kept_as, unsigned format, unsigned type) {
    unsigned id = 0;
    gl.GenTextures(1, &id);
    gl.BindTexture(GL_TEXTURE_2D, id);
    gl.TexImage2D(GL_TEXTURE_2D, 0, kept_as, width, height, 0, format, type, nullptr);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return id;
}

Target::Target(Gl& gl, int w, int h, bool with_color, int depth_kind) : width(w), height(h), gl_(gl) {
    gl.GenFramebuffers(1, &frame_);
    gl.BindFramebuffer(GL_FRAMEBUFFER, frame_);
    depth = texture_of(gl, w, h, depth_kind, GL_DEPTH_COMPONENT, GL_FLOAT);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth, 0);
    if (with_color) {
        color = texture_of(gl, w, h, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE);
        gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color, 0);
    } else {
        gl.DrawBuffer(GL_NONE);
        gl.ReadBuffer(GL_NONE);
    }
    if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw DrawError("cannot draw: OpenGL gives no picture of " + std::to_string(w) + " x " + std::to_string(h));
}

Target::~Target() {
    gl_.DeleteFramebuffers(1, &frame_);
    gl_.DeleteTextures(1, &depth);
    if (color) gl_.DeleteTextures(1, &color);
}

void Target::draw_here() const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, frame_);
    gl_.Viewport(0, 0, width, height);
}

Buffers::Buffers(Gl& gl) : gl_(gl) {
    gl.GenVertexArrays(1, &array_);
    gl.BindVertexArray(array_);
    gl.GenBuffers(2, buffers_);
    gl.BindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[1]);
    for (unsigned i = 0; i < 2; ++i) {
        gl.EnableVertexAttribArray(i);
        gl.VertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                               reinterpret_cast<const void*>(i * sizeof(Eigen::Vector3f)));
    }
}

Buffers::~Buffers() {
    gl_.DeleteBuffers(2, buffers_);
    gl_.DeleteVertexArrays(1, &array_);
}

template <class T>
void Buffers::put(unsigned to, const std::vector<T>& values, std::size_t& room) {
    const std::size_t size = values.size() * sizeof(T);
    if (size > room) gl_.BufferData(to, static_cast<GLsizeiptr>(room = size + size / 4), nullptr, GL_DYNAMIC_DRAW);
    gl_.BufferSubData(to, 0, static_cast<GLsizeiptr>(size), values.data());
}

void Buffers::fill(const Surface& surface) {
    gl_.BindVertexArray(array_);
    gl_.BindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
    put(GL_ARRAY_BUFFER, surface.vertices, rooms_[0]);
    put(GL_ELEMENT_ARRAY_BUFFER, surface.indices, rooms_[1]);
}

void Buffers::draw(std::size_t first, std::size_t count) const {
    gl_.BindVertexArray(array_);
    gl_.DrawElements(GL_TRIANGLES, static_cast<int>(count), GL_UNSIGNED_INT,
                     reinterpret_cast<const void*>(first * sizeof(unsigned)));
}

Program::Program(Gl& gl, const std::string& vertex, const std::string& fragment, const std::string& defines)
    : gl_(gl), id_(gl.CreateProgram()) {
    const auto attach = [&](unsigned kind, const std::string& text) {
        const std::string whole = "#version 330 core\n" + defines + text;
        const char* source = whole.c_str();
        const unsigned shader = gl.CreateShader(kind);
        gl.ShaderSource(shader, 1, &source, nullptr);
        gl.CompileShader(shader);
        gl.AttachShader(id_, shader);
        gl.DeleteShader(shader);  // lives as long as the program
    };
    attach(GL_VERTEX_SHADER, vertex);
    attach(GL_FRAGMENT_SHADER, fragment);
    gl.LinkProgram(id_);
    int linked = 0;
    gl.GetProgramiv(id_, GL_LINK_STATUS, &linked);
    if (linked) return;
    char log[2000] = "";
    gl.GetProgramInfoLog(id_, sizeof log, nullptr, log);
    throw DrawError(std::string("cannot draw: a shader does not compile: ") + log);
}

Program::~Program() {
    gl_.DeleteProgram(id_);
}

void Program::set(const char* name, const Vec3& value) const {
    gl_.Uniform3fv(at(name), 1, value.cast<float>().eval().data());
}

void Program::set(const char* name, const Eigen::Matrix4d& value) const {
    gl_.UniformMatrix4fv(at(name), 1, GL_FALSE, value.cast<float>().eval().data());
}

void Program::texture(const char* name, int unit, unsigned id) const {
    gl_.ActiveTexture(GL_TEXTURE0 + unit);
    gl_.BindTexture(GL_TEXTURE_2D, id);
    set(name, unit);
}

}  // namespace app::draw
