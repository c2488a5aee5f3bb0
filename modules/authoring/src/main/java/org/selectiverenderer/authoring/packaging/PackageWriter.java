package org.selectiverenderer.authoring.packaging;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.DoubleConsumer;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;

/** Writes the files of a package into a folder or a zip archive. */
public final class PackageWriter {
  /** The time of all entries of archives, so that the same files give the same archive. */
  private static final long TIME = 315_619_200_000L;

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
   * Writes files into a folder, which is created. Files with the same content stay as they are.
   *
   * @param progress receives the share that is done, from 0 to 1
   * @throws IOException if one cannot be written, or would come to lie outside of the folder by a
   *     link; with a sentence
   */
  public static void intoFolder(List<PackagedFile> files, Path folder, DoubleConsumer progress)
      throws IOException {
    Files.createDirectories(folder);
    Path real = folder.toRealPath();
    keepSources(files, real);
    for (int i = 0; i < files.size(); i++) {
      PackagedFile file = files.get(i);
      Path place = real.resolve(file.target()).normalize();
      if (!place.startsWith(real)) {
        throw outside(place, folder);
      }
      createParents(place, real, folder);
      if (!Files.exists(place, LinkOption.NOFOLLOW_LINKS) || !same(file, place)) {
        copy(file, place);
      }
      progress.accept((i + 1.0) / files.size());
    }
  }

  /** Refuses a folder in which a file would be replaced that is itself still to be copied. */
  private static void keepSources(List<PackagedFile> files, Path real) throws IOException {
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

  /** Creates the folders of a file one by one; none of them may be a link that leads outside. */
  private static void createParents(Path place, Path real, Path folder) throws IOException {
    Path at = real;
    for (Path part : real.relativize(place.getParent())) {
      at = at.resolve(part);
      if (!Files.isDirectory(at) && !part.toString().isEmpty()) {
        Files.createDirectory(at);
      }
      if (!at.toRealPath().startsWith(real)) {
        throw outside(at, folder);
      }
    }
  }

  private static IOException outside(Path place, Path folder) {
    return new IOException(place + ": lies outside of " + folder + ", and is not written");
  }

  private static void copy(PackagedFile file, Path place) throws IOException {
    Path next = part(place);
    try {
      try (InputStream in = file.open();
          OutputStream out = Files.newOutputStream(next, StandardOpenOption.CREATE_NEW)) {
        in.transferTo(out);
      }
      Files.move(next, place, StandardCopyOption.REPLACE_EXISTING);
    } finally {
      Files.deleteIfExists(next);
    }
  }

  /**
   * Returns an unused name for a file that is not complete. Unlike a temporary file of Java it is
   * not for the user alone.
   */
  private static Path part(Path place) {
    Path next = place.resolveSibling(".package.part");
    for (int i = 2; Files.exists(next, LinkOption.NOFOLLOW_LINKS); i++) {
      next = place.resolveSibling(".package-" + i + ".part");
    }
    return next;
  }

  private static boolean same(PackagedFile file, Path place) throws IOException {
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
   * Writes files into a zip archive, which takes the place of an existing file when it is complete.
   *
   * @param progress receives the share that is done, from 0 to 1
   */
  public static void intoZip(List<PackagedFile> files, Path zip, DoubleConsumer progress)
      throws IOException {
    Path next = part(zip.toAbsolutePath());
    try {
      try (ZipOutputStream out =
          new ZipOutputStream(Files.newOutputStream(next, StandardOpenOption.CREATE_NEW))) {
        for (int i = 0; i < files.size(); i++) {
          ZipEntry entry = new ZipEntry(files.get(i).target().toString().replace('\\', '/'));
          entry.setTime(TIME);
          out.putNextEntry(entry);
          try (InputStream in = files.get(i).open()) {
            in.transferTo(out);
          }
          out.closeEntry();
          progress.accept((i + 1.0) / files.size());
        }
      }
      Files.move(next, zip, StandardCopyOption.REPLACE_EXISTING);
    } finally {
      Files.deleteIfExists(next);
    }
  }
}
