package org.selectiverenderer.x3d.url;

import java.net.URI;
import java.nio.file.Path;

/** The base against which relative urls are resolved (X3D 4.0, 9.2). */
public sealed interface BaseUrl {
  /** A local folder. */
  record Folder(Path path) implements BaseUrl {}

  /**
   * A file on the network.
   *
   * @param uri the complete address, including the file name
   */
  record Web(URI uri) implements BaseUrl {}

  /**
   * Two bases, of which the second is used if the first has no such file: urls in a prototype's
   * body refer to files beside the declaring file, or else beside the file that uses it.
   */
  record FirstOf(BaseUrl first, BaseUrl second) implements BaseUrl {}

  /** Returns a base for urls relative to a folder. */
  static BaseUrl folder(Path path) {
    return new Folder(path);
  }

  /** Returns a base that resolves against this one, and if that fails against another. */
  default BaseUrl or(BaseUrl other) {
    return equals(other) ? this : new FirstOf(this, other);
  }
}
