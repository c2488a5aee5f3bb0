package org.selectiverenderer.enricher.area;

import java.util.Optional;
import java.util.function.Function;

/** Asks the author for a name. */
@FunctionalInterface
public interface NameQuestion {
  /**
   * Asks until the name is one that can be given.
   *
   * @param title what is being named
   * @param proposal that is free
   * @param complaint why a name cannot be given; empty for one that can
   * @return empty if the author wants none of it
   */
  Optional<String> ask(String title, String proposal, Function<String, Optional<String>> complaint);
}
