#!/usr/bin/env python3
"""Runs the viewer like a user: pictures, films, keys and mouse, messages.    usage: check_viewer.py BUILD_DIR ROOT
BUILD_DIR: of the samples; ROOT: of the project. Needs EGL; tests a window only with Xvfb and xdotool.
SPDX-License-Identifier: MIT"""
import concurrent.futures
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile

import viewer_window
from check_leaf_storm import pixels

WIDTH, HEIGHT = 320, 180
SIZE = ["--size", f"{WIDTH}x{HEIGHT}"]
PANEL = ["--size", "960x600"]  # room for all of it
SCENES = ["leaf", "paper", "petals", "confetti", "planes", "water", "flight"]


def run(*arguments, code=0, env=None):
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=120, env=env)
    assert "langevin_rigid:" not in done.stderr, f"{arguments}: {done.stderr}"  # the library's warnings
    assert done.returncode == code, f"{arguments}: exit code {done.returncode}, not {code}\n{done.stdout}{done.stderr}"
    return done


class Report:
    """The viewer's final report."""

    def __init__(self, text):
        said = re.search(r"scene (\w+): (\d+) pictures, t = ([\d.]+) s, (\d+) bodies, (\d+) asleep, lowest (\S+) m, hash (\w+)\n"
                         r"camera (\S+),(\S+),(\S+) target (\S+),(\S+),(\S+)( following)?( paused)?\n(.*)\n", text)
        assert said, text
        self.scene, self.pictures, self.time = said[1], int(said[2]), float(said[3])
        self.bodies, self.at_rest, self.lowest, self.hash = int(said[4]), int(said[5]), float(said[6]), said[7]
        self.azimuth, self.elevation, self.distance = (float(said[i]) for i in (8, 9, 10))
        self.target = [float(said[i]) for i in (11, 12, 13)]
        self.following, self.paused = bool(said[14]), bool(said[15])
        self.settings = dict(item.split(" ", 1) for item in said[16].split(", "))


def shoot(path, *arguments):
    """A picture and the report."""
    report = Report(run(*SIZE, "--png", path, *arguments).stdout)
    rows = pixels(path)
    assert len(rows) == HEIGHT and len(rows[0]) == 3 * WIDTH
    return rows, report


def differing(a, b, box=(0, 0, WIDTH, HEIGHT)):
    """The number of different pixels in a box."""
    left, top, right, bottom = box
    return sum(a[y][3 * x:3 * x + 3] != b[y][3 * x:3 * x + 3] for y in range(top, bottom) for x in range(left, right))


def brightness(rows, x, y, reach=2):
    values = [sum(rows[j][3 * i:3 * i + 3]) for j in range(y - reach, y + reach + 1) for i in range(x - reach, x + reach + 1)]
    return sum(values) / len(values)


def pixel_of(point, azimuth, elevation, distance, target):
    """A point's place in the picture, as in camera.c."""
    a, e = math.radians(azimuth), math.radians(elevation)
    back = (math.cos(e) * math.sin(a), math.sin(e), math.cos(e) * math.cos(a))
    right = (math.cos(a), 0.0, -math.sin(a))
    up = (back[1] * right[2] - back[2] * right[1], back[2] * right[0] - back[0] * right[2], back[0] * right[1] - back[1] * right[0])
    d = [point[i] - target[i] - distance * back[i] for i in range(3)]
    depth, tan_half = -sum(d[i] * back[i] for i in range(3)), math.tan(0.36)
    x = sum(d[i] * right[i] for i in range(3)) / (depth * tan_half * WIDTH / HEIGHT)
    y = sum(d[i] * up[i] for i in range(3)) / (depth * tan_half)
    return round(0.5 * (1 + x) * WIDTH), round(0.5 * (1 - y) * HEIGHT)


def check_scenes(path):
    for scene in SCENES:
        rows, report = shoot(path("s.png"), "--scene", scene, "--count", 600, "--seconds", 2, "--no-overlay")
        assert report.scene == scene and report.bodies > 20 and abs(report.time - 2) < 1e-4
        assert report.lowest > -0.0005, f"{scene}: a body is {report.lowest} m above the ground"
        colours = {row[3 * x:3 * x + 3] for row in rows for x in range(WIDTH)}
        assert len(colours) > 3000, f"{scene}: {len(colours)} colours"
        sky, ground = (sum(sum(row) for row in part) for part in (rows[:20], rows[-20:]))
        assert sky > 0.5 * ground, scene
    # Leaves land, and lying leaves are visible on the former grass.
    camera = ["--camera", "0,35,2.5", "--target", "0,0,0.6", "--no-overlay", "--count", 2500]
    early, _ = shoot(path("e.png"), "--seconds", 0, *camera)
    rows, late = shoot(path("l.png"), "--seconds", 8, *camera)
    assert late.at_rest > 200 and late.lowest > -0.0005, vars(late)
    changed = differing(early, rows, (0, 90, WIDTH, HEIGHT))
    assert changed > 0.06 * WIDTH * 90, changed


