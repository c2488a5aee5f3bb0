package org.selectiverenderer.x3d.files;

import java.net.URI;
import java.nio.file.Path;

/** Where relative urls start (X3D 4.0, 9.2). */
public sealed interface ContentBase {
  /** A folder of this machine. */
  record Folder(Path path) implements ContentBase {}

  /**
   * A file of the network.
   *
   * @param uri its whole address, the file's name included
   */
  record Web(URI uri) implements ContentBase {}

  /**
   * Two places, of which the second counts where the first has no such file: a prototype's body
   * means files beside the one that declares it, or beside the one that uses it.
   */
  record FirstOf(ContentBase first, ContentBase second) implements ContentBase {}

  /** Urls that start in a folder. */
  static ContentBase folder(Path path) {
    return new Folder(path);
  }

  /** This place, or where it has no such file the other one. */
  default ContentBase or(ContentBase other) {
    return equals(other) ? this : new FirstOf(this, other);
  }
}
