package org.selectiverenderer.study.session;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.selectiverenderer.base.files.InputFileReader;
import org.selectiverenderer.base.files.Sha256;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;
import org.selectiverenderer.x3d.url.UrlResolver;

/** Computes SHA-256 checksums of files, and of a scene with all files that it refers to. */
public final class FileChecksumCalculator {
  private static final Pattern NAMED =
      Pattern.compile(
          "[\"']([^\"'<>]+\\.(?:x3d|x3dz|png|jpe?g|gif))[\"']", Pattern.CASE_INSENSITIVE);

  private FileChecksumCalculator() {}

  /** Returns the checksum of a file, in hexadecimal. */
  static String of(Path file) throws IOException {
    return Sha256.of(InputFileReader.bytes(file));
  }

  /**
   * Returns the checksums of a scene and, transitively, of all existing files that it refers to and
   * may read, by relative path. A checksum of another file would tell whoever gets the data what is
   * in it.
   *
   * @param access what the user allows the scene to read beyond its own folder and project
   */
  public static Map<String, String> ofScene(Path scene, ContentAccessPolicy access)
      throws IOException {
    UrlResolver own = new UrlResolver(scene.toAbsolutePath().getParent(), access);
    Map<String, String> sums = new TreeMap<>();
    Deque<Path> left = new ArrayDeque<>();
    left.add(scene.toAbsolutePath().normalize());
    while (!left.isEmpty()) {
      Path file = left.remove();
      String name =
          scene.toAbsolutePath().getParent().relativize(file).toString().replace('\\', '/');
      if (sums.containsKey(name)) {
        continue;
      }
      byte[] bytes = InputFileReader.bytes(file);
      sums.put(name, Sha256.of(bytes));
      if (name.endsWith(".x3d")) {
        Matcher found = NAMED.matcher(new String(bytes, StandardCharsets.ISO_8859_1));
        while (found.find()) {
          named(file, found.group(1), own, left);
        }
      }
    }
    return sums;
  }

  private static void named(Path from, String name, UrlResolver own, Deque<Path> left) {
    try {
      Path file = from.resolveSibling(name).normalize();
      if (Files.isRegularFile(file) && own.mayBeNamed(file)) {
        left.add(file);
      }
    } catch (InvalidPathException e) {
      return; // A URL, from which nothing is read.
    }
  }
}
