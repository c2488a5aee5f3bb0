"""Looks at a site in a Chromium without a window; packaging/site/check calls it and says for what."""

import argparse
import functools
import http.server
import sys
import threading
from pathlib import Path

from playwright.sync_api import Browser, Page, Playwright, Request, TimeoutError, sync_playwright

# Widths of a desktop and of a phone, in CSS pixels, with their heights.
WINDOWS = {"desktop": (1440, 900), "phone": (390, 844)}

SEARCHED = "whichChoice"

# What Chromium needs to draw without a graphics card.
SOFTWARE_GL = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]

# A page of each kind, whose pictures are taken: the entrance, a story, prose with pictures, wide tables,
# long code, a generated list, figures.
KINDS = [
    "index.html",
    "story-researcher.html",
    "story-author.html",
    "story-ci.html",
    "commands.html",
    "options.html",
    "rules.html",
    "x3d-support.html",
    "study-keys.html",
    "formats.html",
    "enricher.html",
    "experiment.html",
    "performance.html",
    "CHANGELOG.html",
]

# What is wrong with a page as it is laid out, as sentences.
MEASURE = """() => {
  const faults = [];
  const width = document.documentElement.clientWidth;
  const wide = document.documentElement.scrollWidth;
  if (wide > width) {
    const widest = [...document.querySelectorAll('main *')]
      .filter((e) => e.getBoundingClientRect().right > width + 1 && !e.closest('.md-typeset__scrollwrap, pre'));
    faults.push(`is ${wide} pixels wide in a window of ${width}: ` +
      widest.slice(0, 3).map((e) => e.outerHTML.slice(0, 80)).join(' | '));
  }
  for (const image of document.querySelectorAll('article img')) {
    const box = image.getBoundingClientRect();
    const name = image.getAttribute('src');
    if (!image.complete || image.naturalWidth === 0) faults.push(`lacks the picture ${name}`);
    if (box.right > width + 1) faults.push(`has a picture that is too wide: ${name}`);
    if (box.height > 0.9 * innerHeight) faults.push(`has a picture higher than the window: ${name}`);
    if (!image.alt) faults.push(`has a picture without words for it: ${name}`);
  }
  for (const block of document.querySelectorAll('article pre > code, .md-typeset__scrollwrap')) {
    const outside = block.getBoundingClientRect().right > width + 1;
    const scrolls = ['auto', 'scroll'].includes(getComputedStyle(block).overflowX);
    if (outside || (block.scrollWidth > block.clientWidth + 1 && !scrolls)) {
      faults.push('has a block that neither fits nor scrolls: ' + block.textContent.trim().slice(0, 60));
    }
  }
  if (document.querySelectorAll('article h1').length !== 1) faults.push('has not one title');
  return faults;
}"""


class Look:
    """A browser's view of a site, and what was found wrong."""

    def __init__(self, page: Page, base: str):
        self.page = page
        self.base = base
        self.faults: list[str] = []
        self.at = ""
        page.on("request", self._asked)
        page.on("pageerror", lambda error: self.fault(f"has an error of its scripts: {error}"))
        page.on("requestfailed", self._failed)
        page.on("response", lambda got: got.status < 400 or self.fault(f"got {got.status} for {got.url}"))

    def _asked(self, request: Request) -> None:
        if not request.url.startswith((self.base, "data:", "blob:", "about:")):
            self.fault(f"asks another server: {request.url}")

    def _failed(self, request: Request) -> None:
        # What is still on its way when the next page is opened is aborted, which is no fault.
        if request.failure != "net::ERR_ABORTED":
            self.fault(f"did not get {request.url}: {request.failure}")

    def fault(self, sentence: str) -> None:
        self.faults.append(f"{self.at} {sentence}")

    def open(self, name: str, window: str) -> None:
        self.at = f"{name} ({window})"
        width, height = WINDOWS[window]
        self.page.set_viewport_size({"width": width, "height": height})
        self.page.goto(self.base + name, wait_until="load")

    def measure(self) -> None:
        for fault in self.page.evaluate(MEASURE):
            self.fault(fault)

    def search(self, word: str) -> None:
        """Types a word into the search, and follows the first hit to where the word stands."""
        self.at = f"the search from {self.base.split(':')[0]}:"
        self.page.keyboard.press("/")
        self.page.keyboard.type(word, delay=20)
        # Each letter is a search of its own; the hits of the whole word mark it.
        marked = self.page.locator(".md-search-result__link:has(mark)", has_text=word)
        try:
            marked.first.wait_for(timeout=60_000)
        except TimeoutError:
            self.fault(f"does not find {word}")
            return
        marked.first.click()
        self.page.wait_for_load_state("load")
        if word.lower() not in self.page.inner_text("article").lower():
            self.fault(f"led to {self.page.url}, where {word} is not")


