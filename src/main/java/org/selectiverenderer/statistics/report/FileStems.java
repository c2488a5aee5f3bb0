package org.selectiverenderer.statistics.report;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Locale;
import java.util.Map;
import java.util.Set;

/**
 * Names of files for names of areas, which may hold anything: letters and figures stay, all else is
 * a hyphen. Two names never share one, on disks that tell no case apart either.
 */
final class FileStems {
  private final Map<String, String> stems = new HashMap<>();
  private final Set<String> taken = new HashSet<>();

  /** The same every time for the same name. */
  String of(String name) {
    return stems.computeIfAbsent(name, this::free);
  }

  private String free(String name) {
    String plain =
        name.toLowerCase(Locale.ROOT).replaceAll("[^\\p{L}\\p{N}]+", "-").replaceAll("^-|-$", "");
    String stem = plain.isEmpty() ? "area" : plain;
    String free = stem;
    for (int i = 2; !taken.add(free); i++) {
      free = stem + "-" + i;
    }
    return free;
  }
}
