// SPDX-License-Identifier: MIT
#include "panel.h"

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <math.h>
#include <stdio.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "drawing/failure.h"
#include "followed.h"

namespace {

constexpr int graph_room = 240; // steps

// The last values of a number that changes from step to step.
struct Graph {
    const char* name;
    const char* unit;
    const char* about;
    bool timing; // differs from run to run: not in pictures
    float values[graph_room] = {};
    int at = 0, count = 0;

    void note(double value) {
        values[at] = static_cast<float>(value);
        at = (at + 1) % graph_room;
        count = std::min(count + 1, graph_room);
    }
    float last() const { return count ? values[(at + graph_room - 1) % graph_room] : 0.0f; }
};

enum graph {
    graph_step,
    graph_motion,
    graph_wind,
    graph_body_contact,
    graph_colliders,
    graph_wake,
    graph_rules,
    graph_events,
    graph_awake,
    graph_hits,
    graph_speed,
    graph_energy,
    graph_number
};

struct Means {
    double speed, energy; // m/s; mJ, of the centre of mass: kinetic, and height over y = 0
};

// Over some hundred bodies: states are read one by one.
Means means_of(const scene& s) {
    constexpr uint32_t most = 400;
    Means sum{};
    uint32_t number = 0;
    for (int k = 0; k < s.batch_count; ++k) {
        const scene_batch& b = s.batches[k];
        lr_batch_view view;
        check(lr_batch_view_init(&view, sizeof view), "lr_batch_view_init", nullptr);
        check(lr_batch_get_view(s.world, b.batch, &view), "view", nullptr);
        const uint32_t apart = view.count / most + 1;
        for (uint32_t i = 0; i < view.count; i += apart, ++number) {
            lr_body_state state;
            check(lr_body_state_init(&state, sizeof state), "lr_body_state_init", nullptr);
            check(lr_body_get_state(s.world, view.ids[i], &state), "state", nullptr);
            const float* const v = state.linear_velocity;
            const double speed = std::hypot(double(v[0]), double(v[1]), double(v[2])), scale = double(state.scale);
            sum.speed += speed;
            sum.energy +=
                1e3 * b.info.mass * scale * scale * scale * (0.5 * speed * speed + 9.81 * double(state.position[1]));
        }
    }
    if (number != 0) sum.speed /= number, sum.energy /= number;
    return sum;
}
} // namespace

struct panel {
    ImGuiContext* context = ImGui::CreateContext();
    Graph graphs[graph_number] = {
        {"step", "ms", "time on the clock for a step of the whole world", true},
        {"motion", "ms", "flight: forces of the air, and integration", true},
        {"wind", "ms", "sampling of the wind at all bodies", true},
        {"body contact", "ms", "bodies that touch each other: pairs and their solver", true},
        {"colliders", "ms", "ground, boxes, spheres", true},
        {"waking", "ms", "looking for sleeping bodies that wind or neighbours wake", true},
        {"emitters, rules", "ms", "births and ends", true},
        {"events", "ms", "collecting events", true},
        {"awake", "", "bodies that are not asleep", false},
        {"hits", "", "bodies that began to touch something in a step: with \"show hits\"", false},
        {"mean speed", "m/s", "of all bodies, those asleep as well", false},
        {"mean energy", "mJ", "of a body: motion of its centre of mass, and height over y = 0", false},
    };
    struct Place {
        std::string name;
        ImVec2 low, high;
    };
    std::vector<Place> places; // of the last frame
    struct Hit {
        vec3 at;
        float speed;
        int age; // steps
    };
    std::vector<Hit> hits; // of the last steps
    bool show_hits = false;
    int scale = 0; // px of the font over its own 13
    int batch = 0; // shown by the editors
    bool drawn = false;
};

