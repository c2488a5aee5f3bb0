package org.selectiverenderer.runtime.loading;

import java.nio.file.Path;
import java.util.List;
import org.selectiverenderer.x3d.files.ContentAccess;
import org.selectiverenderer.x3d.files.ContentBase;
import org.selectiverenderer.x3d.files.ContentRoot;
import org.selectiverenderer.x3d.read.ParsedNode;

/**
 * Where the urls of a node lead: what is known of its file after it was read.
 *
 * @param root which files may be read
 * @param base where the relative urls of the file start
 * @param including the keys of the files that inlined one another down to this one, itself last:
 *     none of them may be inlined below it
 * @param unitLength metres per unit of length of the file
 */
record UrlBase(ContentRoot root, ContentBase base, List<String> including, double unitLength) {

  /** That of a scene made by an application. */
  static UrlBase workingFolder(ContentAccess access) {
    Path here = Path.of("");
    return new UrlBase(
        new ContentRoot(here, access), ContentBase.folder(here), List.of(here.toString()), 1);
  }

  /** That of a node of the file, which may have come with a prototype of another one. */
  UrlBase of(ParsedNode node) {
    ContentBase own = node.base(base);
    return own == base || own.equals(base) ? this : new UrlBase(root, own, including, unitLength);
  }

  /** The files that inlined one another down to the one that inlines this one. */
  List<String> above() {
    return including.subList(0, including.size() - 1);
  }

  /** The key of the file itself. */
  String file() {
    return including.get(including.size() - 1);
  }
}
