package org.selectiverenderer.runtime.loading;

import java.nio.file.Path;
import java.util.List;
import org.selectiverenderer.x3d.files.ContentAccess;
import org.selectiverenderer.x3d.files.ContentBase;
import org.selectiverenderer.x3d.files.ContentRoot;
import org.selectiverenderer.x3d.read.ParsedNode;

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
record UrlBase(ContentRoot root, ContentBase base, List<String> including, double unitLength) {

  /** Returns the context of a scene made by an application. */
  static UrlBase workingFolder(ContentAccess access) {
    Path here = Path.of("");
    return new UrlBase(
        new ContentRoot(here, access), ContentBase.folder(here), List.of(here.toString()), 1);
  }

  /** Returns the context of a node of the file, which may come from a prototype of another file. */
  UrlBase of(ParsedNode node) {
    ContentBase own = node.base(base);
    return own == base || own.equals(base) ? this : new UrlBase(root, own, including, unitLength);
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
