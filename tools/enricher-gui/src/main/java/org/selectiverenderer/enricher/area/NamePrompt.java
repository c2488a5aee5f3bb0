package org.selectiverenderer.enricher.area;

import java.util.Optional;
import java.util.function.Function;

/** Asks the author for a node name. */
@FunctionalInterface
public interface NamePrompt {
  /**
   * Asks until the name is valid or the author cancels.
   *
   * @param title what is being named
   * @param proposal a name that no node has yet
   * @param complaint returns why a name is invalid; empty for a valid one
   * @return empty if the author cancels
   */
  Optional<String> ask(String title, String proposal, Function<String, Optional<String>> complaint);
}
