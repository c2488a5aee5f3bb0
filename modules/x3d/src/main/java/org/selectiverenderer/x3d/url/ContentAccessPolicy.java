package org.selectiverenderer.x3d.url;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/**
 * The folders and hosts that the user allows scenes to read in addition to the files of their own
 * project.
 *
 * @param folders folders whose files, including subfolders, every scene may refer to
 * @param network the allowed hosts with a cache; one object is shared in a session, so that nothing
 *     is fetched twice
 * @param named collects the local files to which scenes have referred
 */
public record ContentAccessPolicy(List<Path> folders, HttpFetcher network, ReferencedFiles named) {
  /** Makes a defensive copy of the list. */
  public ContentAccessPolicy {
    folders = List.copyOf(folders);
  }

  /** Creates an access without files referred to yet. */
  public ContentAccessPolicy(List<Path> folders, HttpFetcher network) {
    this(folders, network, new ReferencedFiles());
  }

  /** Returns an access without further folders and hosts. */
  public static ContentAccessPolicy none() {
    return new ContentAccessPolicy(List.of(), HttpFetcher.none());
  }

  /** Returns an access to the folders and hosts of both. */
  public ContentAccessPolicy and(ContentAccessPolicy more) {
    if (more.folders.isEmpty() && more.network.hosts().isEmpty()) {
      return this;
    }
    return new ContentAccessPolicy(
        Stream.concat(folders.stream(), more.folders.stream()).distinct().toList(),
        new HttpFetcher(
            Stream.concat(network.hosts().stream(), more.network.hosts().stream())
                .distinct()
                .toList()));
  }
}
