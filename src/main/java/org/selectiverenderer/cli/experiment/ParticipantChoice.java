package org.selectiverenderer.cli.experiment;

import java.io.IOException;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.cli.output.CommandFailure;
import org.selectiverenderer.experiment.session.ParticipantIds;
import org.selectiverenderer.experiment.session.SessionFolder;
import org.selectiverenderer.experiment.study.Study;
import picocli.CommandLine.Option;

/** Whose session it is. */
final class ParticipantChoice {
  @Option(
      names = "--participant",
      paramLabel = "ID",
      description = "id of the participant, letters and digits (default: the next free number)")
  private @Nullable String participant;

  @Option(
      names = "--new-participant",
      description = "says that --participant is somebody new, though the ID looks like another")
  private boolean somebodyNew;

  /** The id as typed. */
  Optional<String> typed() {
    return Optional.ofNullable(participant);
  }

  /** Refuses what is no id. */
  void check() {
    if (participant != null && !participant.matches(SessionFolder.LABEL)) {
      throw CommandFailure.usage("--participant must consist of letters and digits");
    }
    if (somebodyNew && participant == null) {
      throw CommandFailure.usage("--new-participant needs --participant");
    }
  }

  /**
   * The id, once it is sure who is meant.
   *
   * @param ask puts a question to whoever sits there and returns the answer; empty where nobody
   *     does
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
      throw CommandFailure.usage(
          "there is no participant %s to continue with%s"
              .formatted(
                  id,
                  alike.map(other -> "; did you mean --participant " + other + "?").orElse("")));
    }
    Optional<String> folder = ids.sameFolder(id);
    if (folder.isPresent()) {
      throw CommandFailure.usage(
          "the participant %s differs from %s in capitals only, and on Windows and macOS both would be"
                  .formatted(id, folder.get())
              + " one folder; type %s, or another id".formatted(folder.get()));
    }
    if (alike.isPresent() && !somebodyNew) {
      confirm(id, alike.get(), ask);
    }
    return id;
  }

  private static void confirm(String id, String other, Function<String, Optional<String>> ask) {
    Optional<String> answer =
        ask.apply(
            "The participant %s is new, but looks like %s, who is there already. Is %s somebody else? [y/n] "
                .formatted(id, other, id));
    if (answer.isEmpty()) {
      throw CommandFailure.usage(
          "the participant %s looks like %s, who is there already; type %s for the same person,"
                  .formatted(id, other, other)
              + " or add --new-participant for somebody else");
    }
    if (!answer.get().strip().toLowerCase(Locale.ROOT).startsWith("y")) {
      throw CommandFailure.environment(
          "no session was begun; --participant %s is the one who is there already"
              .formatted(other));
    }
  }
}
