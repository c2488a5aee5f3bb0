package org.selectiverenderer.base.problem;

import java.util.Locale;
import java.util.Optional;

/** Suggests the intended name for a misspelt one, and puts the article before a name. */
public final class SpellingSuggester {
  /** Letters whose names begin with a vowel: an LOD, an X3D file. */
  private static final String SPOKEN_WITH_VOWEL = "AEFHILMNORSX";

  private SpellingSuggester() {}

  /**
   * Returns the name of a node or field type with its indefinite article: {@code an Inline}, {@code
   * a Box}. A name that begins with two capitals is pronounced letter by letter: {@code an LOD}.
   */
  public static String one(String name) {
    boolean spelt =
        name.length() > 1
            && Character.isUpperCase(name.charAt(0))
            && !Character.isLowerCase(name.charAt(1));
    String vowels = spelt ? SPOKEN_WITH_VOWEL : "AEIOaeio";
    return (!name.isEmpty() && vowels.indexOf(name.charAt(0)) >= 0 ? "an " : "a ") + name;
  }

  /**
   * Returns the candidate most similar to a misspelt name, if at most a third of the letters
   * differ. Letter case is ignored, since it is the most common mistake.
   */
  public static Optional<String> nearest(String name, Iterable<String> candidates) {
    return nearest(name, candidates, Integer.MAX_VALUE);
  }

  /**
   * Returns the candidate most similar to a misspelt name, within a maximum edit distance.
   *
   * @param slips the maximum edit distance, ignoring letter case
   */
  public static Optional<String> nearest(String name, Iterable<String> candidates, int slips) {
    String wanted = name.toLowerCase(Locale.ROOT);
    int limit = Math.min(slips, Math.max(1, wanted.length() / 3));
    String best = null;
    for (String candidate : candidates) {
      int length = candidate.length();
      if (Math.abs(length - wanted.length()) > limit) {
        continue;
      }
      int distance = distance(wanted, candidate.toLowerCase(Locale.ROOT));
      boolean better = distance < limit || (best == null && distance == limit);
      if (better) {
        best = candidate;
        limit = distance;
        if (distance == 0) {
          break;
        }
      }
    }
    return Optional.ofNullable(best);
  }

  /** Returns the Damerau-Levenshtein distance (optimal string alignment). */
  private static int distance(String a, String b) {
    int[] before = new int[b.length() + 1];
    int[] above = new int[b.length() + 1];
    int[] row = new int[b.length() + 1];
    for (int j = 0; j < row.length; j++) {
      row[j] = j;
    }
    for (int i = 1; i <= a.length(); i++) {
      int[] oldest = before;
      before = above;
      above = row;
      row = oldest;
      row[0] = i;
      for (int j = 1; j <= b.length(); j++) {
        int replaced = above[j - 1] + (a.charAt(i - 1) == b.charAt(j - 1) ? 0 : 1);
        row[j] = Math.min(replaced, 1 + Math.min(above[j], row[j - 1]));
        boolean swapped =
            i > 1
                && j > 1
                && a.charAt(i - 1) == b.charAt(j - 2)
                && a.charAt(i - 2) == b.charAt(j - 1);
        if (swapped) {
          row[j] = Math.min(row[j], 1 + before[j - 2]);
        }
      }
    }
    return row[b.length()];
  }
}
