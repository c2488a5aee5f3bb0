package org.selectiverenderer.x3d.url;

import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/**
 * Collects the local files to which the urls of scenes refer, so that no output overwrites one of
 * them. Thread-safe.
 */
public final class ReferencedFiles {
  private final Set<Path> files = ConcurrentHashMap.newKeySet();

  void add(Path real) {
    files.add(real);
  }

  /** Returns the real paths in order. */
  public List<Path> list() {
    return files.stream().sorted().toList();
  }
}
