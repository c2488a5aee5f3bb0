package org.selectiverenderer.x3d.files;

import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/**
 * The files of this machine that the urls of scenes have meant so far: none of them is to be
 * written over. Thread-safe.
 */
public final class FilesNamed {
  private final Set<Path> files = ConcurrentHashMap.newKeySet();

  void add(Path real) {
    files.add(real);
  }

  /** Their real paths, in order. */
  public List<Path> list() {
    return files.stream().sorted().toList();
  }
}
