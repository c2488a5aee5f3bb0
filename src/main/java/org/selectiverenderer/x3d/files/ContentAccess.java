package org.selectiverenderer.x3d.files;

import java.nio.file.Path;
import java.util.List;

/**
 * What a user lets scenes read besides the files of their own project.
 *
 * @param folders whose files, those below included, every scene may name
 * @param network what may be fetched, and what has been; one object serves a session, so that
 *     nothing is fetched twice
 */
public record ContentAccess(List<Path> folders, Network network) {
  public ContentAccess {
    folders = List.copyOf(folders);
  }

  /** Nothing more. */
  public static ContentAccess none() {
    return new ContentAccess(List.of(), Network.none());
  }

  /** The same with further folders. */
  public ContentAccess and(List<Path> more) {
    return new ContentAccess(
        java.util.stream.Stream.concat(folders.stream(), more.stream()).distinct().toList(),
        network);
  }
}
