package org.selectiverenderer.command.trust;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.selectiverenderer.command.output.Console;

/** Shows requests to the user, and asks whether to agree. */
@FunctionalInterface
public interface TrustPrompt {
  /** Asks nobody, where no user is or none may be disturbed. */
  TrustPrompt NOBODY = (sentence, lines) -> Optional.empty();

  /**
   * Asks.
   *
   * @param sentence what asks for more than its folder
   * @param lines what is asked for; what reaches farthest comes first
   * @return the answer; empty if nobody can be asked
   */
  Optional<Boolean> ask(String sentence, List<String> lines);

  /** Returns a prompt that asks by another one where this one can ask nobody. */
  default TrustPrompt or(TrustPrompt other) {
    return (sentence, lines) -> ask(sentence, lines).or(() -> other.ask(sentence, lines));
  }

  /** Returns a prompt on the terminal of the process; it asks nobody where there is none. */
  static TrustPrompt onTerminal(Console console) {
    TrustPrompt prompt = onTerminal(console, console::ask);
    return (sentence, lines) -> console.canAsk() ? prompt.ask(sentence, lines) : Optional.empty();
  }

  /**
   * Returns a prompt that reads answers otherwise; anything but yes is a no.
   *
   * @param read prints a question and returns the line typed; empty at the end of the input
   */
  static TrustPrompt onTerminal(Console console, Function<String, Optional<String>> read) {
    return (sentence, lines) -> {
      console.message(sentence + ":");
      // What reaches farthest comes last here: a list that is long scrolls away from its beginning.
      for (int i = lines.size() - 1; i >= 0; i--) {
        console.message("  " + lines.get(i));
      }
      String all = lines.size() == 1 ? "this" : "all " + lines.size();
      return read.apply(
              "Agree to %s? It is remembered until this list changes. [y/N] ".formatted(all))
          .map(answer -> answer.strip().matches("(?i)y(es)?"));
    };
  }
}