def serve(folder: Path) -> http.server.ThreadingHTTPServer:
    class Quiet(http.server.SimpleHTTPRequestHandler):
        def log_message(self, *_: object) -> None:
            pass

    server = http.server.ThreadingHTTPServer(
        ("127.0.0.1", 0), functools.partial(Quiet, directory=str(folder))
    )
    threading.Thread(target=server.serve_forever, name="site", daemon=True).start()
    return server


def main() -> int:
    arguments = argparse.ArgumentParser()
    arguments.add_argument("site", type=Path)
    arguments.add_argument("--browser", required=True)
    arguments.add_argument("--pictures", type=Path)
    arguments.add_argument("--only", nargs="+", metavar="PAGE.html", default=[])
    options = arguments.parse_args()
    site = options.site.resolve()
    # study-report.html is a report of the program, and kitchen a scene, which have their own look.
    names = sorted(
        file.relative_to(site).as_posix()
        for file in site.rglob("*.html")
        if file.name not in ("404.html", "study-report.html") and file.parent.name != "kitchen"
        and (not options.only or file.name in options.only)
    )
    server = serve(site)
    faults: list[str] = []
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=options.browser, args=["--no-sandbox"])
        look = Look(browser.new_page(), f"http://127.0.0.1:{server.server_port}/")
        for name in names:
            for window in WINDOWS:
                look.open(name, window)
                look.measure()
        look.open("index.html", "desktop")
        look.search(SEARCHED)
        faults += look.faults
        files = Look(browser.new_page(), site.as_uri() + "/")
        files.open("index.html", "desktop")
        files.search(SEARCHED)
        faults += files.faults
        if options.pictures:
            take(browser, look.base, options.pictures)
        browser.close()
        if (site / "kitchen").is_dir():
            faults += walk(playwright, options.browser, look.base)
    server.shutdown()
    for fault in faults:
        print(f"site: {fault}", file=sys.stderr)
    print(f"site: {len(names)} pages, {len(faults)} faults", file=sys.stderr)
    return 1 if faults else 0


def walk(playwright: Playwright, browser: str, base: str) -> list[str]:
    """The scene comes where its picture is clicked; who has no WebGL is told so."""
    faults: list[str] = []
    for drawing in (SOFTWARE_GL, ["--disable-3d-apis"]):
        chromium = playwright.chromium.launch(executable_path=browser, args=["--no-sandbox", *drawing])
        look = Look(chromium.new_page(), base)
        look.open("export.html", "phone")
        look.page.locator(".live-scene button").click()
        try:
            if drawing == SOFTWARE_GL:
                frame = look.page.wait_for_selector(".live-scene iframe").content_frame()
                frame.wait_for_function("() => window.selectiveRenderer", timeout=300_000)
            else:
                look.page.get_by_text("has no WebGL 2").wait_for()
        except TimeoutError:
            look.fault("shows no scene where it is asked for" if drawing == SOFTWARE_GL else "does not say what lacks")
        look.measure()
        faults += look.faults
        chromium.close()
    return faults


def take(browser: Browser, base: str, folder: Path) -> None:
    """Pictures of a page of each kind, light and dark, for people to look at."""
    folder.mkdir(parents=True, exist_ok=True)
    for scheme in ("light", "dark"):
        page = browser.new_page(color_scheme=scheme)
        for window, (width, height) in WINDOWS.items():
            page.set_viewport_size({"width": width, "height": height})
            for name in KINDS if scheme == "light" else KINDS[:5]:
                page.goto(base + name, wait_until="load")
                page.screenshot(path=folder / f"{Path(name).stem}-{window}-{scheme}.png")
        page.close()


if __name__ == "__main__":
    sys.exit(main())
