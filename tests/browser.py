#!/usr/bin/env python3
"""tests/browser.py [chromium|firefox-esr]...: the page of x11/browser/build.sh against the X11 window.

In each of these browsers that the machine has, without a screen, build/browser/xnewell.html shows each view in three
sizes. The browser itself compares its canvas with a snapshot of the X11 window (Xvfb, 24 bits), pixel by pixel. What
tells times and the visual is left out: the status line, view 6, and the lines of times in view 5, of which it counts
the pixels. Then it measures what a person waits for. Exit status: 1 if a pixel differs, 77 if there is no browser, no
page or no program.
"""
import http.server, json, pathlib, queue, shutil, subprocess, sys, tempfile, threading

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE, PROGRAM = ROOT / "build/browser/xnewell.html", ROOT / "build/release/x11/xnewell"
VIEWS = "picture depthsort colours machbands sidebyside lesson pixel viewing scanline".split()
SIZES = "800x540 1024x768 1366x720".split()
LETTERS = 13  # rows of pixels of a line

# Runs in the page, behind its own script.
SCRIPT = """<script>
const post = what => fetch('/result', {method: 'POST', body: JSON.stringify(what)});
const after = ms => new Promise(done => setTimeout(done, ms));
const frame = () => new Promise(requestAnimationFrame);
function pixelsOf(source) {
  const copy = document.createElement('canvas');
  copy.width = source.width, copy.height = source.height;
  const flat = copy.getContext('2d', {willReadFrequently: true});
  flat.drawImage(source, 0, 0);
  return new Uint32Array(flat.getImageData(0, 0, copy.width, copy.height).data.buffer);
}
async function compare(view, size) {
  const [w, h] = size.split('x');
  at('room').style.cssText = `flex: none; width: ${w / devicePixelRatio}px; height: ${h / devicePixelRatio}px`;
  await after(100);
  open('teapot&view=' + view);
  for (let k = 0; k < 5; ++k) await frame();
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
async function measure() {
  const drawn = Module.frames, begin = performance.now();
  Module._xn_point(1, 300, 300);
  for (let x = 300; performance.now() - begin < 3000; x = x === 300 ? 304 : 300) {
    Module._xn_point(0, x, 300 + (performance.now() - begin) / 60);
    await frame();
  }
  const frames = (Module.frames - drawn) / (performance.now() - begin) * 1000;
  Module._xn_let_go();
  const waits = [];
  for (let k = 0; k < 11; ++k) {
    const pressed = performance.now();
    press('S');
    const stale = Module._xn_update();
    if (stale) paint(stale === 2);
    if (gl) gl.finish();
    waits.push(performance.now() - pressed);
    await frame();
  }
  return {frames, key: waits.sort((a, b) => a - b)[5], gpu: !!gl};
}
(async () => {
  while (!Module.frames) await after(10);
  const first = performance.now();
  for (const view of VIEWS) for (const size of SIZES) await post(await compare(view, size));
  open('teapot');
  await post({first, ...await measure()});
})().catch(why => post({wrong: String(why)}));
</script>"""


def snapshot(view, size, display, folder):
    file = folder / f"{view}-{size}.png"
    if not file.exists():
        subprocess.run([PROGRAM, "snapshot", "teapot", "--view", view, "--whole-window", "--size", size, "-o", file],
                       env={"DISPLAY": display, "PATH": "/usr/bin:/bin"}, check=True)
    return file.read_bytes()


def main():
    browsers = [name for name in sys.argv[1:] or ["chromium", "firefox-esr"] if shutil.which(name)]
    if not (browsers and PAGE.exists() and PROGRAM.exists()):
        print("tests/browser.py: there is no browser, no build/browser/xnewell.html or no build/release/x11/xnewell")
        return 77
    results, folder = queue.Queue(), pathlib.Path(tempfile.mkdtemp())
    script = SCRIPT.replace("VIEWS", json.dumps(VIEWS)).replace("SIZES", json.dumps(SIZES))

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
                    print(browser, "first frame {first:.0f} ms after the page began, {frames:.1f} frames a second while"
                          " dragging, {key:.0f} ms from key to picture, WebGL2: {gpu}".format(**result), flush=True)
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
