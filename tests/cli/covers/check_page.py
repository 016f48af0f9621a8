"""Opens a customer's page in a headless Chromium (package chromium-driver), turns it by mouse and by finger, switches its
colourways, shows seams and measures, and looks whether the picture follows.

    check_page.py PAGE.html [FOLDER_FOR_PICTURES]
"""
import base64
import json
import pathlib
import shutil
import socket
import struct
import subprocess
import sys
import time
import urllib.request
import zlib

ARGUMENTS = ["--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--use-angle=swiftshader",
             "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist", "--window-size=1200,900"]
ELEMENT = "element-6066-11e4-a52e-4f735466cecf"


def call(method, address, body=None):
    data = json.dumps(body if body is not None else {}).encode() if method == "POST" else None
    request = urllib.request.Request(address, data, {"Content-Type": "application/json"}, method=method)
    try:
        with urllib.request.urlopen(request, timeout=180) as answer:
            return json.load(answer)["value"]
    except urllib.error.HTTPError as error:
        raise SystemExit(f"{method} {address}: {error.read().decode()[:500]}") from error


class Browser:
    def __init__(self, address, arguments, mobile=None):
        options = {"args": ARGUMENTS + arguments}
        if mobile:
            options["mobileEmulation"] = mobile
        chromium = shutil.which("chromium")
        if chromium:
            options["binary"] = chromium
        wanted = {"capabilities": {"alwaysMatch": {"goog:chromeOptions": options,
                                                   "goog:loggingPrefs": {"browser": "ALL"}}}}
        self.at = f"{address}/session/" + call("POST", f"{address}/session", wanted)["sessionId"]

    def open(self, path):
        call("POST", self.at + "/url", {"url": path.absolute().as_uri()})
        for _ in range(600):
            if self.run("return document.documentElement.dataset.ready") == "yes":
                return
            time.sleep(0.1)
        raise SystemExit(f"the page is never ready: {self.log()}")

    def run(self, script):
        return call("POST", self.at + "/execute/sync", {"script": script, "args": []})

    def log(self):
        return call("POST", self.at + "/se/log", {"type": "browser"})

    def click(self, selector):
        found = call("POST", self.at + "/element", {"using": "css selector", "value": selector})
        call("POST", f"{self.at}/element/{found[ELEMENT]}/click")

    def drag(self, kind, places):
        """By a pointer that goes through these places."""
        moves = [{"type": "pointerMove", "duration": 0, "x": places[0][0], "y": places[0][1]},
                 {"type": "pointerDown", "button": 0}]
        moves += [{"type": "pointerMove", "duration": 80, "x": x, "y": y} for x, y in places[1:]]
        moves.append({"type": "pointerUp", "button": 0})
        call("POST", self.at + "/actions", {"actions": [
            {"type": "pointer", "id": kind, "parameters": {"pointerType": kind}, "actions": moves}]})

    def picture(self, name, folder):
        """What is seen, once it has settled."""
        self.run("return new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => done(1))))")
        time.sleep(0.3)
        png = base64.b64decode(call("GET", self.at + "/screenshot"))
        if folder:
            (folder / f"{name}.png").write_bytes(png)
        return pixels(png)

    def quit(self):
        call("DELETE", self.at)