def check_shadows(path):
    # The box of scene paper from above: points on either side of it, towards the sun and away, half a metre from its middle.
    view = {"azimuth": 0, "elevation": 80, "distance": 3.5, "target": (0.85, 0, -0.7)}
    arguments = ["--scene", "paper", "--no-overlay", "--camera", "0,80,3.5", "--target", "0.85,0,-0.7"]
    alone, report = shoot(path("a.png"), *arguments, "--count", 1, "--seconds", 0)
    assert report.target == [0.85, 0.0, -0.7]
    sun = (-0.4794, -0.5793)
    away = 0.48 / math.hypot(*sun)
    lit, dark = (brightness(alone, *pixel_of((0.85 + s * away * sun[0], 0, -0.7 + s * away * sun[1]), **view)) for s in (1, -1))
    assert dark < 0.65 * lit, (dark, lit)
    # Sheets are brighter than boards: much darker pixels lie in their shadows.
    crowd, report = shoot(path("b.png"), *arguments, "--count", 500, "--seconds", 2)
    darker = sum(sum(crowd[y][3 * x:3 * x + 3]) < 0.65 * sum(alone[y][3 * x:3 * x + 3]) for y in range(HEIGHT) for x in range(WIDTH))
    assert report.bodies > 50 and 60 < darker < 0.3 * WIDTH * HEIGHT, (darker, vars(report))


def check_pictures(path):
    scene = ["--count", 800, "--seed", 4]
    rows, first = shoot(path("1.png"), *scene, "--seconds", 122 / 60)
    with open(path("1.png"), "rb") as file:
        bytes_of_first = file.read()
    again = run(*SIZE, "--png", path("1.png"), *scene, "--seconds", 122 / 60)
    with open(path("1.png"), "rb") as file:
        assert file.read() == bytes_of_first, "the same arguments, another picture"
    assert Report(again.stdout).hash == first.hash
    other, report = shoot(path("2.png"), "--count", 800, "--seed", 5, "--seconds", 122 / 60)
    assert report.hash != first.hash and differing(rows, other) > 300
    assert Report(run(*SIZE, "--png", path("2.png"), *scene, "--seconds", 122 / 60, "--threads", 3).stdout).hash == first.hash
    # A film: numbered pictures; the second equals the picture at its time.
    done = Report(run(*SIZE, *scene, "--seconds", 2, "--frames", 3, "--png", path("f_%02d.png")).stdout)
    assert done.pictures == 3 and sorted(n for n in os.listdir(path("")) if n.startswith("f_")) == [f"f_{i:02d}.png" for i in range(3)]
    film = [pixels(path(f"f_{i:02d}.png")) for i in range(3)]
    assert film[1] == rows
    assert min(differing(film[0], film[1]), differing(film[1], film[2])) > 200
    # The panel covers a part of the picture, and the rest is unchanged.
    bare, _ = shoot(path("3.png"), *scene, "--seconds", 122 / 60, "--no-overlay")
    hidden, _ = shoot(path("3.png"), *scene, "--seconds", 122 / 60, "--press", "1:h")
    assert hidden == bare
    run(*PANEL, "--png", path("3.png"), *scene, "--seconds", 0.5)
    run(*PANEL, "--png", path("4.png"), *scene, "--seconds", 0.5, "--no-overlay")
    shown, bare = pixels(path("3.png")), pixels(path("4.png"))
    assert differing(shown, bare, (20, 20, 250, 300)) > 30000 and differing(shown, bare, (320, 160, 680, 600)) == 0
    # Arrows in wind, none without wind; trails.
    still = [*scene, "--seconds", 1, "--no-overlay", "--wind", 0, "--gusts", 0, "--turbulence", 0]
    assert shoot(path("4.png"), *still)[0] == shoot(path("5.png"), *still, "--arrows")[0]
    windy = [*scene, "--seconds", 1, "--no-overlay", "--wind", 4]
    for more in ("--arrows", "--trails"):
        assert differing(shoot(path("4.png"), *windy)[0], shoot(path("5.png"), *windy, more)[0]) > 300, more


