package org.selectiverenderer.polygon.count;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.selectiverenderer.x3d.files.Content;

/**
 * Inlined files as they were read and measured, for the next count: a file that has neither another
 * size nor another time is not read again. Safe for use by several threads.
 */
final class KeptFiles {
  private record Kept(String stamp, SceneFile file) {}

  private final Map<String, Kept> files = new ConcurrentHashMap<>();

  /** The file, if it is known and still the same. */
  Optional<SceneFile> find(Content content) {
    Kept kept = files.get(content.key());
    return kept == null || !stamp(content).equals(Optional.of(kept.stamp))
        ? Optional.empty()
        : Optional.of(kept.file);
  }

  /**
   * Keeps a file.
   *
   * @param stamp of it before it was read
   */
  void keep(Content content, Optional<String> stamp, SceneFile file) {
    stamp.ifPresent(known -> files.put(content.key(), new Kept(known, file)));
  }

  /** Tells one state of a file from another; empty for what is no file, which is not kept. */
  static Optional<String> stamp(Content content) {
    return content.file().flatMap(KeptFiles::stamp);
  }

  private static Optional<String> stamp(Path file) {
    try {
      return Optional.of(Files.getLastModifiedTime(file) + "/" + Files.size(file));
    } catch (IOException e) {
      return Optional.empty(); // Not there: to open it will say so.
    }
  }
}
