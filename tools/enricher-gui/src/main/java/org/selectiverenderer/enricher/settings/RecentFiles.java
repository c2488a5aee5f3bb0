package org.selectiverenderer.enricher.settings;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** The recently opened files, the latest first. */
public final class RecentFiles {
  private static final int MOST = 10;

  private final EnricherSettings settings;

  public RecentFiles(EnricherSettings settings) {
    this.settings = settings;
  }

  public List<Path> list() {
    List<Path> files = new ArrayList<>();
    for (int i = 0; i < MOST; i++) {
      String name = settings.word("recent." + i, "");
      if (!name.isEmpty()) {
        files.add(Path.of(name));
      }
    }
    return files;
  }

  /** Puts a file first. */
  public void add(Path file) {
    List<Path> files = list();
    Path absolute = file.toAbsolutePath().normalize();
    files.remove(absolute);
    files.add(0, absolute);
    for (int i = 0; i < MOST; i++) {
      settings.put("recent." + i, i < files.size() ? files.get(i) : "");
    }
  }
}
