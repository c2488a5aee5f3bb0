package org.selectiverenderer.x3d.files;

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
 * Finds files whose names differ in letter case only from one that is missing. Each folder is
 * listed once: a scene may name very many files that are missing. Thread-safe.
 */
final class CaseHints {
  private final Map<Path, Map<String, List<String>>> listed = new ConcurrentHashMap<>();

  /** A hint for a name that works on some systems and not on others; else empty. */
  String of(Path path) {
    Path parent = path.getParent();
    Path name = path.getFileName();
    if (parent == null || name == null) {
      return "";
    }
    return listed
        .computeIfAbsent(parent, CaseHints::list)
        .getOrDefault(folded(name.toString()), List.of())
        .stream()
        .filter(file -> file.equalsIgnoreCase(name.toString()) && !file.equals(name.toString()))
        .min(String::compareTo)
        .map(file -> " (there is " + file + ", which differs in upper and lower case)")
        .orElse("");
  }

  /** The names in a folder, by what they are in one case. */
  private static Map<String, List<String>> list(Path folder) {
    if (!Files.isDirectory(folder)) {
      return Map.of();
    }
    try (Stream<Path> files = Files.list(folder)) {
      return files
          .map(file -> String.valueOf(file.getFileName()))
          .collect(Collectors.groupingBy(CaseHints::folded));
    } catch (IOException e) {
      return Map.of(); // It stays without a hint where the folder cannot be listed.
    }
  }

  private static String folded(String name) {
    return name.toUpperCase(Locale.ROOT).toLowerCase(Locale.ROOT);
  }
}