def places(*arguments):
    """The middles of the panel's parts, relative to the picture."""
    wide, tall = (int(n) for n in PANEL[1].split("x"))
    said = run(*PANEL, *arguments, "--places").stdout
    found = re.findall(r"^place (\S+) (\S+) (\S+) (\S+) (.*)$", said, re.M)
    return {name: ((float(l) + float(r)) / 2 / wide, (float(t) + float(b)) / 2 / tall, float(l) / wide, float(r) / wide)
            for l, t, r, b, name in found}


def check_panel(path):
    scene = ["--count", 400, "--png", path("k.png"), "--seconds", 2]
    closed = places(*scene)

    def click(name, time=1, among=closed):
        return f"{time}:click@{among[name][0]:.4f}/{among[name][1]:.4f}"

    def after(press, *more):
        return Report(run(*PANEL, *scene, "--press", press, *more).stdout)

    # Sliders: a click in the middle, a drag beyond the end; numbers that are typed; the way back.
    x, y, left, right = closed["wind slider"]
    assert abs(float(after("0.5:click@0.5/0.9," + click("wind slider")).settings["wind"].split()[0]) - 6) < 0.3
    assert after(f"1:drag@{x}/{y}/{right + 0.1}/{y}").settings["wind"] == "12.00 m/s"
    assert after(f"1:drag@{x}/{y}/{left - 0.01}/{y}").settings["wind"] == "0.00 m/s"
    typed = click("wind number") + ",1:type@3.25,1:enter"
    assert after(typed).settings["wind"] == "3.25 m/s" and after(typed).hash != after("1:h").hash
    assert after(click("wind number") + ",1:type@99,1:enter").settings["wind"] == "12.00 m/s"
    assert after(click("wind number") + ",1:type@q,1:escape").time > 1.99  # letters that are typed are no keys
    changed = places(*scene, "--press", typed)
    assert after(typed + "," + click("wind reset", 1.5, changed)).settings["wind"] == "1.50 m/s"
    many = after(click("bodies number", 0.2) + ",0.2:type@2500,0.2:enter")
    assert many.settings["bodies"] == "2500" and many.bodies > after("1:h").bodies
    assert after(click("contact")).settings["contact"] == "yes"
    # Lists.
    opened = places(*scene, "--press", click("loads"))
    other = after(click("loads") + "," + click("langevin", 1.1, opened))
    assert other.settings["loads"] == "langevin" and other.hash != after("1:h").hash and other.bodies > 30
    opened = places(*scene, "--press", click("scene"))
    other = after(click("scene") + "," + click("petals", 1.5, opened))
    assert other.scene == "petals" and other.time < 0.51
    # The mouse on the panel does not turn the camera, and the wheel does not zoom.
    plain = after("1:h")
    x, y = closed["show paths"][:2]
    over = after(f"1:drag@{x}/{y}/{x + 0.01}/{y + 0.01},1.1:scroll@5")
    assert (over.azimuth, over.distance) == (plain.azimuth, plain.distance)
    assert after(click("pause")).paused and abs(after(click("pause") + "," + click("step", 1.5)).time - 1 - 1 / 60) < 1e-4
    assert after(click("restart")).time < 1.01
    # Hits are seen, and change nothing.
    run(*PANEL, *scene)
    without = pixels(path("k.png"))
    assert after(click("show hits")).hash == plain.hash
    assert differing(without, pixels(path("k.png")), (320, 160, 680, 600)) > 20
    # Materials and emitters act on the world.
    for section, part, value in (("material", "friction number", "1.5"), ("emitter", "height number", "6")):
        opened = places(*scene, "--press", click(section, 0))
        done = after(click(section, 0) + "," + click(part, 0.2, opened) + f",0.2:type@{value},0.2:enter", "--seconds", 4)
        assert done.hash != after("1:h", "--seconds", 4).hash, section
    # Time turned back: then everything happens again, bit by bit.
    opened = places(*scene, "--press", click("history", 0))
    keep = click("history", 0) + "," + click("keep", 0.1, opened)
    x, y, left, right = places(*scene, "--press", keep)["return"]
    back = keep + f",1.5:drag@{x}/{y}/{left}/{y}"
    returned = after(back)
    assert returned.paused and returned.time < 0.3, vars(returned)
    again = after(back + ",1.5:space", "--seconds", 1.5 + 2 - returned.time)
    assert abs(again.time - plain.time) < 1e-4 and again.hash == plain.hash, (vars(again), vars(plain))
    # Recordings are replayed to the same bits.
    with open(os.path.join(BUILD, "CMakeCache.txt"), encoding="utf-8") as file:
        tools = os.path.dirname(re.search(r"^LR_BAKE:FILEPATH=(.*)$", file.read(), re.M)[1])
    record = click("history", 0) + "," + click("record", 0.5, opened) + "," + click("record", 1.5, opened)
    done = subprocess.run([PROGRAM, *map(str, [*PANEL, *scene, "--press", record])], cwd=path(""), capture_output=True, text=True, timeout=60)
    assert done.returncode == 0 and "recording viewer_001.lrr" in done.stdout, done.stdout + done.stderr
    replayed = subprocess.run([os.path.join(tools, "lr_replay"), path("viewer_001.lrr")], capture_output=True, text=True, timeout=60)
    assert replayed.returncode == 0, replayed.stdout + replayed.stderr


