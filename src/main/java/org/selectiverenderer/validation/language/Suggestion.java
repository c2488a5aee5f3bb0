package org.selectiverenderer.validation.language;

import java.util.Collection;
import org.selectiverenderer.base.problem.Spelling;

/**
 * The question whether another name was meant, as the end of a message; empty if no candidate is
 * near. It is looked for when the message is written, since a file may have a million slips.
 */
record Suggestion(String name, Collection<String> candidates) {
  private static final int LONGEST = 100;

  /** Thousands of slips among thousands of names are no author's. */
  private static final int MOST_CANDIDATES = 2000;

  static Suggestion of(String name, Collection<String> candidates) {
    return new Suggestion(name, candidates);
  }

  @Override
  public String toString() {
    return name.length() > LONGEST || candidates.size() > MOST_CANDIDATES
        ? ""
        : Spelling.nearest(name, candidates).map(near -> "; did you mean " + near + "?").orElse("");
  }
}