namespace {

// Names a part, for tests, and explains it.
void placed(panel& p, const char* name, const char* about = nullptr) {
    p.places.push_back({name, ImGui::GetItemRectMin(), ImGui::GetItemRectMax()});
    if (about && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", about);
}

// A slider, the number beside it to be typed, its unit, and a way back. True if it has changed.
bool number(panel& p, const char* name, const char* unit, float& value, float low, float high, const char* format,
            bool geometric, float initially, const char* about) {
    const float before = value, letter = ImGui::GetFontSize();
    ImGui::PushID(name);
    ImGui::SetNextItemWidth(7.0f * letter);
    ImGui::SliderFloat("##slider", &value, low, high, "", geometric ? ImGuiSliderFlags_Logarithmic : 0);
    placed(p, (std::string(name) + " slider").c_str(), about);
    ImGui::SameLine(0.0f, 0.3f * letter);
    ImGui::SetNextItemWidth(4.2f * letter);
    float typed = value;
    if (ImGui::InputFloat("##typed", &typed, 0.0f, 0.0f, format,
                          ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll))
        value = typed;
    placed(p, (std::string(name) + " number").c_str(), "type a number, then Enter");
    ImGui::SameLine(0.0f, 0.3f * letter);
    ImGui::Text("%s%s%s", name, *unit ? ", " : "", unit);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", about);
    if (value != initially) {
        ImGui::SameLine();
        if (ImGui::SmallButton("reset")) value = initially;
        placed(p, (std::string(name) + " reset").c_str(), "back to the scene's value");
    }
    ImGui::PopID();
    value = std::isfinite(value) ? std::clamp(value, low, high) : before;
    return value != before;
}

void slide(panel& p, viewer& v, enum setting which, const char* about) {
    const setting_kind& kind = setting_kinds[which];
    float& value = v.wanted.value[which];
    char format[8];
    std::snprintf(format, sizeof format, "%%.%df", kind.decimals);
    if (number(p, kind.label, kind.unit, value, kind.low, kind.high, format, kind.geometric != 0,
               v.scene->plan->initially.value[which], about))
        value = setting_rounded(which, value);
}

void show_plan(panel& p, viewer& v) {
    const scene_plan* chosen = v.scene->plan;
    ImGui::SetNextItemWidth(20.0f * ImGui::GetFontSize());
    const bool open = ImGui::BeginCombo("##scene", chosen->title);
    if (!open) placed(p, "scene", "keys 1 to 7");
    for (int k = 0; open && k < scene_plan_count; ++k) {
        const scene_plan& plan = scene_plans[k];
        if (ImGui::Selectable(plan.title, &plan == v.scene->plan)) chosen = &plan;
        placed(p, plan.name);
    }
    if (open) ImGui::EndCombo();
    if (ImGui::Button(v.paused ? "go on" : "pause")) v.paused = !v.paused;
    placed(p, "pause", "space");
    ImGui::SameLine();
    if (ImGui::Button("step")) v.paused = v.single = 1;
    placed(p, "step", "n: a sixtieth of a second");
    ImGui::SameLine();
    const bool again = ImGui::Button("restart");
    placed(p, "restart", "r: from the beginning, with these settings");
    ImGui::SameLine();
    if (ImGui::Button("picture")) v.snapshot = 1;
    placed(p, "picture", "p: writes viewer_NNN.png");
    if (chosen != v.scene->plan)
        viewer_show_plan(&v, chosen, &chosen->initially, &chosen->camera);
    else if (again)
        viewer_show_plan(&v, chosen, &v.wanted, &v.camera);
}

void show_wind(panel& p, viewer& v) {
    slide(p, v, setting_wind, "speed of the mean wind, 3 m above the ground");
    slide(p, v, setting_direction, "where it blows to, from +x towards -z");
    slide(p, v, setting_gusts, "root mean square of the wind's changes with time");
    slide(p, v, setting_turbulence, "root mean square of eddies, in each direction");
    bool arrows = v.show_arrows != 0;
    ImGui::Checkbox("show the wind", &arrows);
    placed(p, "show the wind", "a: arrows as the library samples the wind there");
    v.show_arrows = arrows;
}

void show_bodies(panel& p, viewer& v) {
    slide(p, v, setting_count, "bodies in the scene at most");
    slide(p, v, setting_time, "seconds of the world per second of the clock");
    slide(p, v, setting_substeps, "substeps in a sixtieth of a second");
    float& model = v.wanted.value[setting_model];
    ImGui::SetNextItemWidth(11.5f * ImGui::GetFontSize());
    const bool open = ImGui::BeginCombo("loads", load_models[static_cast<int>(model)].name);
    if (!open) placed(p, "loads", "aerodynamic: flutters and tumbles; langevin: the paper's; none: as in a vacuum");
    for (int i = 0; open && i < load_model_count; ++i) {
        if (ImGui::Selectable(load_models[i].name, i == static_cast<int>(model))) model = static_cast<float>(i);
        placed(p, load_models[i].name);
    }
    if (open) ImGui::EndCombo();
    bool contact = v.wanted.value[setting_contact] > 0.0f, trails = v.show_trails != 0;
    ImGui::Checkbox("bodies touch each other", &contact);
    placed(p, "contact", "without it they lie in one another");
    v.wanted.value[setting_contact] = contact ? 1.0f : 0.0f;
    ImGui::Checkbox("show hits", &p.show_hits);
    placed(p, "show hits", "where bodies meet ground and solids, by lr_world_get_events; wider with their speed");
    ImGui::Checkbox("show paths", &trails);
    placed(p, "show paths", "t: of twelve bodies");
    if (trails != (v.show_trails != 0)) trails_clear(&v.trails);
    v.show_trails = trails;
}

// Which batch the editors show, if there are several.
const scene_batch& chosen_batch(panel& p, viewer& v) {
    p.batch = std::clamp(p.batch, 0, v.scene->batch_count - 1);
    for (int k = 0; v.scene->batch_count > 1 && k < v.scene->batch_count; ++k) {
        if (k > 0) ImGui::SameLine();
        ImGui::PushID(k);
        ImGui::RadioButton(v.scene->batches[k].info.name, &p.batch, k);
        ImGui::PopID();
    }
    return v.scene->batches[p.batch];
}

void show_material(panel& p, viewer& v) {
    const scene_batch& b = chosen_batch(p, v);
    lr_batch_contact contact, initially;
    check(lr_batch_contact_init(&contact, sizeof contact), "lr_batch_contact_init", nullptr);
    initially = contact;
    check(lr_batch_get_contact(v.scene->world, b.batch, &contact), "contact", nullptr);
    bool changed = number(p, "friction", "", contact.friction, 0.0f, 2.0f, "%.2f", false, initially.friction,
                          "of Coulomb; with another body or a collider the geometric mean of both counts");
    changed |= number(p, "bounce", "", contact.restitution, 0.0f, 1.0f, "%.2f", false, initially.restitution,
                      "speed after a blow over speed before it");
    changed |= number(p, "rolling", "", contact.rolling_resistance, 0.0f, 1.0f, "%.2f", false,
                      initially.rolling_resistance, "moment against rolling over normal force times lever");
    changed |= number(p, "air cushion", "", contact.ground_effect, 0.0f, 1.0f, "%.2f", false,
                      v.scene->plan->ground_effect, "below a sheet that settles on the ground, as a share of theory");
    if (changed) check(lr_batch_set_contact(v.scene->world, b.batch, &contact), "contact", nullptr);
}

void show_emitter(panel& p, viewer& v) {
    const scene_batch& b = chosen_batch(p, v);
    lr_emitter_desc desc;
    int32_t present = 0;
    check(lr_emitter_desc_init(&desc, sizeof desc), "lr_emitter_desc_init", nullptr);
    check(lr_batch_get_emitter(v.scene->world, b.batch, &desc, &present), "emitter", nullptr);
    if (!present) return;
    const scene_kind& kind = *b.kind;
    bool changed = false;
    if (desc.burst_count == 0)
        changed |= number(p, "rate", "1/s", desc.rate, 0.0f, 5000.0f, "%.0f", false,
                          static_cast<float>(b.count) / v.scene->plan->life, "bodies born in a second");
    changed |= number(p, "height", "m", desc.position[1], 0.0f, 10.0f, "%.2f", false, kind.at[1],
                      "of the middle of the box in which they are born");
    changed |= number(p, "width", "m", desc.size[0], 0.0f, 5.0f, "%.2f", false, kind.half[0],
                      "half of that box's extent along x");
    changed |= number(p, "depth", "m", desc.size[2], 0.0f, 5.0f, "%.2f", false, kind.half[2],
                      "half of that box's extent along z");
    changed |= number(p, "speed", "m/s", desc.speed_max, 0.0f, 20.0f, "%.2f", false, kind.speed_max,
                      "of the fastest ones at birth");
    changed |= number(p, "spin", "rad/s", desc.spin_max, 0.0f, 50.0f, "%.1f", false, kind.spin,
                      "of those that turn fastest at birth");
    changed |= number(p, "size", "x", desc.scale_max, 0.1f, 5.0f, "%.2f", true, kind.scale_max,
                      "of the largest ones, over that of the asset");
    desc.speed_min = std::min(desc.speed_min, desc.speed_max);
    desc.spin_min = std::min(desc.spin_min, desc.spin_max);
    desc.scale_min = std::min(desc.scale_min, desc.scale_max);
    if (changed) check(lr_batch_set_emitter(v.scene->world, b.batch, &desc), "emitter", "try smaller numbers");
}

void show_history(panel& p, viewer& v, double time) {
    bool on = v.history.on != 0;
    ImGui::Checkbox("keep the last seconds", &on);
    placed(p, "keep", "a snapshot of the world every quarter of a second, up to 512 MB");
    if (!on && v.history.on) history_clear(&v.history);
    v.history.on = on;
    if (v.history.count > 0) {
        const double first = v.history.kept[v.history.first].time;
        float at = static_cast<float>(time);
        ImGui::SetNextItemWidth(11.5f * ImGui::GetFontSize());
        if (ImGui::SliderFloat("time, s", &at, static_cast<float>(first), static_cast<float>(time), "%.2f"))
            viewer_return(&v, static_cast<double>(at));
        placed(p, "return",
               "goes back to the snapshot before, and waits; from there everything happens again, bit by bit");
    }
    if (ImGui::Button(v.recording ? "end the recording" : "record")) viewer_record(&v, !v.recording);
    placed(p, "record", "all calls to the library, into viewer_NNN.lrr: lr_replay plays it");
}

void show_graphs(panel& p, viewer& v, const scene_report& r) {
    ImGui::Text("%llu bodies, %llu asleep", static_cast<unsigned long long>(r.bodies),
                static_cast<unsigned long long>(r.bodies - r.awake));
    ImGui::Text("t = %.2f s%s", r.time, v.paused ? ", paused" : "");
    if (v.frame_seconds > 0.0) ImGui::Text("%.0f pictures/s", 1.0 / v.frame_seconds);
    for (const Graph& g : p.graphs) {
        if (g.count == 0 || (g.timing && !(v.frame_seconds > 0.0))) continue;
        if (&g == &p.graphs[graph_hits] && !p.show_hits) continue; // no events are asked for
        const float most = *std::max_element(g.values, g.values + graph_room);
        if (g.timing && most < 0.01f) continue; // a phase that this scene has not
        ImGui::PlotLines("##graph", g.values, g.count, g.count < graph_room ? 0 : g.at, nullptr, 0.0f, 1.05f * most,
                         ImVec2(9.0f * ImGui::GetFontSize(), 2.2f * ImGui::GetFontSize()));
        placed(p, (std::string(g.name) + " graph").c_str(), g.about);
        ImGui::SameLine();
        const double now = static_cast<double>(g.last());
        ImGui::Text(g.timing ? "%s\n%.2f %s" : "%s\n%.4g %s", g.name, now, g.unit);
    }
}

void show_body(panel& p, viewer& v) {
    Followed body = followed(v);
    if (!body.there) return;
    describe(v, body);
    lr_body_state& s = body.state;
    ImGui::TextUnformatted(s.sleep_state == LR_SLEEP_ASLEEP ? "asleep" : "awake");
    if (ImGui::Button("let go")) v.followed.id = 0;
    placed(p, "let go", "f: the camera stays");
    ImGui::SameLine();
    if (ImGui::Button("throw up")) {
        s.linear_velocity[1] += 4.0f;
        check(lr_body_set_state(v.scene->world, v.followed, &s), "throwing", nullptr);
    }
    placed(p, "throw up", "with 4 m/s");
}

// Returns how many are new.
uint32_t note_hits(panel& p, const viewer& v) {
    constexpr uint32_t most = 4096;
    constexpr int lasts = 20;
    lr_event_list list;
    check(lr_event_list_init(&list, sizeof list), "lr_event_list_init", nullptr);
    check(lr_world_get_events(v.scene->world, &list), "events", nullptr);
    for (panel::Hit& hit : p.hits) ++hit.age;
    std::erase_if(p.hits, [](const panel::Hit& hit) { return hit.age > lasts; });
    for (uint32_t i = 0; i < list.count; ++i)
        p.hits.push_back({from_array(list.events[i].position), list.events[i].speed, 0});
    if ((list.capacity != 0) != p.show_hits)
        check(lr_world_set_events(v.scene->world, p.show_hits ? most : 0, p.show_hits ? LR_EVENTS_HIT : 0), "events",
              nullptr);
    return list.count;
}

// A ring at the place of each hit, wider with its speed, and fainter with its age.
void draw_hits(const panel& p, const viewer& v) {
    const Eye eye(v);
    for (const panel::Hit& hit : p.hits) {
        ImVec2 at;
        if (!eye.sees(hit.at, at)) continue;
        const float radius = std::max(eye.pixels(hit.at, 0.02f + 0.03f * hit.speed), 2.0f);
        ImGui::GetBackgroundDrawList()->AddCircle(at, radius, IM_COL32(255, 90, 60, 230 - 11 * hit.age), 0, 1.5f);
    }
}

bool begin_window(const char* title, float x, float y, float pivot, float width, float height) {
    ImGui::SetNextWindowPos(ImVec2(x, y), ImGuiCond_Always, ImVec2(pivot, 0.0f));
    ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0.0f), ImVec2(width, height));
    return ImGui::Begin(title, nullptr,
                        ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_AlwaysAutoResize |
                            ImGuiWindowFlags_NoSavedSettings);
}

