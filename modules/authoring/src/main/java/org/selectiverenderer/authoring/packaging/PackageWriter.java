package org.selectiverenderer.authoring.packaging;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.DoubleConsumer;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.selectiverenderer.base.files.FileWriteException;

/** Writes the files of a package into a folder or a zip archive. */
public final class PackageWriter {
  /** The time of all entries of archives, so that the same files give the same archive. */
  private static final long TIME = 315_619_200_000L;

  private static final int CHUNK = 1 << 20;

  private PackageWriter() {}

  /**
   * Returns the files of a folder that would be replaced by others of the same name, but with other
   * content.
   */
  public static List<Path> conflicts(List<PackagedFile> files, Path folder) throws IOException {
    List<Path> found = new ArrayList<>();
    for (PackagedFile file : files) {
      Path place = folder.resolve(file.target());
      if (Files.exists(place, LinkOption.NOFOLLOW_LINKS) && !same(file, place)) {
        found.add(place);
      }
    }
    return found;
  }

  /**
   * Writes files into a folder, which is created; all or none. Files with the same content stay as
   * they are. What is replaced lies in a hidden folder there until the result is kept or withdrawn.
   *
   * @param progress receives the share that is done, from 0 to 1, and may throw to end the work
   * @throws IOException if one cannot be written, or would come to lie outside of the folder by a
   *     link; with a sentence
   */
  public static WrittenFiles intoFolder(
      List<PackagedFile> files, Path folder, DoubleConsumer progress) throws IOException {
    try {
      return new FolderTransaction(folder, progress).write(files);
    } catch (FileSystemException e) {
      throw FileWriteException.explained(folder, e);
    }
  }

  /** Refuses a folder in which a file would be replaced that is itself still to be copied. */
  static void keepSources(List<PackagedFile> files, Path real) throws IOException {
    Set<Path> sources = new HashSet<>();
    for (PackagedFile file : files) {
      if (file.changed().isEmpty()) {
        sources.add(file.source().toRealPath());
      }
    }
    for (PackagedFile file : files) {
      Path place = real.resolve(file.target()).normalize();
      if (Files.exists(place) && sources.contains(place.toRealPath()) && !same(file, place)) {
        throw new IOException(
            place + ": is a file of the scene and would be replaced; choose another folder");
      }
    }
  }

  /**
   * Returns an unused name for a file that is not complete. Unlike a temporary file of Java it is
   * not for the user alone.
   */
  static Path part(Path place) {
    Path next = place.resolveSibling(".package.part");
    for (int i = 2; Files.exists(next, LinkOption.NOFOLLOW_LINKS); i++) {
      next = place.resolveSibling(".package-" + i + ".part");
    }
    return next;
  }

  static boolean same(PackagedFile file, Path place) throws IOException {
    if (!Files.isRegularFile(place, LinkOption.NOFOLLOW_LINKS)
        || Files.size(place) != file.size()) {
      return false;
    }
    try (InputStream one = new BufferedInputStream(file.open());
        InputStream other = new BufferedInputStream(Files.newInputStream(place))) {
      int read;
      do {
        read = one.read();
        if (read != other.read()) {
          return false;
        }
      } while (read >= 0);
      return true;
    }
  }

  /**
   * Writes files into a zip archive, which takes the place of an existing file when it is complete;
   * that file lies in a hidden folder there until the result is kept or withdrawn.
   *
   * @param progress receives the share that is done, from 0 to 1, and may throw to end the work
   */
  public static WrittenFiles intoZip(List<PackagedFile> files, Path zip, DoubleConsumer progress)
      throws IOException {
    try {
      return zipped(files, zip, progress);
    } catch (FileSystemException e) {
      throw FileWriteException.explained(zip, e);
    }
  }

  private static WrittenFiles zipped(List<PackagedFile> files, Path zip, DoubleConsumer progress)
      throws IOException {
    if (Files.isDirectory(zip)) {
      throw new IOException(zip + ": is a folder, and is not replaced by a file");
    }
    WrittenFiles log = new WrittenFiles();
    try {
      Path stage = log.stage(zip.toAbsolutePath().getParent());
      Path next = stage.resolve("new");
      try (ZipOutputStream out =
          new ZipOutputStream(Files.newOutputStream(next, StandardOpenOption.CREATE_NEW))) {
        for (int i = 0; i < files.size(); i++) {
          ZipEntry entry = new ZipEntry(files.get(i).target().toString().replace('\\', '/'));
          entry.setTime(TIME);
          out.putNextEntry(entry);
          try (InputStream in = files.get(i).open()) {
            byte[] chunk = new byte[CHUNK];
            for (int read = in.read(chunk); read >= 0; read = in.read(chunk)) {
              out.write(chunk, 0, read);
              progress.accept((double) i / files.size());
            }
          }
          out.closeEntry();
          progress.accept((i + 1.0) / files.size());
        }
      }
      log.exchange(
          next,
          zip,
          Files.exists(zip, LinkOption.NOFOLLOW_LINKS)
              ? Optional.of(WrittenFiles.former(stage, zip.getFileName()))
              : Optional.empty());
      return log.complete();
    } catch (IOException | RuntimeException | Error e) {
      log.withdrawBecause(e);
      throw e;
    }
  }
}
