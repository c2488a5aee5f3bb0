package org.selectiverenderer.statistics.data;

import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.selectiverenderer.base.problem.ProblemCollector;

/** Answers of participants and tables in long form. */
public final class AnswersFuzzTarget {
  private static final ObservationsReader.Columns COLUMNS =
      new ObservationsReader.Columns(
          "score", "participant", Optional.of("room"), Optional.of("condition"));

  private AnswersFuzzTarget() {}

  /** Reads one input. */
  public static void fuzzerTestOneInput(byte[] input) {
    String text = new String(input, StandardCharsets.UTF_8);
    ResponsesReader.parse("fuzz.csv", text, Optional.empty(), new ProblemCollector());
    ObservationsReader.parse("fuzz.csv", text, COLUMNS, new ProblemCollector());
  }
}
