package org.selectiverenderer.validation;

import java.nio.file.Path;

/** Makes the names of files in reports, which are the same on every machine. */
public final class ReportFileNames {
  private ReportFileNames() {}

  /**
   * Returns the path relative to a folder, with forward slashes; the file name alone if there is no
   * relative path.
   */
  public static String relative(Path path, Path base) {
    Path absolute = path.toAbsolutePath().normalize();
    Path from = base.toAbsolutePath().normalize();
    Path relative = absolute;
    if (java.util.Objects.equals(absolute.getRoot(), from.getRoot())) {
      relative = from.relativize(absolute);
    }
    return relative.toString().replace('\\', '/');
  }
}
