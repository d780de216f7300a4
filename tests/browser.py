#!/usr/bin/env python3
"""tests/browser.py [chromium|firefox-esr]...: the page of x11/browser/build.sh against the X11 window.

In each of these browsers that the machine has, without a screen, build/browser/xnewell.html shows each view in three
sizes. The browser itself compares its canvas with a snapshot of the X11 window (Xvfb, 24 bits), pixel by pixel. What
tells times and the visual is left out: the status line, view 6, and the lines of times in view 5, of which it counts
the pixels. Then it measures what a person waits for, in the X11 window and in each page. Exit status: 1 if a pixel
differs, 77 if there is no browser, no page or no program.
"""
import ctypes, gzip, http.server, json, pathlib, queue, shutil, subprocess, sys, tempfile, threading, time

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE, PROGRAM = ROOT / "build/browser/xnewell.html", ROOT / "build/release/x11/xnewell"
VIEWS = "picture depthsort colours machbands sidebyside lesson pixel viewing scanline".split()
SIZES = "800x540 1024x768 1366x720".split()
LETTERS = 13  # rows of pixels of a line
DRAG, KEYS = 3, 11  # seconds, presses

# Runs in the page, behind its own script.
SCRIPT = """<script>
const post = what => fetch('/result', {method: 'POST', body: JSON.stringify(what)});
const after = ms => new Promise(done => setTimeout(done, ms));
const frame = () => new Promise(requestAnimationFrame);
async function painted(from) { while (frames === from) await after(0); }
function pixelsOf(source) {
  const copy = document.createElement('canvas');
  copy.width = source.width, copy.height = source.height;
  const flat = copy.getContext('2d', {willReadFrequently: true});
  flat.drawImage(source, 0, 0);
  return new Uint32Array(flat.getImageData(0, 0, copy.width, copy.height).data.buffer);
}
async function compare(view, size) {
  const [w, h] = size.split('x');
  room.style.cssText = `flex: none; width: ${w / devicePixelRatio}px; height: ${h / devicePixelRatio}px`;
  await after(100);
  open('teapot&view=' + view);
  for (let still = 0, answer, drawn; still < 9; await frame()) {  // so many answers of the program without a picture
    if (shown === answer) continue;
    still = frames === drawn && !calls.length ? still + 1 : 0;
    answer = shown, drawn = frames;
  }
  const image = new Image();
  image.src = `/snapshot?${view}&${size}`;
  await image.decode();
  const ours = pixelsOf(canvas), theirs = pixelsOf(image), rows = {};
  if (ours.length !== theirs.length) return {view, size, wrong: `${canvas.width} x ${canvas.height}`};
  ours.forEach((pixel, k) => {
    const row = Math.floor(k / canvas.width);
    if (pixel !== theirs[k]) rows[row] = (rows[row] ?? 0) + 1;
  });
  return {view, size, rows};
}
async function measureTimes() {
  const drawn = frames, begin = performance.now();
  ask('point', 1, 300, 300);
  for (let x = 300; performance.now() - begin < DRAG * 1000; x = x === 300 ? 304 : 300) {
    ask('point', 0, x, 300 + Math.floor((performance.now() - begin) / 60));
    await frame();
  }
  const perSecond = (frames - drawn) / (performance.now() - begin) * 1000;
  ask('let_go');
  await after(500);
  const waits = [];
  for (let k = 0; k < KEYS; ++k) {
    const pressed = performance.now(), from = frames;
    press('S');
    await painted(from);
    if (gl) gl.finish();
    waits.push(performance.now() - pressed);
    await after(100);
  }
  return {frames: perSecond, key: waits.sort((a, b) => a - b)[KEYS >> 1], gpu: !!gl};
}
(async () => {
  while (!frames) await after(10);
  const first = performance.now();
  for (const view of VIEWS) for (const size of SIZES) await post(await compare(view, size));
  room.style.cssText = 'flex: none; width: 1024px; height: 768px';
  open('teapot');
  await after(1000);
  await post({first, ...await measureTimes()});
})().catch(why => post({wrong: String(why)}));
</script>"""


def snapshot(view, size, display, folder):
    file = folder / f"{view}-{size}.png"
    if not file.exists():
        subprocess.run([PROGRAM, "snapshot", "teapot", "--view", view, "--whole-window", "--size", size, "-o", file],
                       env={"DISPLAY": display, "PATH": "/usr/bin:/bin"}, check=True)
    return file.read_bytes()


class Screen:
    """What a person sees and does on an X server: a row of pixels, keys, the pointer."""

    def __init__(self, display):
        self.x, self.test = ctypes.CDLL("libX11.so.6"), ctypes.CDLL("libXtst.so.6")
        for name in "XOpenDisplay XGetImage XDefaultRootWindow XStringToKeysym".split():
            getattr(self.x, name).restype = ctypes.c_void_p
        self.display = ctypes.c_void_p(self.x.XOpenDisplay(display.encode()))
        self.root = ctypes.c_void_p(self.x.XDefaultRootWindow(self.display))

    def row(self):
        """Row 300 of the screen."""
        image = self.x.XGetImage(self.display, self.root, 0, 300, 600, 1, ctypes.c_ulong(0xFFFFFFFF), 2)
        data = ctypes.string_at(ctypes.c_void_p.from_address(image + 16).value, 600 * 4)
        self.x.XFree(ctypes.c_void_p.from_address(image + 16))
        self.x.XFree(ctypes.c_void_p(image))
        return data

    def changed(self, row, patience=10):
        """The row, as soon as it is another one."""
        until = time.monotonic() + patience
        while (now := self.row()) == row and time.monotonic() < until:
            time.sleep(0.0005)
        return now

    def move(self, x, y):
        self.test.XTestFakeMotionEvent(self.display, -1, x, y, ctypes.c_ulong(0))
        self.x.XSync(self.display, 0)

    def press(self, down):
        self.test.XTestFakeButtonEvent(self.display, 1, down, ctypes.c_ulong(0))
        self.x.XSync(self.display, 0)

    def key(self, *names):
        symbols = [ctypes.c_ulong(self.x.XStringToKeysym(name.encode())) for name in names]
        codes = [self.x.XKeysymToKeycode(self.display, symbol) for symbol in symbols]
        for code, down in [(code, 1) for code in codes] + [(code, 0) for code in reversed(codes)]:
            self.test.XTestFakeKeyEvent(self.display, code, down, ctypes.c_ulong(0))
        self.x.XSync(self.display, 0)


