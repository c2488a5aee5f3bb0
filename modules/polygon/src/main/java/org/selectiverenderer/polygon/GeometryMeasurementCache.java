package org.selectiverenderer.polygon;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.selectiverenderer.x3d.url.UrlContent;

/**
 * A cache of inlined files as read and measured, for the next count: a file whose size and
 * modification time have not changed is not read again. Thread-safe.
 */
final class GeometryMeasurementCache {
  private record CacheEntry(String stamp, SceneFile file) {}

  private final Map<String, CacheEntry> files = new ConcurrentHashMap<>();

  /** Returns the cached file if it has not changed since. */
  Optional<SceneFile> find(UrlContent content) {
    CacheEntry kept = files.get(content.key());
    return kept == null || !stamp(content).equals(Optional.of(kept.stamp))
        ? Optional.empty()
        : Optional.of(kept.file);
  }

  /**
   * Adds a file.
   *
   * @param stamp stamp of the file before it was read
   */
  void keep(UrlContent content, Optional<String> stamp, SceneFile file) {
    stamp.ifPresent(known -> files.put(content.key(), new CacheEntry(known, file)));
  }

  /**
   * Returns a stamp of the state of a file (modification time and size); empty for content that is
   * not a file, which is not cached.
   */
  static Optional<String> stamp(UrlContent content) {
    return content.file().flatMap(GeometryMeasurementCache::stamp);
  }

  private static Optional<String> stamp(Path file) {
    try {
      return Optional.of(Files.getLastModifiedTime(file) + "/" + Files.size(file));
    } catch (IOException e) {
      return Optional.empty(); // The file is missing; opening it reports that.
    }
  }
}