def pixels(png):
    """Rows of red, green, blue from an 8-bit PNG without interlace."""
    width, height, _, kind = struct.unpack(">IIBB", png[16:26])
    channels = {2: 3, 6: 4}[kind]
    at, packed = 8, b""
    while at < len(png):
        size, name = struct.unpack(">I4s", png[at:at + 8])
        packed += png[at + 8:at + 8 + size] if name == b"IDAT" else b""
        at += 12 + size
    data, rows, before = zlib.decompress(packed), [], bytearray(width * channels)
    for y in range(height):
        start = y * (width * channels + 1)
        row, filtering = bytearray(data[start + 1:start + 1 + width * channels]), data[start]
        for i in range(len(row)):
            left = row[i - channels] if i >= channels else 0
            up, corner = before[i], before[i - channels] if i >= channels else 0
            if filtering == 1:
                row[i] = (row[i] + left) & 255
            elif filtering == 2:
                row[i] = (row[i] + up) & 255
            elif filtering == 3:
                row[i] = (row[i] + (left + up) // 2) & 255
            elif filtering == 4:
                p = left + up - corner
                best = min((abs(p - left), 0, left), (abs(p - up), 1, up), (abs(p - corner), 2, corner))
                row[i] = (row[i] + best[2]) & 255
        rows.append([tuple(row[channels * x:channels * x + 3]) for x in range(width)])
        before = row
    return rows


def inner(rows):
    """The middle of the picture, where the model is and no button."""
    height, width = len(rows), len(rows[0])
    return [p for row in rows[height // 4:3 * height // 4] for p in row[width // 4:3 * width // 4]]


def changed(a, b):
    """The share of pixels in the middle that differ by more than a little."""
    pairs = list(zip(inner(a), inner(b)))
    return sum(max(abs(p[k] - q[k]) for k in range(3)) > 12 for p, q in pairs) / len(pairs)


def mean(rows):
    found = inner(rows)
    return [sum(p[k] for p in found) / len(found) for k in range(3)]


def expect(good, what):
    print(("ok: " if good else "WRONG: ") + what)
    if not good:
        expect.failed = True


expect.failed = False


def look(browser, page, folder, touch, name):
    browser.open(page)
    first = browser.picture(f"{name}-first", folder)
    height, width = len(first), len(first[0])
    colours = len(set(inner(first)))
    expect(colours > 200, f"the cover is seen ({colours} colours)")
    middle = browser.run("return [innerWidth / 2, innerHeight / 2]")
    x, y = int(middle[0]), int(middle[1])
    browser.drag("touch" if touch else "mouse", [(x, y), (x + 40, y), (x + 120, y + 10)])
    turned = browser.picture(f"{name}-turned", folder)
    expect(changed(first, turned) > 0.05, f"it turns ({changed(first, turned):.2f})")
    browser.click("#home")
    home = browser.picture(f"{name}-home", folder)
    expect(changed(first, home) < 0.01, f"and back ({changed(first, home):.3f})")
    buttons = browser.run("return document.querySelectorAll('#colourways button').length")
    for index in range(1, buttons):
        browser.click(f"#colourways button:nth-child({index + 1})")
        worn = browser.picture(f"{name}-colourway-{index}", folder)
        differs = max(abs(p - q) for p, q in zip(mean(first), mean(worn)))
        expect(differs > 2, f"colourway {index} is another one ({differs:.1f})")
    if buttons:
        browser.click("#colourways button:first-child")
    browser.click("#show-seams")
    seams = browser.picture(f"{name}-seams", folder)
    expect(changed(home, seams) > 0.0005, f"seams are shown ({changed(home, seams):.4f})")
    browser.click("#seams li:first-child button")
    browser.picture(f"{name}-seam", folder)
    expect("mm" in browser.run("return document.querySelector('#labels').textContent"), "with their lengths")
    browser.click("#seams li:first-child button")
    browser.click("#show-seams")
    browser.click("#show-size")
    browser.picture(f"{name}-size", folder)
    expect(browser.run("return document.querySelectorAll('#labels span').length") == 3, "three sizes")
    browser.click("#show-size")
    browser.click("#measure")
    for place in ((x - 20, y + 30), (x + 40, y + 40)):
        browser.drag("touch" if touch else "mouse", [place, place])
    browser.picture(f"{name}-measure", folder)
    said = browser.run("return document.querySelector('#labels').textContent")
    expect("mm" in said, f"the distance of two points: {said}")
    log = [entry["message"] for entry in browser.log() if entry["level"] in ("SEVERE", "WARNING")
           and "GPU" not in entry["message"] and "GL Driver" not in entry["message"]]
    expect(not log, f"no complaints {log[:3]}")


def main():
    page = pathlib.Path(sys.argv[1])
    folder = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else None
    driver = shutil.which("chromedriver")
    if not driver:
        print("there is no chromedriver: not looked at")
        return 77
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    with subprocess.Popen([driver, f"--port={port}"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
        try:
            address = f"http://127.0.0.1:{port}"
            for _ in range(100):
                try:
                    urllib.request.urlopen(address + "/status", timeout=5).close()
                    break
                except OSError:
                    time.sleep(0.1)
            for name, mobile in (("desk", None), ("phone", {"deviceMetrics": {"width": 390, "height": 780,
                                                                              "pixelRatio": 2, "touch": True}})):
                browser = Browser(address, [], mobile)
                try:
                    look(browser, page, folder, mobile is not None, name)
                finally:
                    browser.quit()
        finally:
            process.terminate()
    return 1 if expect.failed else 0


sys.exit(main())
