package org.selectiverenderer.runtime.loading;

import java.nio.file.Path;
import java.util.List;
import org.selectiverenderer.x3d.files.ContentRoot;

/**
 * Where the urls of a node lead: what is known of its file after it was read.
 *
 * @param root which files may be read
 * @param folder of the file, against which its urls are resolved
 * @param including the files that inlined one another down to this one, itself last: none of them
 *     may be inlined below it
 * @param unitLength metres per unit of length of the file
 */
record UrlBase(ContentRoot root, Path folder, List<Path> including, double unitLength) {

  /** That of a scene made by an application. */
  static UrlBase workingFolder() {
    Path here = Path.of("");
    return new UrlBase(new ContentRoot(here), here, List.of(here), 1);
  }

  /** The files that inlined one another down to the one that inlines this one. */
  List<Path> above() {
    return including.subList(0, including.size() - 1);
  }

  /** The file itself. */
  Path file() {
    return including.get(including.size() - 1);
  }
}