def measure_window(display):
    """The same as measureTimes(), in the X11 window."""
    screen = Screen(display)
    row, begin = screen.row(), time.monotonic()
    window = subprocess.Popen([PROGRAM, "teapot", "--size", "1024x768"], stdout=subprocess.DEVNULL,
                              env={"DISPLAY": display, "PATH": "/usr/bin:/bin"})
    try:
        row = screen.changed(row)
        first = time.monotonic() - begin
        screen.move(300, 300)
        time.sleep(1)
        screen.press(1)
        frames, begin = 0, time.monotonic()
        row = screen.row()
        while (spent := time.monotonic() - begin) < DRAG:
            screen.move(304 if frames % 2 else 300, 300 + int(spent * 1000 / 60))
            row, before = screen.changed(row, 0.5), row
            frames += row != before
        screen.press(0)
        time.sleep(0.5)
        waits = []
        for _ in range(KEYS):
            row, pressed = screen.row(), time.monotonic()
            screen.key("Shift_L", "s")
            screen.changed(row)
            waits.append(time.monotonic() - pressed)
            time.sleep(0.1)
        return {"first": first * 1000, "frames": frames / spent, "key": sorted(waits)[KEYS // 2] * 1000}
    finally:
        window.terminate()
        window.wait()


def tell(name, file, times):
    data = file.read_bytes()
    print(f"{name}: {len(data) / 1e6:.2f} MB, {len(gzip.compress(data)) / 1e6:.2f} packed; first frame after"
          f" {times['first']:.0f} ms, {times['frames']:.1f} frames a second while dragging, {times['key']:.0f} ms from"
          f" key to picture" + (f", WebGL2: {times['gpu']}" if "gpu" in times else ""), flush=True)


def main():
    browsers = [name for name in sys.argv[1:] or ["chromium", "firefox-esr"] if shutil.which(name)]
    if not (browsers and PAGE.exists() and PROGRAM.exists()):
        print("tests/browser.py: there is no browser, no build/browser/xnewell.html or no build/release/x11/xnewell")
        return 77
    results, folder = queue.Queue(), pathlib.Path(tempfile.mkdtemp())
    script = SCRIPT
    for name, value in {"VIEWS": VIEWS, "SIZES": SIZES, "DRAG": DRAG, "KEYS": KEYS}.items():
        script = script.replace(name, json.dumps(value))

    class Handler(http.server.BaseHTTPRequestHandler):
        def answer(self, kind, body):
            self.send_response(200)
            self.send_header("Content-Type", kind)
            self.end_headers()
            self.wfile.write(body)

        def do_GET(self):
            if self.path.startswith("/snapshot?"):
                self.answer("image/png", snapshot(*self.path.partition("?")[2].split("&"), display, folder))
            else:
                self.answer("text/html", PAGE.read_bytes() + script.encode())

        def do_POST(self):
            results.put(json.loads(self.rfile.read(int(self.headers["Content-Length"]))))
            self.answer("text/plain", b"")

        def log_message(self, *_):
            pass

    xvfb = subprocess.Popen(["Xvfb", "-displayfd", "1", "-screen", "0", "1600x1200x24", "-nolisten", "tcp"],
                            stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    display = ":" + xvfb.stdout.readline().decode().strip()
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    status = 0
    try:
        tell("the X11 window", PROGRAM, measure_window(display))
        for browser in browsers:
            url, profile = f"http://127.0.0.1:{server.server_port}/", folder / browser
            profile.mkdir()
            options = (["--no-sandbox", f"--user-data-dir={profile}", "--remote-debugging-port=0"]
                       if browser == "chromium" else ["--no-remote", "--profile", profile])
            running = subprocess.Popen([browser, "--headless", *options, url],
                                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            try:
                while "first" not in (result := results.get(timeout=180)):
                    height = int(result.get("size", "0x0").split("x")[1])
                    rows = {row: n for row, n in result.get("rows", {}).items() if not height - 42 <= int(row) < height - 20}
                    wrong = "wrong" in result or rows and (result["view"] != "sidebyside" or len(rows) > 2 * LETTERS)
                    print(browser, result if wrong else
                          f"{result['view']} {result['size']}: {sum(rows.values())} pixels differ", flush=True)
                    status = 1 if wrong else status
                    if "view" not in result:
                        break
                else:
                    tell(f"the page in {browser}", PAGE, result)
            except queue.Empty:
                print(browser, "gave no answer for three minutes")
                status = 1
            finally:
                running.terminate()
                running.wait()
    finally:
        xvfb.terminate()
        shutil.rmtree(folder, ignore_errors=True)
    return status


sys.exit(main())
