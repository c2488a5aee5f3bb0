"""What MkDocs is told of this repository.

Pages keep the names that they have here, so that a link works on the site as it does in a checkout:
README.md, docs/commands.md. On the site what is in docs/ stands at the top. Files that pages link to,
such as a scene or a schema, come along.
"""

import json
import os
import re
from pathlib import Path

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files
from mkdocs.structure.pages import Page

ROOT = Path(__file__).resolve().parents[2]
HERE = Path(__file__).resolve().parent
DOCS = "docs/"

# Pages besides those in docs/.
PAGES = ["README.md", "scenes/README.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "CHANGELOG.md"]

# [words](target), ![words](target) and [label]: target, without what stands behind # in the target.
LINK = re.compile(r"(?:\]\(|^\[[^\]^]+\]: +)(?![a-z]+:)([^)#\s]+)", re.MULTILINE)
FILE_NAME = re.compile(r'(<a href="[^"]*">)([\w./-]+\.md)(</a>)')
CELL_CODE = re.compile(r"(?<=<code>)[^<]*\\\|[^<]*(?=</code>)")
# Code in a text, not that of a block. Browsers would end a line at any hyphen in it: --fail-on.
INLINE_CODE = re.compile(r"(?<=<code>)[^<]+(?=</code>)")
# A longer word might be wider than a phone.
WORD = re.compile(r"(?<!\S)(?=\w*[^\s\w])\S{2,32}(?!\S)")
BLOCK = re.compile(r"(<pre\b.*?</pre>)", re.DOTALL)
# The picture that becomes a scene to walk through, and where the site has that.
LIVE = ("docs/export.md", "pictures/export-web.png", "kitchen")
PICTURE = re.compile(r'<p>(<img alt="[^"]*" src="([^"]+)" ?/?>)</p>')


def github_anchor(heading: str, separator: str) -> str:
    """The anchor that GitHub gives a heading; the pages' links are written for these."""
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", separator)


def on_config(config: MkDocsConfig) -> MkDocsConfig:
    config.mdx_configs["toc"]["slugify"] = github_anchor
    return config


def on_files(files: Files, config: MkDocsConfig) -> Files:
    """The site's files, by their names in the repository; those of the theme as they are."""
    theirs = [file for file in files if file.src_dir != config.docs_dir]
    names = [DOCS + file.src_uri for file in files if file.src_dir == config.docs_dir] + PAGES
    for page in [name for name in names if name.endswith(".md")]:
        for target in LINK.findall((ROOT / page).read_text("utf-8")):
            linked = (ROOT / page).parent.joinpath(target).resolve()
            if linked.is_file() and linked.is_relative_to(ROOT):
                names.append(linked.relative_to(ROOT).as_posix())
    result = theirs
    for name in dict.fromkeys(names):
        result.append(site_file(config, name, ROOT / name))
    for asset in sorted((HERE / "assets").iterdir()):
        result.append(site_file(config, "assets/" + asset.name, asset))
    return Files(result)


def site_file(config: MkDocsConfig, name: str, path: Path) -> File:
    file = File.generated(config, name, abs_src_path=str(path))
    file.dest_uri = file.dest_uri.removeprefix(DOCS)
    return file


def on_page_content(html: str, page: Page, **_: object) -> str:
    """Links that are called by a file have the title of its page; pictures open in their own size."""
    here = (ROOT / page.file.src_uri).parent

    def titled(link: re.Match[str]) -> str:
        return link[1] + title(here / link[2]) + link[3]

    html = FILE_NAME.sub(titled, html)
    # In a cell's code GitHub reads \| as |, as there is no other way to write it.
    html = CELL_CODE.sub(lambda code: code[0].replace("\\|", "|"), html)
    scene = os.environ.get("SITE_SCENE")
    if scene and page.file.src_uri == LIVE[0]:
        html = live(html, Path(scene))
    return PICTURE.sub(r'<p><a class="picture" href="\2">\1</a></p>', html)


def live(html: str, scene: Path) -> str:
    """The page with a place for the scene about its picture; live-scene.js puts a button on it."""
    exported = json.loads((scene / "scene.json").read_text("utf-8"))
    megabytes = round(sum(exported["files"].values()) / 1e6)

    def place(picture: re.Match[str]) -> str:
        return picture[0] if picture[2] != LIVE[1] else (
            f'<div class="live-scene" data-scene="{LIVE[2]}/index.html" data-megabytes="{megabytes}"'
            f' data-title="The kitchen, to walk through">{picture[1]}</div>')

    return PICTURE.sub(place, html)


def on_post_page(output: str, **_: object) -> str:
    """Lines end between the words of code, not within one; after the search has read the page."""

    def whole(code: re.Match[str]) -> str:
        return WORD.sub(r'<span class="word">\g<0></span>', code[0])

    parts = BLOCK.split(output)
    return "".join(part if part.startswith("<pre") else INLINE_CODE.sub(whole, part) for part in parts)


def title(path: Path) -> str:
    """The first heading of a page; its name where there is no such page."""
    if path.is_file():
        for line in path.read_text("utf-8").splitlines():
            if line.startswith("# "):
                return line[2:].replace("`", "")
    return path.name
