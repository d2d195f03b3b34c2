"""The viewer in a window: an X server without a screen, and keys and a mouse made by xdotool.    SPDX-License-Identifier: MIT"""
import os
import shutil
import subprocess
import time

from check_leaf_storm import pixels


def missing(program):
    """A missing tool and how to install it; or None."""
    for tool, package in (("Xvfb", "xvfb"), ("xdotool", "xdotool")):
        if not shutil.which(tool):
            return f"{tool}: apt-get install {package}"
    help_text = subprocess.run([program, "--help"], capture_output=True, text=True, check=True).stdout
    return "GLFW: apt-get install libglfw3-dev, and build again" if "built without windows" in help_text else None


def start_server():
    """An X server on a free display, which it reports itself."""
    ours, its = os.pipe()
    server = subprocess.Popen(["Xvfb", "-displayfd", str(its), "-screen", "0", "1280x800x24", "-nolisten", "tcp"], pass_fds=[its],
                              stderr=subprocess.DEVNULL)
    os.close(its)
    with os.fdopen(ours) as pipe:
        number = pipe.readline().strip()
    assert number, "Xvfb has not started"
    return server, ":" + number


def play(program, picture, display, places):
    """Keys and mouse like a user's; checks the viewer's final report."""
    env = {**os.environ, "DISPLAY": display}

    def tool(*arguments):
        return subprocess.run(["xdotool", *map(str, arguments)], env=env, capture_output=True, text=True, timeout=60).stdout.strip()

    viewer = subprocess.Popen([program, "--window", "--scene", "petals", "--count", "300", "--size", "960x600", "--png", picture],
                              env=env, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    try:
        window, until = "", time.monotonic() + 60
        while not window and time.monotonic() < until and viewer.poll() is None:
            time.sleep(0.2)
            window = tool("search", "--name", "Langevin Rigid").split("\n")[0]
        assert window, f"no window within 60 s\n{viewer.communicate()[1] if viewer.poll() is not None else ''}"
        tool("windowfocus", "--sync", window)
        time.sleep(1.0)  # a picture or two
        x, y, _, right = places["wind number"]
        tool("mousemove", "--window", window, round(960 * x), round(600 * y), "click", 1)
        time.sleep(0.5)
        tool("type", "3.25")
        tool("key", "Return")
        x, y, _, right = places["gusts slider"]
        tool("mousemove", "--window", window, round(960 * x), round(600 * y), "mousedown", 1)
        tool("mousemove", "--window", window, round(960 * right + 20), round(600 * y))
        tool("mouseup", 1)
        tool("mousemove", "--window", window, 600, 400, "mousedown", 1)
        for x in (620, 650, 680):
            tool("mousemove", "--window", window, x, 410)
        tool("mouseup", 1)
        tool("click", 4)  # the wheel
        tool("key", "a", "space", "q")
        out, errors = viewer.communicate(timeout=60)
    finally:
        if viewer.poll() is None:
            viewer.kill()
            viewer.wait()
    assert viewer.returncode == 0, errors
    return out


def check(program, picture, report_of, places):
    """Returns whether a window was checked."""
    want = missing(program)
    if want:
        print(f"SKIPPED: the viewer in a window, for want of {want}")
        return False
    server, display = start_server()
    try:
        early = subprocess.run([program, "--window", "--scene", "petals", "--count", "300", "--seconds", "0.5", "--press", "0:click@0.7/0.5"],
                               env={**os.environ, "DISPLAY": display}, capture_output=True, text=True, timeout=60)
        assert early.returncode == 0 and not early.stderr, f"a click before the first picture: {early.stderr}"
        report = report_of(play(program, picture, display, places))
    finally:
        server.terminate()
        server.wait()
    assert report.scene == "petals" and report.pictures > 0 and report.bodies > 0 and 0 < report.time
    assert report.settings["wind"] == "3.25 m/s" and report.settings["gusts"] == "4.0 m/s", report.settings
    assert report.paused and report.azimuth < 14.0 and report.distance < 0.9, vars(report)
    rows = pixels(picture)
    assert len(rows) == 600 and len({row[3 * x:3 * x + 3] for row in rows for x in range(960)}) > 3000
    return True
