package org.selectiverenderer.browser.loading;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.browser.scene.Scene;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.url.BaseUrl;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;
import org.selectiverenderer.x3d.url.UrlResolver;

/**
 * The context in which the urls of a node are resolved: what is known about its file after it was
 * read.
 *
 * @param root the files that may be read
 * @param base the base of the file's relative urls
 * @param including the keys of the chain of files that inline one another down to this one, itself
 *     last; none of them may be inlined below it
 * @param unitLength the file's metres per unit of length
 */
record UrlContext(UrlResolver root, BaseUrl base, List<String> including, double unitLength) {

  /** Returns the context of a scene made by an application. */
  static UrlContext workingFolder(ContentAccessPolicy access) {
    Path here = Path.of("");
    return new UrlContext(
        new UrlResolver(here, access), BaseUrl.folder(here), List.of(here.toString()), 1);
  }

  /** Returns the context of the file from which a scene was made; empty without a file. */
  static Optional<UrlContext> of(Scene scene) {
    return scene.companion() instanceof UrlContext known ? Optional.of(known) : Optional.empty();
  }

  /** Returns the context of a node of the file, which may come from a prototype of another file. */
  UrlContext of(ParsedNode node) {
    BaseUrl own = node.base(base);
    return own == base || own.equals(base)
        ? this
        : new UrlContext(root, own, including, unitLength);
  }

  /** Returns the keys of the files that inline this one. */
  List<String> above() {
    return including.subList(0, including.size() - 1);
  }

  /** Returns the key of the file itself. */
  String file() {
    return including.get(including.size() - 1);
  }
}
