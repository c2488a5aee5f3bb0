package org.selectiverenderer.cli.experiment;

import java.io.IOException;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.session.ParticipantIds;
import org.selectiverenderer.study.session.SessionFolder;
import picocli.CommandLine.Option;

/** The options that name the participant of a session. */
final class ParticipantOptions {
  @Option(
      names = "--participant",
      paramLabel = "ID",
      description = "id of the participant, letters and digits (default: the next free number)")
  private @Nullable String participant;

  @Option(
      names = "--new-participant",
      description =
          "confirms that --participant is a new person, although the ID resembles another one")
  private boolean somebodyNew;

  /** Returns the ID as typed. */
  Optional<String> typed() {
    return Optional.ofNullable(participant);
  }

  /** Checks that the options are valid. */
  void check() {
    if (participant != null && !participant.matches(SessionFolder.LABEL)) {
      throw CommandException.usage("--participant must consist of letters and digits");
    }
    if (somebodyNew && participant == null) {
      throw CommandException.usage("--new-participant needs --participant");
    }
  }

  /**
   * Returns the participant's ID, after asking about an ID that resembles another one.
   *
   * @param ask asks the user a question and returns the answer; empty where there is no console
   */
  String of(Study study, boolean resume, Function<String, Optional<String>> ask)
      throws IOException {
    ParticipantIds ids = ParticipantIds.of(study);
    if (participant == null) {
      return ids.next();
    }
    String id = participant;
    if (ids.has(id)) {
      return id;
    }
    Optional<String> alike = ids.alike(id);
    if (resume) {
      throw CommandException.usage(
          "--resume: the study has no participant %s%s"
              .formatted(
                  id,
                  alike.map(other -> "; did you mean --participant " + other + "?").orElse("")));
    }
    Optional<String> folder = ids.sameFolder(id);
    if (folder.isPresent()) {
      throw CommandException.usage(
          "the IDs %s and %s differ only in capitals, and would share one folder on Windows and"
                  .formatted(id, folder.get())
              + " macOS; use %s or another ID".formatted(folder.get()));
    }
    if (alike.isPresent() && !somebodyNew) {
      confirm(id, alike.get(), ask);
    }
    return id;
  }

  private static void confirm(String id, String other, Function<String, Optional<String>> ask) {
    Optional<String> answer =
        ask.apply(
            "The ID %s is new but resembles %s of the same study. Is %s a new person? [y/n] "
                .formatted(id, other, id));
    if (answer.isEmpty()) {
      throw CommandException.usage(
          "the ID %s resembles %s of the same study; use --participant %s for the same"
                  .formatted(id, other, other)
              + " person, or add --new-participant for a new one");
    }
    if (!answer.get().strip().toLowerCase(Locale.ROOT).startsWith("y")) {
      throw CommandException.environment(
          "no session was started; use --participant %s for the participant of that ID"
              .formatted(other));
    }
  }
}
