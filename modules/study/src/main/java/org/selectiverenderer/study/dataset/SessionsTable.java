package org.selectiverenderer.study.dataset;

import java.io.IOException;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.decimal.DecimalRounding;

/** The {@code sessions} table, with a row for each session. */
public final class SessionsTable {
  private SessionsTable() {}

  /** Returns the columns of {@link #row}; the first are participant, session and began. */
  public static List<TableColumn> columns() {
    Map<String, String> outcomes = new LinkedHashMap<>();
    outcomes.put("finished", "all steps are done");
    outcomes.put("aborted", "the experimenter ended it before its end");
    outcomes.put("unfinished", "it was cut off, or is under way");
    outcomes.put("refused", "the participant does not take part");
    return List.of(
        TableColumn.text("participant", "the participant's id"),
        TableColumn.whole("session", "number of the participant's session, from 1"),
        TableColumn.time("began", "when it began"),
        TableColumn.number(
            "duration",
            "s",
            "from the first event to the last, breaks included, by the monotonic clock; a break"
                + " between two runs of the program by the clock on the wall"),
        TableColumn.number(
            "in_view",
            "s",
            "time in view of all exposures, the practice left out: see in_view of exposures"),
        ConditionColumnFactory.column("how objects were rendered"),
        TableColumn.text("language", "language of the participant's texts, a code such as en"),
        TableColumn.category("outcome", outcomes, "how it ended"),
        TableColumn.yesNo(
            "simulated", "the program took part, for tests", "a person", "who took part"),
        TableColumn.text("flags", "what is to be known of its quality, joined by |"),
        TableColumn.text("software", "the program that ran it"));
  }

  /**
   * Returns the cells of one session.
   *
   * @param fade seconds in which pictures fade out
   * @throws IOException if a head log cannot be read
   */
  public static List<@Nullable Object> row(RecordedSession session, double fade)
      throws IOException {
    OptionalDouble seen = session.inView(fade);
    return Arrays.asList(
        session.folder().participant(),
        session.folder().number(),
        session.began().toString(),
        DecimalRounding.to(3, session.duration()),
        seen.isPresent() ? DecimalRounding.to(3, seen.getAsDouble()) : null,
        session.condition(),
        session.language(),
        session.outcome(),
        session.simulated() ? "yes" : "no",
        String.join("|", session.flags()),
        session.software());
  }
}
