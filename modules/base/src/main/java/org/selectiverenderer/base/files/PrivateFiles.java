package org.selectiverenderer.base.files;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.OpenOption;
import java.nio.file.Path;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Set;

/**
 * Creates files and folders of what is known about people: from their first byte on, only the
 * account that made them reads them (modes 0600 and 0700), whatever the umask says. What exists
 * keeps its permissions. On Windows a file has the permissions of its folder, as all others.
 */
public final class PrivateFiles {
  private PrivateFiles() {}

  /** Opens a file as {@link FileChannel#open} does; a file that it creates is private. */
  public static FileChannel open(Path file, OpenOption... options) throws IOException {
    return FileChannel.open(file, Set.of(options), attributes(file, "rw-------"));
  }

  /** Creates a folder, and those above it that do not exist; all of them are private. */
  public static void createFolders(Path folder) throws IOException {
    Files.createDirectories(folder, attributes(folder, "rwx------"));
  }

  /**
   * Creates folders one in the other, each of which is private and no link to another place.
   *
   * @param start an existing folder, which may be a link
   * @param inside a relative path
   * @throws IOException with one line if there is a link or a file in the way
   */
  public static void createFoldersIn(Path start, Path inside) throws IOException {
    Path folder = start;
    for (Path name : inside) {
      folder = folder.resolve(name);
      requireNoLink(folder);
      if (!Files.isDirectory(folder, LinkOption.NOFOLLOW_LINKS)) {
        Files.createDirectory(folder, attributes(folder, "rwx------"));
      }
    }
  }

  /**
   * Requires a path to be no symbolic link.
   *
   * @throws IOException with one line that names it and its target
   */
  public static void requireNoLink(Path path) throws IOException {
    if (Files.isSymbolicLink(path)) {
      throw new IOException(
          "%s is a link to %s; what is known of participants stays in the study's folder, so move it there"
              .formatted(path, Files.readSymbolicLink(path)));
    }
  }

  static FileAttribute<?>[] attributes(Path path, String mode) {
    boolean posix = path.getFileSystem().supportedFileAttributeViews().contains("posix");
    return posix
        ? new FileAttribute<?>[] {
          PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString(mode))
        }
        : new FileAttribute<?>[0];
  }
}
