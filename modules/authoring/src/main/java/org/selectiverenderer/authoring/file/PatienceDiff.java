package org.selectiverenderer.authoring.file;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Matches the lines of two texts by patience diff (B. Cohen): lines that occur once in both texts
 * are matched first, in their longest increasing subsequence, then the parts between them
 * recursively; small parts without such lines are matched by their longest common subsequence.
 */
final class PatienceDiff {
  private static final long SMALL = 1_000_000;

  private final int[] before;
  private final int[] after;
  private final int[] partner;

  private PatienceDiff(int[] before, int[] after) {
    this.before = before;
    this.after = after;
    this.partner = new int[before.length];
    Arrays.fill(partner, -1);
  }

  /** Returns for each line of the first text the index of its match in the second, or -1. */
  static int[] of(List<String> before, List<String> after) {
    Map<String, Integer> numbers = new HashMap<>();
    PatienceDiff matching = new PatienceDiff(numbered(before, numbers), numbered(after, numbers));
    matching.match(0, before.size(), 0, after.size());
    return matching.partner;
  }

  private static int[] numbered(List<String> lines, Map<String, Integer> numbers) {
    int[] numbered = new int[lines.size()];
    for (int i = 0; i < numbered.length; i++) {
      Integer known = numbers.putIfAbsent(lines.get(i), numbers.size());
      numbered[i] = known == null ? numbers.size() - 1 : known;
    }
    return numbered;
  }

  private void match(int a, int aEnd, int b, int bEnd) {
    while (a < aEnd && b < bEnd && before[a] == after[b]) {
      partner[a++] = b++;
    }
    while (a < aEnd && b < bEnd && before[aEnd - 1] == after[bEnd - 1]) {
      partner[--aEnd] = --bEnd;
    }
    if (a == aEnd || b == bEnd) {
      return;
    }
    List<int[]> anchors = anchors(a, aEnd, b, bEnd);
    if (anchors.isEmpty()) {
      if ((long) (aEnd - a) * (bEnd - b) <= SMALL) {
        subsequence(a, aEnd, b, bEnd);
      }
      return;
    }
    for (int[] anchor : anchors) {
      match(a, anchor[0], b, anchor[1]);
      partner[anchor[0]] = anchor[1];
      a = anchor[0] + 1;
      b = anchor[1] + 1;
    }
    match(a, aEnd, b, bEnd);
  }

  /**
   * Returns the pairs of lines that occur once in both parts, in their longest increasing
   * subsequence.
   */
  private List<int[]> anchors(int a, int aEnd, int b, int bEnd) {
    Map<Integer, int[]> seen = new HashMap<>();
    for (int i = a; i < aEnd; i++) {
      int[] found = seen.computeIfAbsent(before[i], key -> new int[] {0, 0, -1, -1});
      found[0]++;
      found[2] = i;
    }
    for (int i = b; i < bEnd; i++) {
      int[] found = seen.get(after[i]);
      if (found != null) {
        found[1]++;
        found[3] = i;
      }
    }
    List<int[]> pairs = new ArrayList<>();
    for (int i = a; i < aEnd; i++) {
      int[] found = seen.get(before[i]);
      if (found[0] == 1 && found[1] == 1) {
        pairs.add(new int[] {i, found[3]});
      }
    }
    return longestRise(pairs);
  }

  /** Returns the longest increasing subsequence of pairs that are sorted by their first number. */
  private static List<int[]> longestRise(List<int[]> pairs) {
    int[] tails = new int[pairs.size()];
    int[] previous = new int[pairs.size()];
    int length = 0;
    for (int i = 0; i < pairs.size(); i++) {
      int low = 0;
      int high = length;
      while (low < high) {
        int middle = (low + high) >>> 1;
        if (pairs.get(tails[middle])[1] < pairs.get(i)[1]) {
          low = middle + 1;
        } else {
          high = middle;
        }
      }
      previous[i] = low == 0 ? -1 : tails[low - 1];
      tails[low] = i;
      length = Math.max(length, low + 1);
    }
    int[][] rise = new int[length][];
    for (int i = length - 1, at = length == 0 ? -1 : tails[length - 1]; i >= 0; i--) {
      rise[i] = pairs.get(at);
      at = previous[at];
    }
    return List.of(rise);
  }

  private void subsequence(int a, int aEnd, int b, int bEnd) {
    int n = aEnd - a;
    int m = bEnd - b;
    int[][] best = new int[n + 1][m + 1];
    for (int i = n - 1; i >= 0; i--) {
      for (int j = m - 1; j >= 0; j--) {
        best[i][j] =
            before[a + i] == after[b + j]
                ? best[i + 1][j + 1] + 1
                : Math.max(best[i + 1][j], best[i][j + 1]);
      }
    }
    for (int i = 0, j = 0; i < n && j < m; ) {
      if (before[a + i] == after[b + j]) {
        partner[a + i++] = b + j++;
      } else if (best[i + 1][j] >= best[i][j + 1]) {
        i++;
      } else {
        j++;
      }
    }
  }
}
