package org.selectiverenderer.statistics.data;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.selectiverenderer.formats.csv.CsvNumberParser;
import org.selectiverenderer.formats.csv.CsvRow;
import org.selectiverenderer.statistics.detection.Response;

/** Parses one row of a file of answers, or reports why it cannot be used. */
final class ResponseRowParser {
  static final List<String> COLUMNS =
      List.of(
          "participant",
          "condition",
          "area",
          "object",
          "consistency",
          "present",
          "response",
          "confidence");

  private static final String LEFT_OUT = "; the answer is left out";

  private final CsvRow row;
  private final ExclusionLog exclusions;
  private final String participant;

  ResponseRowParser(CsvRow row, ExclusionLog exclusions) {
    this.row = row;
    this.exclusions = exclusions;
    participant = row.cell("participant");
  }

  /** Returns the answer of the row; empty after an exclusion. */
  Optional<Response> read() {
    for (String column : List.of("participant", "condition", "area", "object")) {
      if (row.cell(column).isEmpty()) {
        return error(column, "the " + column + " is missing" + LEFT_OUT);
      }
    }
    String type = row.cell("consistency").toLowerCase(Locale.ROOT);
    if (!Response.TYPES.contains(type)) {
      return error(
          "consistency",
          (type.isEmpty()
                  ? "the consistency is missing"
                  : CsvNumberParser.quoted(row.cell("consistency")) + " is not a consistency")
              + " (it is consistent, inconsistent or neutral)"
              + LEFT_OUT);
    }
    Optional<Boolean> present = yesOrNo("present");
    if (present.isEmpty()) {
      return Optional.empty();
    }
    if (row.cell("response").isEmpty()) {
      exclusions.warning(
          row.location("response"), participant, "no answer to " + row.cell("object") + LEFT_OUT);
      return Optional.empty();
    }
    Optional<Boolean> yes = yesOrNo("response");
    Optional<Integer> confidence = yes.isEmpty() ? Optional.empty() : confidence();
    if (confidence.isEmpty()) {
      return Optional.empty();
    }
    return Optional.of(
        new Response(
            participant,
            row.cell("condition"),
            row.cell("area"),
            row.cell("object"),
            type,
            present.get(),
            yes.orElseThrow(),
            confidence.get(),
            row.location()));
  }

  private Optional<Boolean> yesOrNo(String column) {
    String text = row.cell(column).toLowerCase(Locale.ROOT);
    if (text.equals("yes") || text.equals("no")) {
      return Optional.of(text.equals("yes"));
    }
    error(
        column,
        (text.isEmpty()
                ? "the answer (yes or no) is missing"
                : CsvNumberParser.quoted(text) + " is not yes or no")
            + LEFT_OUT);
    return Optional.empty();
  }

  /** Returns the confidence, 0 when it was not given; empty after an exclusion. */
  private Optional<Integer> confidence() {
    String text = row.cell("confidence");
    if (text.isEmpty()) {
      exclusions.warning(
          row.location("confidence"),
          participant,
          "the confidence about "
              + row.cell("object")
              + " is missing; the answer counts among all answers, but not at the "
              + "levels 3-5 and 5");
      return Optional.of(0);
    }
    if (row.decimal("confidence").matches("[1-5]([.]0*)?")) {
      return Optional.of(text.charAt(0) - '0');
    }
    error(
        "confidence",
        CsvNumberParser.quoted(text)
            + " is not a confidence from 1 to 5"
            + CsvNumberParser.commaHint(row, "confidence")
            + LEFT_OUT);
    return Optional.empty();
  }

  private <T> Optional<T> error(String column, String reason) {
    exclusions.error(row.location(column), participant, reason);
    return Optional.empty();
  }
}
