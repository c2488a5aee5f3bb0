package org.selectiverenderer.study.questionnaire.read;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.study.questionnaire.ItemQuestionnaireKind;
import org.selectiverenderer.study.questionnaire.ParticipantMessages;
import org.selectiverenderer.testing.FuzzFile;

/** Questionnaires, as JSON and as lists of items. */
public final class QuestionnaireFuzzTarget {
  private static final ParticipantMessages MESSAGES = messages();

  private QuestionnaireFuzzTarget() {}

  private static ParticipantMessages messages() {
    try {
      return ParticipantMessages.of("en", Path.of(""), new ProblemCollector()).orElseThrow();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Reads one input. */
  public static void fuzzerTestOneInput(byte[] input) {
    FuzzFile.with(
        "questionnaire.json",
        input,
        file -> {
          QuestionnaireReader.read(file, "en", new ProblemCollector());
          for (ItemQuestionnaireKind kind : ItemQuestionnaireKind.values()) {
            ItemListReader.read(kind, file, "fuzz", MESSAGES, new ProblemCollector());
          }
        });
  }
}
