package org.selectiverenderer.command.trust;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.files.SettingsFolder;
import org.selectiverenderer.base.trust.PermissionRequests;
import org.selectiverenderer.base.trust.TrustStore;
import org.selectiverenderer.command.ProgramInvocation;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.Console;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** The option {@code --trust}, and the question that it answers. */
public final class TrustOption {
  @Option(
      names = "--trust",
      description =
          "agrees, this time, to what the study or settings file asks for beyond its own folder,"
              + " without a question")
  private boolean trusted;

  @Spec(Spec.Target.MIXEE)
  private @Nullable CommandSpec command;

  /** Requires the agreement of the user, who is asked at most once for each request. */
  public void require(Path file, PermissionRequests needed, TrustPrompt prompt, Console console) {
    require(file, needed, prompt, console, new TrustStore(SettingsFolder.ofUser()));
  }

  void require(
      Path file, PermissionRequests needed, TrustPrompt prompt, Console console, TrustStore store) {
    if (trusted || needed.isEmpty() || store.remembers(needed)) {
      return;
    }
    Optional<Boolean> answer =
        prompt.ask(name(file) + " asks for more than its own folder", needed.lines());
    if (answer.isEmpty()) {
      throw CommandException.environment(unasked(file, needed));
    }
    if (!answer.get()) {
      throw CommandException.environment(name(file) + ": not agreed to, so nothing was done");
    }
    try {
      store.remember(needed);
    } catch (IOException e) {
      console.message("the answer is not remembered: " + e.getMessage());
    }
  }

  private String unasked(Path file, PermissionRequests needed) {
    return "%s asks for more than its own folder: %s; nobody can be asked here, so look at it and type%s"
        .formatted(
            name(file),
            String.join("; ", needed.lines()),
            again().map(line -> ": " + line).orElse(" the same command again with --trust"));
  }

  /**
   * Returns the command line that the user has typed, with {@code --trust}; empty where a shell
   * could take a word of it for something else.
   */
  private Optional<String> again() {
    CommandLine root = command == null ? null : command.root().commandLine();
    List<String> typed =
        root == null || root.getParseResult() == null
            ? List.of()
            : root.getParseResult().originalArgs();
    StringBuilder line = new StringBuilder(ProgramInvocation.name());
    boolean added = false;
    for (String word : typed) {
      if (word.equals("--") && !added) {
        line.append(" --trust");
        added = true;
      }
      Optional<String> quoted = ProgramInvocation.quoted(word);
      if (quoted.isEmpty()) {
        return Optional.empty();
      }
      line.append(' ').append(quoted.get());
    }
    return Optional.of(added ? line.toString() : line + " --trust");
  }

  private static String name(Path file) {
    return file.toString().replaceAll("[\\p{Cntrl}\\p{Cf}]", "?");
  }
}
