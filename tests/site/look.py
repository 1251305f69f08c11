"""Look at pages of the built site as people do: in Chromium, on a desk and on a telephone, in the light and in
the dark. axe-core judges whether everybody can use them; pictures are for one's own eyes. On request: it needs
chromium, and npm, which fetches axe-core from its registry.

usage: look.py SITE OUT [PAGE...]; PAGE is a path in SITE; without one, ten pages of all kinds
"""

import base64
import json
import pathlib
import subprocess
import sys

PAGES = ["index.html", "install.html", "tutorials/projection/index.html", "tutorials/pruning/index.html",
         "guide/command.html", "guide/frames.html", "reference/c/solve.html", "reference/python.html",
         "reference/command.html", "background/theory.html"]
# Width and height [pixels], whether it is a telephone, colours.
VIEWS = {"desk": (1280, 900, False, "light"), "desk-dark": (1280, 900, False, "dark"),
         "phone": (390, 844, True, "light"), "phone-dark": (390, 844, True, "dark")}


class Browser:
    """Chromium without a window, told what to do through a pipe: JSON, each message ended by a zero byte."""

    def __init__(self):
        options = ["--headless", "--no-sandbox", "--disable-gpu", "--allow-file-access-from-files",
                   "--remote-debugging-pipe", "about:blank"]
        self.process = subprocess.Popen(
            ["sh", "-c", 'exec "$@" 3<&0 4>&1 </dev/null >/dev/null 2>&1', "sh", "chromium", *options],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, bufsize=0)
        self.number, self.rest, self.events = 0, b"", []
        target = self.ask("Target.createTarget", url="about:blank")["targetId"]
        self.session = None
        self.session = self.ask("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        self.ask("Page.enable")

    session = None

    def message(self):
        while b"\0" not in self.rest:
            block = self.process.stdout.read(65536)
            if not block:
                sys.exit("Chromium has ended")
            self.rest += block
        text, _, self.rest = self.rest.partition(b"\0")
        return json.loads(text)

    def ask(self, method, **parameters):
        self.number += 1
        what = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            what["sessionId"] = self.session
        self.process.stdin.write(json.dumps(what).encode() + b"\0")
        while (got := self.message()).get("id") != self.number:
            self.events.append(got.get("method"))
        if "error" in got:
            sys.exit(f"{method}: {got['error']}")
        return got["result"]

    def open(self, url, width, height, phone, colours):
        self.ask("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=phone)
        self.ask("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": colours}])
        self.events.clear()
        self.ask("Page.navigate", url=url)
        while "Page.loadEventFired" not in self.events:
            self.events.append(self.message().get("method"))

    def run(self, script):
        """What a script in the page ends with."""
        got = self.ask("Runtime.evaluate", expression=script, awaitPromise=True, returnByValue=True)
        if "exceptionDetails" in got:
            sys.exit(f"the page: {got['exceptionDetails']}")
        return got["result"].get("value")

    def picture(self, path):
        path.write_bytes(base64.b64decode(self.ask("Page.captureScreenshot", format="png")["data"]))


def axe(out):
    """The text of axe-core, fetched once."""
    place = out / "node_modules/axe-core/axe.min.js"
    if not place.exists():
        subprocess.run(["npm", "install", "--silent", "--no-fund", "--no-audit", "--prefix", out, "axe-core"], check=True)
    return place.read_text()


def faults(browser, judge):
    """What axe-core has found, and whether the page is wider than its window."""
    browser.run(judge + "; 0")
    found = browser.run("axe.run(document, {resultTypes: ['violations']}).then(r => JSON.stringify(r.violations))")
    for fault in json.loads(found):
        for node in fault["nodes"]:
            yield f"{fault['id']} ({fault['impact']}): {fault['help']}: {' '.join(node['target'])}: {node['html'][:120]}"
    if wide := browser.run("document.documentElement.scrollWidth - document.documentElement.clientWidth"):
        yield f"the page is {wide} pixels wider than its window"


def main():
    site, out = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    out.mkdir(parents=True, exist_ok=True)
    judge, browser, count = axe(out), Browser(), 0
    for page in sys.argv[3:] or PAGES:
        for view, look in VIEWS.items():
            browser.open((site / page).resolve(strict=True).as_uri(), *look)
            browser.picture(out / f"{page.replace('/', '-').replace('.html', '')}-{view}.png")
            for fault in faults(browser, judge):
                print(f"{page}, {view}: {fault}")
                count += 1
    browser.process.terminate()
    print(f"{count} faults in {len(sys.argv[3:] or PAGES)} pages, {len(VIEWS)} views each")
    sys.exit(bool(count))


if __name__ == "__main__":
    main()
