package org.selectiverenderer.base.files;

import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Map;
import java.util.Optional;

/**
 * Makes and checks folders in which nobody can change anything but this user and whoever
 * administers the machine, by the rule that OpenSSH calls StrictModes: the folder and all above it
 * belong to one of these two, and neither their groups nor others may write to them. A folder above
 * may be open to all if it is sticky, as the one of temporary files is, since then nobody can
 * rename what others own in it. On Windows nothing is checked: there a user's folders are closed to
 * others by their inherited access control lists.
 */
public final class PrivateFolder {
  private static final int WRITABLE_BY_OTHERS = 0022;
  private static final int STICKY = 01000;
  private static final int PERMISSIONS = 07777;

  private PrivateFolder() {}

  /**
   * Makes folders of this user alone where they are missing, one inside the other.
   *
   * @param place a folder above, made too where it is missing; may be a link
   * @return the innermost folder, without links
   * @throws IOException if they cannot be made, one of those inside is a link, or others can change
   *     them: with the folder's name and what to do
   */
  public static Path make(Path place, String... inside) throws IOException {
    createAll(place.toAbsolutePath().normalize());
    Path folder = place.toRealPath();
    for (String name : inside) {
      folder = folder.resolve(name);
      create(folder);
      if (!Files.isDirectory(folder, LinkOption.NOFOLLOW_LINKS)) {
        throw new IOException(folder + " is a link or a file, not a folder: delete it");
      }
    }
    Optional<String> fault = fault(folder);
    if (fault.isPresent()) {
      throw new IOException(fault.get());
    }
    return folder;
  }

  private static void createAll(Path folder) throws IOException {
    if (folder.getParent() != null && !Files.exists(folder)) {
      createAll(folder.getParent());
      create(folder);
    }
  }

  private static void create(Path folder) throws IOException {
    if (Files.exists(folder, LinkOption.NOFOLLOW_LINKS)) {
      return;
    }
    boolean posix = folder.getFileSystem().supportedFileAttributeViews().contains("posix");
    try {
      Files.createDirectory(
          folder,
          posix
              ? new FileAttribute<?>[] {
                PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rwx------"))
              }
              : new FileAttribute<?>[0]);
    } catch (FileAlreadyExistsException e) {
      // Another process of this program was as quick; what it is will be looked at.
    } catch (IOException e) {
      throw new IOException(folder + ": the folder cannot be made (" + e.getMessage() + ")", e);
    }
  }

  /**
   * Returns what lets others change a folder, with what to do about it; empty if nothing does.
   *
   * @param folder without links, see {@link Path#toRealPath}
   */
  public static Optional<String> fault(Path folder) throws IOException {
    return fault(folder, user());
  }

  /**
   * Returns the same for another user.
   *
   * @param user number of the user, or empty where the system has none
   */
  static Optional<String> fault(Path folder, Optional<Integer> user) throws IOException {
    if (user.isEmpty()) {
      return Optional.empty();
    }
    for (Path each = folder; each != null; each = each.getParent()) {
      Optional<String> fault = fault(each, user.get(), each.equals(folder));
      if (fault.isPresent()) {
        return fault;
      }
    }
    return Optional.empty();
  }

  private static Optional<String> fault(Path folder, int user, boolean innermost)
      throws IOException {
    Map<String, Object> found = attributes(folder);
    int owner = (Integer) found.get("uid");
    if (owner != user && owner != administrator(folder)) {
      return Optional.of(
          "%s belongs to another user (number %d, not %d): delete it, or have it deleted"
              .formatted(folder, owner, user));
    }
    int mode = (Integer) found.get("mode") & PERMISSIONS;
    boolean open = (mode & WRITABLE_BY_OTHERS) != 0;
    return open && (innermost || (mode & STICKY) == 0)
        ? Optional.of(
            "others may write to %s (mode %04o): type chmod go-w '%s'"
                .formatted(folder, mode, folder))
        : Optional.empty();
  }

  /**
   * Returns whether a regular file, in a folder without fault, belongs to this user or to the
   * administrator and others cannot write to it.
   */
  public static boolean closed(Path file) throws IOException {
    if (!Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS)) {
      return false;
    }
    Optional<Integer> user = user();
    if (user.isEmpty()) {
      return true;
    }
    Map<String, Object> found = attributes(file);
    int owner = (Integer) found.get("uid");
    return (owner == user.get() || owner == administrator(file))
        && ((Integer) found.get("mode") & WRITABLE_BY_OTHERS) == 0;
  }

  /** The owner of the root folder, who can change everything: the number 0 outside containers. */
  private static int administrator(Path file) throws IOException {
    return (Integer) attributes(file.getRoot()).get("uid");
  }

  private static Map<String, Object> attributes(Path file) throws IOException {
    return Files.readAttributes(file, "unix:uid,mode", LinkOption.NOFOLLOW_LINKS);
  }

  /** Returns this user's number: the owner of the process, else of a file that it makes. */
  static Optional<Integer> user() throws IOException {
    Path self = Path.of("/proc/self");
    if (!self.getFileSystem().supportedFileAttributeViews().contains("unix")) {
      return Optional.empty();
    }
    if (Files.exists(self)) {
      return Optional.of((Integer) Files.getAttribute(self, "unix:uid"));
    }
    Path made = Files.createTempFile("selective-renderer", ".owner");
    try {
      return Optional.of((Integer) Files.getAttribute(made, "unix:uid"));
    } finally {
      Files.delete(made);
    }
  }
}
