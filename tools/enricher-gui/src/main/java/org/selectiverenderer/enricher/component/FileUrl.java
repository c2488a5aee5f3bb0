package org.selectiverenderer.enricher.component;

import java.nio.file.Path;
import java.util.Objects;
import org.selectiverenderer.x3d.url.UrlRelativizer;

/** The url by which a scene names a file that an author has chosen. */
public final class FileUrl {
  private FileUrl() {}

  /** Returns the way from the scene's folder to a file; a file URL if there is none. */
  public static String of(Path scene, Path file) {
    Path folder = scene.toAbsolutePath().getParent();
    Path path = file.toAbsolutePath().normalize();
    boolean near = folder != null && Objects.equals(folder.getRoot(), path.getRoot());
    return near ? UrlRelativizer.between(folder, path) : path.toUri().toString();
  }
}
