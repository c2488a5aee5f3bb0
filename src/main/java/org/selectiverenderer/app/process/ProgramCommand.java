package org.selectiverenderer.app.process;

import java.util.List;
import java.util.Optional;
import org.selectiverenderer.command.ProgramInvocation;

/**
 * A command of the program.
 *
 * @param words the arguments, from the command's name on
 */
public record ProgramCommand(List<String> words) {
  public ProgramCommand {
    words = List.copyOf(words);
  }

  /** Returns whether the command opens the enricher or the study window, which are Swing's. */
  boolean opensSwingWindow() {
    List<String> others = words.subList(Math.min(1, words.size()), words.size());
    return switch (words.isEmpty() ? "" : words.get(0)) {
      case "enrich" -> others.stream().allMatch(word -> !word.startsWith("-"));
      case "experiment" -> others.isEmpty() || others.get(0).equals("--study");
      default -> false;
    };
  }

  /** Returns whether the command loads and then does little in Java. */
  boolean light() {
    return !words.isEmpty() && List.of("run", "doctor").contains(words.get(0));
  }

  /**
   * Returns the command line for the user's shell; empty where a shell would change one of the
   * words (Windows).
   */
  public Optional<String> line() {
    StringBuilder line = new StringBuilder(ProgramInvocation.name());
    for (String word : words) {
      Optional<String> quoted = ProgramInvocation.quoted(word);
      if (quoted.isEmpty()) {
        return Optional.empty();
      }
      line.append(' ').append(quoted.get());
    }
    return Optional.of(line.toString());
  }
}
