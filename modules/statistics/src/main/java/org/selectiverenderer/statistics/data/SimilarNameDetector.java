package org.selectiverenderer.statistics.data;

import java.text.Normalizer;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import org.selectiverenderer.base.decimal.Pluralizer;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.base.problem.SpellingSuggester;

/**
 * Detects names of one kind that are probably two spellings of one name: {@code A} beside {@code
 * a}, {@code high low} beside {@code high-low}, {@code selectve} beside {@code selective}. Nothing
 * is merged, since only the author of the file knows what was meant.
 */
final class SimilarNameDetector {
  /** Names shorter than this may differ by a letter on purpose. */
  private static final int SHORT = 4;

  /** A misspelling has at most this share of the participants of the correct name. */
  private static final double SLIP_SHARE = 0.25;

  /** The participants that use a name, and its first location. */
  private static final class Use {
    final SourceLocation first;
    final Set<String> participants = new HashSet<>();

    Use(SourceLocation first) {
      this.first = first;
    }
  }

  private final String kind;
  private final Map<String, Use> uses = new LinkedHashMap<>();

  /**
   * Creates a detector without names.
   *
   * @param kind what is named, such as {@code condition}
   */
  SimilarNameDetector(String kind) {
    this.kind = kind;
  }

  /** Adds a name from a row of a participant. */
  void add(String name, String participant, SourceLocation place) {
    uses.computeIfAbsent(name, first -> new Use(place)).participants.add(participant);
  }

  /**
   * Reports similar names, each at the first location of the one that fewer participants use.
   *
   * @param done how the analysis treats them, such as {@code they are analysed as two conditions}
   */
  void tell(ExclusionLog exclusions, String done) {
    List<String> names = new ArrayList<>(uses.keySet());
    for (int i = 0; i < names.size(); i++) {
      for (int j = 0; j < i; j++) {
        String one = names.get(j);
        String other = names.get(i);
        boolean fewer = count(one) < count(other);
        String rare = fewer ? one : other;
        String common = fewer ? other : one;
        if (folded(one).equals(folded(other))) {
          exclusions.error(place(rare), "", alike(rare, common, "looks like", done));
        } else if (slip(rare, common)) {
          exclusions.warning(
              place(rare), "", alike(rare, common, "differs by a letter from", done));
        }
      }
    }
  }

  /** Reports names that only one participant uses, where other names have several. */
  void tellLone(ExclusionLog exclusions) {
    if (uses.values().stream().noneMatch(use -> use.participants.size() > 1)) {
      return;
    }
    uses.forEach(
        (name, use) -> {
          if (use.participants.size() == 1) {
            exclusions.warning(
                use.first,
                "",
                "the %s %s has one participant only, so its standard deviation is undefined"
                    .formatted(kind, name));
          }
        });
  }

  private String alike(String rare, String common, String how, String done) {
    return "the %s '%s' (%s) %s '%s' (%s, first in line %d); %s; write both alike if they are one"
        .formatted(
            kind,
            rare,
            Pluralizer.of(count(rare), "participant"),
            how,
            common,
            count(common),
            place(common).line(),
            done);
  }

  private int count(String name) {
    return use(name).participants.size();
  }

  private SourceLocation place(String name) {
    return use(name).first;
  }

  private Use use(String name) {
    Use use = uses.get(name);
    if (use == null) {
      throw new IllegalArgumentException("no " + kind + " " + name);
    }
    return use;
  }

  /**
   * Normalises a name: without case, diacritics, white space, hyphens and leading zeros of numbers.
   */
  private static String folded(String name) {
    return Normalizer.normalize(name, Normalizer.Form.NFKC)
        .toLowerCase(Locale.ROOT)
        .replaceAll("[\\s_\\p{Pd}]+", "")
        .replaceAll("(?<!\\d)0+(?=\\d)", "");
  }

  /**
   * Returns whether a name is rare and differs from another by one letter; names that differ in
   * digits only are distinct.
   */
  private boolean slip(String rare, String common) {
    return rare.length() >= SHORT
        && common.length() >= SHORT
        && count(rare) <= Math.max(1, SLIP_SHARE * count(common))
        && count(rare) < count(common)
        && !rare.replaceAll("\\d", "").equals(common.replaceAll("\\d", ""))
        && SpellingSuggester.nearest(rare, List.of(common), 1).isPresent();
  }
}