def check_keys(path):
    def after(press, *more, scene="leaf"):
        return Report(run(*SIZE, "--png", path("k.png"), "--scene", scene, "--count", 400, "--seconds", 2, "--press", press, *more).stdout)

    done = after("1:space")
    assert done.paused and abs(done.time - 1) < 1e-4
    done = after("1:space,1.2:n*1,1.4:n,1.5:period")
    assert done.paused and abs(done.time - 1 - 3 / 60) < 1e-4, done.time
    assert after("1.5:3").scene == "petals" and after("1.5:3").time < 0.51
    assert after("1.5:r").time < 0.51
    plain = after("0:h")
    turned = after("0:h,1:drag@0.85/0.5/0.95/0.6")
    assert turned.azimuth < plain.azimuth - 10 and turned.elevation > plain.elevation + 10
    assert after("0:h,1:scroll@5").distance < 0.6 * plain.distance
    assert after("0:h,1:drag@0.85/0.5/0.95/0.6,1.5:c").azimuth == plain.azimuth
    # Some of many clicks hit a body, and the camera follows it.
    clicks = "0.5:h," + ",".join(f"1:click@{0.5 + 0.05 * i}/{0.2 + 0.1 * k}" for i in range(6) for k in range(6))
    followed = after(clicks, "--count", 6000, scene="confetti")
    assert followed.following and math.dist(followed.target, after("1:h", scene="confetti").target) > 0.05
    assert not after(clicks + ",1.5:f", "--count", 6000, scene="confetti").following
    assert after("1:q").time <= 1.0001 and after("1:escape").pictures == 0
    with_p = subprocess.run([PROGRAM, *SIZE, "--png", path("k.png"), "--seconds", "0.2", "--press", "0.1:p"], cwd=path(""),
                            capture_output=True, text=True, timeout=60)
    assert with_p.returncode == 0 and len(pixels(path("viewer_001.png"))) == HEIGHT


def check_own(path, baked, meshes):
    for more in ([], ["--mesh", f"{meshes}/leaf.obj"]):
        rows, report = shoot(path("o.png"), "--asset", f"{baked}/leaf.lrb", *more, "--count", 300, "--seconds", 1, "--no-overlay")
        assert report.bodies > 10 and len({row[3 * x:3 * x + 3] for row in rows for x in range(WIDTH)}) > 3000
    two = Report(run(*SIZE, "--png", path("o.png"), "--asset", f"{baked}/leaf.lrb", "--mesh", f"{meshes}/leaf.obj",
                     "--asset", f"{baked}/petal.lrb", "--count", 300, "--seconds", 1).stdout)
    assert two.bodies > 10


def check_ffmpeg(path):
    """A stand-in for ffmpeg that stores its input."""
    folder = path("bin")
    os.mkdir(folder)
    tool = os.path.join(folder, "ffmpeg")
    with open(tool, "w", encoding="ascii") as file:
        file.write('#!/bin/sh\necho "$@" >"$FFMPEG_TOLD"\nfor last; do :; done\ncat >"${last#file:}"\n')
    os.chmod(tool, 0o755)
    env = {**os.environ, "PATH": folder + ":" + os.environ["PATH"], "FFMPEG_TOLD": path("told")}
    film = [*SIZE, "--count", 300, "--seconds", 1, "--frames", 2, "--fps", 20, "--png", path("film.mp4")]
    run(*film, env=env)
    with open(path("film.mp4"), "rb") as file:
        sent = file.read()
    with open(path("told"), encoding="ascii") as file:
        told = file.read().split()
    assert told[told.index("-s") + 1] == f"{WIDTH}x{HEIGHT}" and told[told.index("-r") + 1] == "20"
    rows, _ = shoot(path("m.png"), "--count", 300, "--seconds", 1)
    assert len(sent) == 2 * 3 * WIDTH * HEIGHT and sent[:3 * WIDTH * HEIGHT] == b"".join(rows)
    with open(tool, "w", encoding="ascii") as file:
        file.write("#!/bin/sh\ncat >/dev/null\nexit 3\n")
    assert "ffmpeg could not make" in run(*film, env=env, code=2).stderr
    os.remove(tool)
    assert "install ffmpeg" in run(*film, env={**env, "PATH": folder}, code=2).stderr