void section(panel& p, viewer& v, const char* title, bool open, void (*show)(panel&, viewer&)) {
    const bool shown = ImGui::CollapsingHeader(title, open ? ImGuiTreeNodeFlags_DefaultOpen : 0);
    placed(p, title);
    if (!shown) return;
    ImGui::PushID(title);
    show(p, v);
    ImGui::PopID();
}

void build(panel& p, viewer& v) {
    p.places.clear();
    if (!v.show_overlay) return;
    const scene_report r = scene_look(v.scene, 0);
    const float letter = ImGui::GetFontSize(), edge = 0.8f * letter, w = static_cast<float>(v.picture.width);
    const float tall = static_cast<float>(v.picture.height) - 2.0f * edge;
    draw_hits(p, v);
    if (v.followed.id) {
        const Followed body = followed(v);
        if (body.there) frame_body(v, body);
    }
    if (begin_window("Scene", edge, edge, 0.0f, 22.5f * letter, tall)) {
        show_plan(p, v);
        section(p, v, "wind", true, show_wind);
        section(p, v, "bodies and time", true, show_bodies);
        section(p, v, "material", false, show_material);
        section(p, v, "emitter", false, show_emitter);
        section(p, v, "history", false, [](panel& q, viewer& u) { show_history(q, u, scene_look(u.scene, 0).time); });
        section(p, v, "keys", false, [](panel&, viewer&) {
            ImGui::TextUnformatted("drag: turn   right: shift   wheel: zoom\nclick a body: follow it   f: let it go\n"
                                   "space: pause   n: step   r: restart\n1 - 7: scenes   c: camera back\n"
                                   "a: wind   t: paths   p: picture\nh: hide all this   q: end");
        });
    }
    ImGui::End();
    if (begin_window("Numbers", w - edge, edge, 1.0f, 20.0f * letter, tall)) {
        show_graphs(p, v, r);
        if (v.followed.id) section(p, v, "body", true, show_body);
    }
    ImGui::End();
}

