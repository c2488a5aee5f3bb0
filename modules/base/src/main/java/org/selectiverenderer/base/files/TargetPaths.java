package org.selectiverenderer.base.files;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFileAttributeView;

/** Resolves the target of a symbolic link, and finds free names for temporary files beside it. */
final class TargetPaths {
  /** The longest chain of symbolic links followed, as on Linux. */
  private static final int MOST_LINKS = 40;

  /** More temporary files than any crashes leave behind. */
  private static final int MOST_NAMES = 10_000;

  private TargetPaths() {}

  /** Returns the file itself, or the target of a link, even if that does not exist yet. */
  static Path target(Path file) throws IOException {
    if (WindowsDeviceName.leadsToDevice(file)) {
      return file.toAbsolutePath().normalize(); // Windows does not tell the real path of a device.
    }
    if (Files.exists(file)) {
      return file.toRealPath();
    }
    Path target = file.toAbsolutePath().normalize();
    for (int links = 0; Files.isSymbolicLink(target); links++) {
      if (links == MOST_LINKS) {
        throw new IOException("it is a link to itself");
      }
      target = target.resolveSibling(Files.readSymbolicLink(target)).normalize();
    }
    return target;
  }

  /**
   * Returns an unused hidden name in the same folder; of a long name, only the start is used.
   *
   * @throws IOException if all names are used
   */
  static Path beside(Path target, String kind) throws IOException {
    String start = FileNameLength.shortened("." + target.getFileName(), kind.length() + 6);
    for (int i = 0; i < MOST_NAMES; i++) {
      Path name = target.resolveSibling(start + "." + kind + i);
      // Not notExists, which is false for whatever cannot be asked for: creating it then says why.
      if (!Files.exists(name, LinkOption.NOFOLLOW_LINKS)) {
        return name;
      }
    }
    throw new IOException("%d temporary files lie beside it; delete them".formatted(MOST_NAMES));
  }

  static void copyPermissions(Path from, Path to) throws IOException {
    PosixFileAttributeView old = Files.getFileAttributeView(from, PosixFileAttributeView.class);
    PosixFileAttributeView made = Files.getFileAttributeView(to, PosixFileAttributeView.class);
    if (old != null && made != null && Files.exists(from)) {
      made.setPermissions(old.readAttributes().permissions());
    }
  }
}
