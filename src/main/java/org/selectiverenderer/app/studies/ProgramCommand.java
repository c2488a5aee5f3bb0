package org.selectiverenderer.app.studies;

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
