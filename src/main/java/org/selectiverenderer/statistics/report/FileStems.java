package org.selectiverenderer.statistics.report;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Locale;
import java.util.Map;
import java.util.Set;

/**
 * Makes file name stems from names of areas, which may contain any character: letters and digits
 * stay, all else becomes a hyphen. Two areas never share a stem, even on file systems that ignore
 * case.
 */
final class FileStems {
  private final Map<String, String> stems = new HashMap<>();
  private final Set<String> taken = new HashSet<>();

  /** Returns the stem of a name, always the same for the same name. */
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
