package org.selectiverenderer.authoring.file;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

class UnifiedDiffTest {
  private static String diff(String before, String after) {
    return UnifiedDiff.of("a", "b", before, after);
  }

  @Test
  void theSameTextsDoNotDiffer() {
    assertThat(diff("1\n2\n", "1\n2\n")).isEmpty();
  }

  @Test
  void changesStandInThreeLinesOfContextAndFarOnesApart() {
    String before = "1\n2\n3\n4\n5\n6\n7\n8\n9\n10\n11\n12\n";
    String after = "1\nx\n3\n4\n5\n6\n7\n8\n9\n10\n11\n12\n13";
    assertThat(diff(before, after))
        .isEqualTo(
            """
            --- a
            +++ b
            @@ -1,5 +1,5 @@
             1
            -2
            +x
             3
             4
             5
            @@ -10,3 +10,4 @@
             10
             11
             12
            +13
            \\ No newline at end of file
            """);
  }

  @Test
  void emptyTextsHaveNoLines() {
    assertThat(diff("", "1\n")).isEqualTo("--- a\n+++ b\n@@ -0,0 +1 @@\n+1\n");
  }

  /** Myers' algorithm would take seconds and much memory: each line differs. */
  @Test
  void aLongTextIndentedAnewIsComparedWithoutQuadraticWork() {
    List<String> before = new ArrayList<>();
    for (int i = 0; i < 200_000; i++) {
      before.add("<Shape DEF='S" + i + "'/>\n");
    }
    List<String> after = before.stream().map(line -> "  " + line).toList();
    assertThat(PatienceDiff.of(before, after)).hasSize(200_000).containsOnly(-1);
  }

  @Test
  void applyingTheDifferenceGivesTheOtherText() {
    Random random = new Random(7);
    for (int i = 0; i < 300; i++) {
      String before = lines(random);
      String after = lines(random);
      assertThat(patched(before, diff(before, after))).isEqualTo(after);
    }
  }

  private static String lines(Random random) {
    StringBuilder lines = new StringBuilder();
    for (int i = random.nextInt(30); i > 0; i--) {
      lines.append(random.nextInt(12)).append('\n');
    }
    return lines.toString();
  }

  /** What {@code patch} makes of it. */
  private static String patched(String before, String diff) {
    List<String> source = before.lines().toList();
    List<String> result = new ArrayList<>();
    int at = 0;
    for (String line : diff.lines().skip(2).toList()) {
      if (line.startsWith("@@")) {
        String[] range = line.split(" ")[1].substring(1).split(",");
        int start = Integer.parseInt(range[0]) - (range.length > 1 && range[1].equals("0") ? 0 : 1);
        result.addAll(source.subList(at, start));
        at = start;
      } else if (line.charAt(0) == '+') {
        result.add(line.substring(1));
      } else {
        assertThat(source.get(at)).isEqualTo(line.substring(1));
        if (line.charAt(0) == ' ') {
          result.add(line.substring(1));
        }
        at++;
      }
    }
    result.addAll(source.subList(at, source.size()));
    return result.isEmpty() ? "" : String.join("\n", result) + "\n";
  }
}
