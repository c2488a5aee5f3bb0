package org.selectiverenderer.experiment.session;

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
import org.selectiverenderer.base.files.Sha256;

/** SHA-256 of files, and of a scene with all that it names. */
public final class Checksums {
  private static final Pattern NAMED =
      Pattern.compile(
          "[\"']([^\"'<>]+\\.(?:x3d|x3dz|png|jpe?g|gif))[\"']", Pattern.CASE_INSENSITIVE);

  private Checksums() {}

  /** Of one file, in hexadecimal. */
  static String of(Path file) throws IOException {
    return Sha256.of(Files.readAllBytes(file));
  }

  /** Of a scene and all files that it, or one of these, names and that are there. */
  public static Map<String, String> ofScene(Path scene) throws IOException {
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
      byte[] bytes = Files.readAllBytes(file);
      sums.put(name, Sha256.of(bytes));
      if (name.endsWith(".x3d")) {
        Matcher found = NAMED.matcher(new String(bytes, StandardCharsets.ISO_8859_1));
        while (found.find()) {
          named(file, found.group(1), left);
        }
      }
    }
    return sums;
  }

  private static void named(Path from, String name, Deque<Path> left) {
    try {
      Path file = from.resolveSibling(name).normalize();
      if (Files.isRegularFile(file)) {
        left.add(file);
      }
    } catch (InvalidPathException e) {
      return; // An address of the network, which nothing is ever read from.
    }
  }
}
