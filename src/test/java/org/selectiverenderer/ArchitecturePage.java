package org.selectiverenderer;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * What ARCHITECTURE.md says of packages: the drawing of the layers, a code block named {@code
 * layers} with the upper ones first, and the table with what each package uses.
 *
 * @param rows the number of each package's row in the drawing, 0 for the uppermost
 * @param uses what the table lets each package use, {@link #SAI} for the standard's interfaces
 * @param named the same for the packages whose uses are named one by one
 */
record ArchitecturePage(
    Map<String, Integer> rows, Map<String, Set<String>> uses, Map<String, Set<String>> named) {
  /** How the table calls {@code org.web3d.x3d.sai}. */
  static final String SAI = "SAI";

  private static final Pattern DRAWING = Pattern.compile("```layers\\n(.*?)```", Pattern.DOTALL);
  private static final Pattern ROW = Pattern.compile("(?m)^\\|([^|]*)\\|[^|]*\\|([^|]*)\\|$");
  private static final Pattern NAME = Pattern.compile("`([a-z0-9]+)`|\\b(SAI)\\b");

  static ArchitecturePage read() throws IOException {
    String text = Files.readString(Path.of("ARCHITECTURE.md")).replace("\r\n", "\n");
    Matcher drawing = DRAWING.matcher(text);
    if (!drawing.find()) {
      throw new IOException("ARCHITECTURE.md has no drawing of the layers");
    }
    Map<String, Integer> rows = new LinkedHashMap<>();
    int number = 0;
    for (String line : drawing.group(1).lines().toList()) {
      for (String name : line.split("\\W+")) {
        rows.put(name, number);
      }
      number++;
    }
    Map<String, Set<String>> uses = new HashMap<>();
    Map<String, Set<String>> named = new HashMap<>();
    Matcher row = ROW.matcher(text);
    while (row.find()) {
      for (String user : names(row.group(1))) {
        Set<String> used = new TreeSet<>(names(row.group(2)));
        if (row.group(2).contains("all below")) {
          rows.forEach((name, at) -> addIfBelow(rows, user, name, used));
          used.add(SAI);
        } else {
          named.put(user, used);
        }
        uses.put(user, used);
      }
    }
    uses.keySet().retainAll(rows.keySet());
    named.keySet().retainAll(rows.keySet());
    return new ArchitecturePage(rows, uses, named);
  }

  Set<String> layered() {
    return new TreeSet<>(rows.keySet());
  }

  Set<String> described() {
    return new TreeSet<>(uses.keySet());
  }

  boolean allows(String user, String used) {
    return uses.getOrDefault(user, Set.of()).contains(used);
  }

  List<String> usesThatDoNotGoDown() {
    List<String> found = new ArrayList<>();
    uses.forEach(
        (user, all) ->
            all.stream()
                .filter(used -> !used.equals(SAI) && !isBelow(rows, user, used))
                .forEach(used -> found.add(user + " uses " + used)));
    return found;
  }

  private static void addIfBelow(
      Map<String, Integer> rows, String user, String name, Set<String> used) {
    if (isBelow(rows, user, name)) {
      used.add(name);
    }
  }

  private static boolean isBelow(Map<String, Integer> rows, String user, String used) {
    return rows.getOrDefault(used, -1) > rows.getOrDefault(user, Integer.MAX_VALUE);
  }

  private static List<String> names(String cell) {
    List<String> names = new ArrayList<>();
    Matcher name = NAME.matcher(cell);
    while (name.find()) {
      names.add(name.group(1) == null ? name.group(2) : name.group(1));
    }
    return names;
  }
}
