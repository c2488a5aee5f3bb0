package org.selectiverenderer.base.trust;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.selectiverenderer.base.files.AtomicFileWriter;

/**
 * The answers of the user, in one file of the user's own settings folder: a line for each request
 * that the user has agreed to, with its digest and the folder for people. A line that is deleted is
 * asked about again. Never in the folder of the study, where a sender could write it.
 */
public final class TrustStore {
  /** The name of the file. */
  public static final String NAME = "trusted";

  private final Path file;

  /**
   * @param settings folder of the user's settings; created with the first answer
   */
  public TrustStore(Path settings) {
    file = settings.resolve(NAME);
  }

  /** Returns whether the user has agreed to each; a file that cannot be read is empty. */
  public boolean remembers(PermissionRequests requests) {
    try {
      return requests.isEmpty()
          || Files.isRegularFile(file) && known().containsAll(requests.digests());
    } catch (IOException e) {
      return false;
    }
  }

  /**
   * Remembers that the user agrees.
   *
   * @throws IOException if the file cannot be written
   */
  public void remember(PermissionRequests requests) throws IOException {
    if (remembers(requests)) {
      return;
    }
    create();
    Set<String> known = known();
    List<String> all = new ArrayList<>(lines());
    for (String digest : requests.digests()) {
      if (!known.contains(digest)) {
        all.add(digest + " " + requests.folder().toString().replaceAll("\\p{Cntrl}", "?"));
      }
    }
    String text = all.stream().map(line -> line + "\n").collect(Collectors.joining());
    AtomicFileWriter.replace(file, text.getBytes(StandardCharsets.UTF_8));
  }

  private Set<String> known() throws IOException {
    return lines().stream().map(line -> line.split(" ", 2)[0]).collect(Collectors.toSet());
  }

  private List<String> lines() throws IOException {
    return Files.readString(file, StandardCharsets.UTF_8).lines().toList();
  }

  /** Creates the file for its owner alone where the file system knows owners. */
  private void create() throws IOException {
    Path folder = file.toAbsolutePath().getParent();
    Files.createDirectories(folder, ownersOnly(folder, "rwx------"));
    try {
      Files.createFile(file, ownersOnly(folder, "rw-------"));
    } catch (FileAlreadyExistsException e) {
      return; // of an earlier answer; it keeps its permissions
    }
  }

  private static FileAttribute<?>[] ownersOnly(Path folder, String permissions) {
    return folder.getFileSystem().supportedFileAttributeViews().contains("posix")
        ? new FileAttribute<?>[] {
          PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString(permissions))
        }
        : new FileAttribute<?>[0];
  }
}