void begin_frame(panel& p, viewer& v, float seconds) {
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = ImVec2(static_cast<float>(v.picture.width), static_cast<float>(v.picture.height));
    io.DeltaTime = seconds;
    const int scale = std::clamp(v.picture.height / 600, 1, 4);
    if (scale != p.scale) { // letters are sharp at whole sizes
        p.scale = scale;
        ImFontConfig font;
        font.SizePixels = 13.0f * static_cast<float>(scale);
        io.Fonts->Clear();
        io.Fonts->AddFontDefault(&font);
        ImGui::GetStyle() = ImGuiStyle();
        ImGui::StyleColorsDark();
        ImGui::GetStyle().ScaleAllSizes(static_cast<float>(scale));
        ImGui::GetStyle().WindowRounding = 4.0f;
        ImGui::GetStyle().Colors[ImGuiCol_WindowBg].w = 0.78f;
        if (p.drawn) ImGui_ImplOpenGL3_DestroyDeviceObjects();
        p.drawn = false;
    }
    if (!p.drawn) ImGui_ImplOpenGL3_CreateDeviceObjects();
    p.drawn = true;
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
}

// A frame that is not drawn: parts see the pointer and the keys.
void pass_frames(panel& p, viewer& v, int number) {
    for (; number > 0; --number) {
        begin_frame(p, v, 1e-3f);
        build(p, v);
        ImGui::EndFrame();
    }
}
} // namespace

