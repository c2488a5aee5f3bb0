package org.selectiverenderer.enricher;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.selectiverenderer.base.files.FileFinder;
import org.selectiverenderer.base.files.FileTransaction;

/** The endings by which programs know a scene's file. */
final class SceneEnding {
  private static final String PLAIN = ".x3d";
  private static final String PACKED = ".x3dz";

  /** What a scene may be called besides, where somebody says that a file is one. */
  private static final List<String> OTHERS = List.of(".x3d.gz", ".xml", ".json", ".html");

  private SceneEnding() {}

  /**
   * A file's name with the ending of a scene, where it has none of one: without it other programs,
   * and the lists of files, would not take it for a scene.
   *
   * @param named by the author
   * @param now the scene's file so far; a compressed one stays one
   */
  static Path added(Path named, Path now) {
    if (known(named) || named.toAbsolutePath().equals(now) || FileTransaction.sink(named)) {
      return named;
    }
    boolean packed = lower(now).endsWith(PACKED);
    return named.resolveSibling(named.getFileName() + (packed ? PACKED : PLAIN));
  }

  private static boolean known(Path file) {
    String name = lower(file);
    return FileFinder.SCENES.endings().stream().anyMatch(name::endsWith)
        || OTHERS.stream().anyMatch(name::endsWith);
  }

  private static String lower(Path file) {
    return String.valueOf(file.getFileName()).toLowerCase(Locale.ROOT);
  }
}
