package org.selectiverenderer.validation.language;

import java.util.Collection;
import org.selectiverenderer.base.problem.SpellingSuggester;

/**
 * A spelling suggestion ("did you mean ...?") as the end of a message; empty if no candidate is
 * similar. It is computed only when the message is formatted, since a file may have a million
 * errors.
 */
record SpellingSuggestion(String name, Collection<String> candidates) {
  private static final int LONGEST = 100;

  /**
   * With more candidates than this no suggestion is made: such files are generated, and the
   * comparison would take too long.
   */
  private static final int MOST_CANDIDATES = 2000;

  static SpellingSuggestion of(String name, Collection<String> candidates) {
    return new SpellingSuggestion(name, candidates);
  }

  @Override
  public String toString() {
    return name.length() > LONGEST || candidates.size() > MOST_CANDIDATES
        ? ""
        : SpellingSuggester.nearest(name, candidates)
            .map(near -> "; did you mean " + near + "?")
            .orElse("");
  }
}