panel* panel_create() {
    auto* const p = new panel;
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.BackendPlatformName = "viewer";
    const std::pair<ImGuiKey, int> keys[] = {{ImGuiKey_Tab, key_tab},
                                             {ImGuiKey_LeftArrow, key_left},
                                             {ImGuiKey_RightArrow, key_right},
                                             {ImGuiKey_UpArrow, key_up},
                                             {ImGuiKey_DownArrow, key_down},
                                             {ImGuiKey_Enter, key_enter},
                                             {ImGuiKey_Escape, key_escape},
                                             {ImGuiKey_Backspace, key_back},
                                             {ImGuiKey_Delete, key_delete},
                                             {ImGuiKey_End, key_end},
                                             {ImGuiKey_A, 'a'}};
    for (const auto& [theirs, ours] : keys) io.KeyMap[theirs] = ours;
    if (!ImGui_ImplOpenGL3_Init("#version 330 core")) fail("install libgl1", "Dear ImGui found no OpenGL");
    return p;
}

void panel_free(panel* p) {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext(p->context);
    delete p;
}

int panel_handle(viewer* v, const event* e) {
    ImGuiIO& io = ImGui::GetIO();
    const bool key = e->kind == event_key || e->kind == event_text;
    if (!v->show_overlay || v->picture.height == 0 || (key && !io.WantTextInput)) return 0;
    io.KeyShift = e->shift != 0, io.KeyCtrl = e->control != 0;
    if (e->kind == event_press || e->kind == event_release || e->kind == event_move) io.MousePos = ImVec2(e->x, e->y);
    // A part must have been under the pointer before it can be pressed; new windows find their size and place in two frames.
    if (e->kind == event_press) pass_frames(*v->panel, *v, 2);
    if (e->kind == event_press) io.MouseDown[e->button] = true;
    if (e->kind == event_release) io.MouseDown[e->button] = false;
    if (e->kind == event_scroll) io.MouseWheel = e->notches;
    if (e->kind == event_key) io.KeysDown[e->key] = true;
    if (e->kind == event_text) io.AddInputCharacter(e->letter);
    // A frame for each event: a press and a release in one frame would be lost.
    pass_frames(*v->panel, *v, 1);
    if (e->kind == event_key) io.KeysDown[e->key] = false;
    return key || io.WantCaptureMouse;
}

