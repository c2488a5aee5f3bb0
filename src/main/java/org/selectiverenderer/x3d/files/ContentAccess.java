package org.selectiverenderer.x3d.files;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/**
 * What a user lets scenes read besides the files of their own project.
 *
 * @param folders whose files, those below included, every scene may name
 * @param network what may be fetched, and what has been; one object serves a session, so that
 *     nothing is fetched twice
 * @param named what the scenes have named so far
 */
public record ContentAccess(List<Path> folders, Network network, FilesNamed named) {
  /** Keeps copies, so that it stays as it is. */
  public ContentAccess {
    folders = List.copyOf(folders);
  }

  /** With nothing named yet. */
  public ContentAccess(List<Path> folders, Network network) {
    this(folders, network, new FilesNamed());
  }

  /** Nothing more. */
  public static ContentAccess none() {
    return new ContentAccess(List.of(), Network.none());
  }

  /** What either allows. */
  public ContentAccess and(ContentAccess more) {
    if (more.folders.isEmpty() && more.network.hosts().isEmpty()) {
      return this;
    }
    return new ContentAccess(
        Stream.concat(folders.stream(), more.folders.stream()).distinct().toList(),
        new Network(
            Stream.concat(network.hosts().stream(), more.network.hosts().stream())
                .distinct()
                .toList()));
  }
}
