#include "app/window/window.hpp"

#include <GL/glcorearb.h>
#include <backends/imgui_impl_opengl3.h>
#include <backends/imgui_impl_sdl.h>
#include <imgui.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "app/window/theme.hpp"

namespace app::window {

namespace {

[[noreturn]] void refuse(const std::string& why) {
    throw NoWindow("play: no window: " + why + "; `carrel run DRILL` plays a drill without one");
}

std::string why_not() {
    const std::string said = SDL_GetError();
    return said.empty() ? "the system does not say why" : said;
}

// Asked of a system without any, libraries below SDL print lines of their own.
bool has_display() {
    const char* const names[] = {"DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER"};
    return std::any_of(std::begin(names), std::end(names), [](const char* name) {
        const char* value = std::getenv(name);
        return value && *value;
    });
}

// As large as the screen has room for.
SDL_Rect wanted_size() {
    SDL_Rect room{0, 0, 1280, 720};
    SDL_GetDisplayUsableBounds(0, &room);
    return {0, 0, std::min(room.w, 1280), std::min(room.h, 720)};
}

}  // namespace

Window::Window(double scale) : scale_(scale) {
    // One thread for the software renderer leaves a core to the ticks.
    setenv("LP_NUM_THREADS", "1", 0);
    if (!has_display()) refuse("there is no display");
    SDL_SetMainReady();
    SDL_SetHint(SDL_HINT_MOUSE_FOCUS_CLICKTHROUGH, "1");  // the click that brings the window forward counts as well
    if (SDL_Init(SDL_INIT_VIDEO) != 0) refuse("no display could be opened (" + why_not() + ")");
    try {
        open();
    } catch (...) {
        SDL_Quit();
        throw;
    }
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui::GetIO().ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    ImGui_ImplSDL2_InitForOpenGL(window_, context_);
    ImGui_ImplOpenGL3_Init("#version 330 core");
}

void Window::open() {
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_CORE);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 24);
    const SDL_Rect size = wanted_size();
    window_ = SDL_CreateWindow("Carrel", SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, size.w, size.h,
                               SDL_WINDOW_OPENGL | SDL_WINDOW_RESIZABLE);
    if (!window_) refuse("the display gives none (" + why_not() + ")");
    SDL_SetWindowMinimumSize(window_, 640, 400);
    context_ = SDL_GL_CreateContext(window_);
    if (!context_) refuse("the display has no OpenGL 3.3 (" + why_not() + ")");
    SDL_GL_SetSwapInterval(1);
    const auto get_string = reinterpret_cast<PFNGLGETSTRINGPROC>(SDL_GL_GetProcAddress("glGetString"));
    const auto text_of = [&](unsigned what) { return reinterpret_cast<const char*>(get_string(what)); };
    renderer_ = std::string(text_of(GL_VERSION)) + " | " + text_of(GL_RENDERER);
}

Window::~Window() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplSDL2_Shutdown();
    ImGui::DestroyContext();
    SDL_GL_DeleteContext(context_);
    SDL_DestroyWindow(window_);
    SDL_Quit();
}

bool Window::next_event(SDL_Event& event, int wait_ms) {
    return wait_ms > 0 ? SDL_WaitEventTimeout(&event, wait_ms) : SDL_PollEvent(&event);
}

void Window::give_controls(const SDL_Event& event) {
    ImGui_ImplSDL2_ProcessEvent(&event);
}

void Window::begin() {
    if (has_new_scale_) make_fonts();
    has_new_scale_ = false;
    SDL_GL_GetDrawableSize(window_, &width_, &height_);
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplSDL2_NewFrame();
    if (is_caught_) ImGui::GetIO().MousePos = {-1e6f, -1e6f};
    ImGui::NewFrame();
    static const auto viewport = reinterpret_cast<PFNGLVIEWPORTPROC>(SDL_GL_GetProcAddress("glViewport"));
    static const auto clear_color = reinterpret_cast<PFNGLCLEARCOLORPROC>(SDL_GL_GetProcAddress("glClearColor"));
    static const auto clear = reinterpret_cast<PFNGLCLEARPROC>(SDL_GL_GetProcAddress("glClear"));
    viewport(0, 0, width_, height_);
    const ImVec4 back = ImGui::ColorConvertU32ToFloat4(theme::background);
    clear_color(back.x, back.y, back.z, 1);
    clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void Window::end() {
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    SDL_GL_SwapWindow(window_);
}

void Window::set_scale(double scale) {
    has_new_scale_ |= scale != scale_;
    scale_ = scale;
}

void Window::catch_pointer(bool is_caught) {
    if (is_caught == is_caught_) return;
    is_caught_ = is_caught;
    SDL_SetRelativeMouseMode(is_caught ? SDL_TRUE : SDL_FALSE);
    auto& flags = ImGui::GetIO().ConfigFlags;
    flags = is_caught ? flags | ImGuiConfigFlags_NoMouse : flags & ~ImGuiConfigFlags_NoMouse;
}

void Window::toggle_full_screen() {
    const bool is_full = SDL_GetWindowFlags(window_) & SDL_WINDOW_FULLSCREEN_DESKTOP;
    SDL_SetWindowFullscreen(window_, is_full ? 0 : SDL_WINDOW_FULLSCREEN_DESKTOP);
}

// Without DejaVu the letters of ImGui itself do, which know no signs beyond ASCII.
void Window::make_fonts() {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    static const ImWchar glyphs[] = {0x20,   0x24f,  0x2010, 0x2044, 0x2190, 0x2193, 0x2212, 0x2265,
                                     0x25a0, 0x25ff, 0x2605, 0x2606, 0x2713, 0x2717, 0};
    const auto letters = [&](const char* file, double pixels) {
        const std::string path = std::string("/usr/share/fonts/truetype/dejavu/") + file;
        const auto size = static_cast<float>(std::round(pixels * scale_));
        if (std::filesystem::exists(path)) return atlas.AddFontFromFileTTF(path.c_str(), size, nullptr, glyphs);
        ImFontConfig config;
        config.SizePixels = size;
        return atlas.AddFontDefault(&config);
    };
    fonts_.text = letters("DejaVuSans.ttf", 16);
    fonts_.bold = letters("DejaVuSans-Bold.ttf", 16);
    fonts_.title = letters("DejaVuSans-Bold.ttf", 26);
    fonts_.small = letters("DejaVuSans.ttf", 13);
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
    theme::apply(scale_);
}

}  // namespace app::window