void panel_note(viewer* v) {
    Graph(&g)[graph_number] = v->panel->graphs;
    lr_timings t;
    check(lr_timings_init(&t, sizeof t), "lr_timings_init", nullptr);
    check(lr_world_get_timings(v->scene->world, &t), "timings", nullptr);
    const scene_report r = scene_look(v->scene, 0);
    const Means means = means_of(*v->scene);
    const double values[graph_number] = {1e3 * v->scene->stepping,
                                         1e3 * t.motion,
                                         1e3 * t.wind,
                                         1e3 * t.body_contact,
                                         1e3 * t.colliders,
                                         1e3 * t.wake,
                                         1e3 * t.emit_and_rules,
                                         1e3 * t.events,
                                         static_cast<double>(r.awake),
                                         static_cast<double>(note_hits(*v->panel, *v)),
                                         means.speed,
                                         means.energy};
    for (int k = 0; k < graph_number; ++k) g[k].note(values[k]);
    history_note(&v->history, v->scene->world, r.time);
}

void panel_forget(viewer* v) {
    history_clear(&v->history);
    v->panel->hits.clear();
}

void panel_draw(viewer* v) {
    if (!(v->frame_seconds > 0.0)) pass_frames(*v->panel, *v, 2);
    begin_frame(*v->panel, *v, v->frame_seconds > 0.0 ? static_cast<float>(v->frame_seconds) : 1.0f / 60.0f);
    build(*v->panel, *v);
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void panel_print_places(const panel* p) {
    for (const panel::Place& place : p->places)
        std::printf("place %.0f %.0f %.0f %.0f %s\n", double(place.low.x), double(place.low.y), double(place.high.x),
                    double(place.high.y), place.name.c_str());
}