def check_messages(path, baked, meshes):
    out = run("--help").stdout
    assert "--scene" in out and "--press" in out
    shot = ["--png", path("x.png"), "--seconds", 0]
    for bad in (["--what"], ["--scene", "sea"], ["--scene"], ["--count", "0", *shot], ["--count", "1.5", *shot], ["--count"],
                ["--wind", "nan", *shot], ["--wind", "1,2", *shot], ["--size", "10x10", *shot], ["--size", "320", *shot],
                ["--model", "newton", *shot], ["--substeps", "0", *shot], ["--time-scale", "0", *shot], ["--threads", "99", *shot],
                ["--camera", "1,2", *shot], ["--camera", "0,89,1", *shot], ["--target", "1,x,2", *shot], ["--frames", 3],
                ["--frames", 3, "--png", path("x.png")], ["--frames", 3, "--png", path("%d%s.png")], ["--png", path("x%d.png")],
                ["--png", path("x.jpg"), "--seconds", 0], ["--frames", 3, "--png", path("x%d.jpg")],
                ["--fps", 7, *shot], ["--frames", 2, "--window", "--png", path("x%d.png")], ["--mesh", f"{meshes}/leaf.obj", *shot],
                ["--press", "space", *shot], ["--press", "1:jump", *shot], ["--press", "2:a,1:a", *shot], ["--press", "1:a*0", *shot],
                ["--seconds", "-1", *shot], ["--seed", "x", *shot]):
        said = run(*bad, code=1).stderr
        assert "what to do" in said and said.startswith("viewer: "), (bad, said)
    with open(path("bad.lrb"), "wb") as file:
        file.write(b"no asset")
    broken = {"empty.obj": "# nothing\n", "far.obj": "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", "word.obj": "v 0 zero 0\n",
              "line.obj": "v 0 0 0\nv 1 0 0\nf 1 2\n", "point.obj": "v 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 2 3\n"}
    for name, text in broken.items():
        with open(path(name), "w", encoding="ascii") as file:
            file.write(text)
    own = ["--asset", f"{baked}/leaf.lrb", *shot]
    for bad in (["--asset", path("none.lrb"), *shot], ["--asset", path("bad.lrb"), *shot], ["--baked", path("none"), *shot],
                ["--meshes", path("none"), *shot], ["--png", path("none/x.png"), "--seconds", 0], ["--png", path(""), "--seconds", 0],
                ["--png", "/dev/full", "--seconds", 0, *SIZE], *([*own, "--mesh", path(name)] for name in broken if name != "point.obj"),
                [*own, "--mesh", path("none.obj")]):
        said = run(*bad, code=2).stderr
        assert "what to do" in said, (bad, said)
    assert not [name for name in os.listdir(path("")) if ".part-" in name]
    env = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
    said = run(env=env, code=2).stderr
    assert "--png FILE" in said, said


def main(build, root):
    baked, meshes = os.path.join(build, "viewer_assets"), os.path.join(root, "assets")
    def apart(check, *more):
        """Runs a check with a folder of its own."""
        with tempfile.TemporaryDirectory() as folder:
            return check(lambda name: os.path.join(folder, name), *more)

    def check_window(path):
        return viewer_window.check(PROGRAM, path("window.png"), Report,
                                   places("--scene", "petals", "--count", 300, "--png", path("k.png"), "--seconds", 1))

    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        checks = [(check_panel,), (check_pictures,), (check_keys,), (check_scenes,), (check_messages, baked, meshes), (check_shadows,),
                  (check_own, baked, meshes), (check_ffmpeg,)]  # longest first
        for done in [pool.submit(apart, *check) for check in checks]:
            done.result()
    window = apart(check_window)
    print(f"viewer is right{'' if window else ', without a window'}")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    BUILD = sys.argv[1]
    PROGRAM = os.path.abspath(os.path.join(sys.argv[1], "viewer"))
    main(sys.argv[1], sys.argv[2])
