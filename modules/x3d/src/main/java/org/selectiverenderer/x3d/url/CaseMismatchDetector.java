package org.selectiverenderer.x3d.url;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Finds files whose names differ from that of a missing file in letter case only. Each folder is
 * listed once, as a scene may refer to very many missing files. Thread-safe.
 */
final class CaseMismatchDetector {
  private final Map<Path, Map<String, List<String>>> listed = new ConcurrentHashMap<>();

  /** Returns a hint at a file whose name differs in letter case only; else "". */
  String of(Path path) {
    Path parent = path.getParent();
    Path name = path.getFileName();
    if (parent == null || name == null) {
      return "";
    }
    return listed
        .computeIfAbsent(parent, CaseMismatchDetector::list)
        .getOrDefault(folded(name.toString()), List.of())
        .stream()
        .filter(file -> file.equalsIgnoreCase(name.toString()) && !file.equals(name.toString()))
        .min(String::compareTo)
        .map(file -> " (there is " + file + ", which differs in upper and lower case)")
        .orElse("");
  }

  /** Returns the names in a folder by their case-folded form. */
  private static Map<String, List<String>> list(Path folder) {
    if (!Files.isDirectory(folder)) {
      return Map.of();
    }
    try (Stream<Path> files = Files.list(folder)) {
      return files
          .map(file -> String.valueOf(file.getFileName()))
          .collect(Collectors.groupingBy(CaseMismatchDetector::folded));
    } catch (IOException e) {
      return Map.of(); // no hint if the folder cannot be listed
    }
  }

  private static String folded(String name) {
    return name.toUpperCase(Locale.ROOT).toLowerCase(Locale.ROOT);
  }
}
