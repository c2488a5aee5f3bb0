package org.selectiverenderer.enricher;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.selectiverenderer.base.files.FileFinder;
import org.selectiverenderer.base.files.FileTransaction;

/** Adds the file extension of scenes to names that have none. */
final class SceneFileExtension {
  private static final String PLAIN = ".x3d";
  private static final String PACKED = ".x3dz";

  /** Further extensions that are accepted where the author says that a file is a scene. */
  private static final List<String> OTHERS = List.of(".x3d.gz", ".xml", ".json", ".html");

  private SceneFileExtension() {}

  /**
   * Returns a file with the extension of a scene added where it has none: without it other
   * programs, and file dialogs, would not take it for a scene.
   *
   * @param named the file that the author names
   * @param now the scene's present file; a compressed scene gets the extension of compressed ones
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
