package org.selectiverenderer.authoring.file;

import java.util.ArrayList;
import java.util.List;

/**
 * The difference of two texts in the unified format, as {@code diff -u} writes and patch reads it.
 */
public final class UnifiedDiff {
  private static final int CONTEXT = 3;

  /** A line of the output, which is in both texts or in one. */
  private record Line(char kind, String text, int before, int after) {}

  private UnifiedDiff() {}

  /**
   * @param name name of the old file
   * @return empty when the texts are the same; lines end with LF
   */
  public static String of(String name, String nameAfter, String before, String after) {
    List<Line> lines = lines(LineTokenizer.of(before), LineTokenizer.of(after));
    StringBuilder diff = new StringBuilder();
    int at = 0;
    while ((at = nextChange(lines, at)) < lines.size()) {
      if (diff.length() == 0) {
        diff.append("--- ").append(name).append("\n+++ ").append(nameAfter).append('\n');
      }
      int from = Math.max(0, at - CONTEXT);
      int end = at;
      for (int next = at; next < lines.size() && next - end <= 2 * CONTEXT; ) {
        end = next + 1;
        next = nextChange(lines, end);
      }
      int to = Math.min(lines.size(), end + CONTEXT);
      hunk(lines.subList(from, to), diff);
      at = end;
    }
    return diff.toString();
  }

  private static int nextChange(List<Line> lines, int from) {
    int at = from;
    while (at < lines.size() && lines.get(at).kind() == ' ') {
      at++;
    }
    return at;
  }

  private static List<Line> lines(List<String> before, List<String> after) {
    int[] partner = PatienceDiff.of(before, after);
    List<Line> lines = new ArrayList<>();
    int b = 0;
    for (int a = 0; a < before.size(); a++) {
      if (partner[a] < 0) {
        lines.add(new Line('-', before.get(a), a, b));
        continue;
      }
      for (; b < partner[a]; b++) {
        lines.add(new Line('+', after.get(b), a, b));
      }
      lines.add(new Line(' ', before.get(a), a, b));
      b++;
    }
    for (; b < after.size(); b++) {
      lines.add(new Line('+', after.get(b), before.size(), b));
    }
    return lines;
  }

  private static void hunk(List<Line> lines, StringBuilder diff) {
    Line first = lines.get(0);
    long before = lines.stream().filter(line -> line.kind() != '+').count();
    long after = lines.stream().filter(line -> line.kind() != '-').count();
    diff.append("@@ -").append(range(first.before(), before));
    diff.append(" +").append(range(first.after(), after)).append(" @@\n");
    for (Line line : lines) {
      diff.append(line.kind()).append(line.text());
      if (!line.text().endsWith("\n")) {
        diff.append("\n\\ No newline at end of file\n");
      }
    }
  }

  private static String range(int from, long count) {
    return (count == 0 ? from : from + 1) + (count == 1 ? "" : "," + count);
  }
}
