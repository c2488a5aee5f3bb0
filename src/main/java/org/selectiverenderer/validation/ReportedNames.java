package org.selectiverenderer.validation;

import java.nio.file.Path;

/** Names of files in reports, the same on every machine. */
public final class ReportedNames {
  private ReportedNames() {}

  /** A path from a folder, with forward slashes; the name alone where no relative path leads. */
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
