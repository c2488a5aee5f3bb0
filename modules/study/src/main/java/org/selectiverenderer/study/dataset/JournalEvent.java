package org.selectiverenderer.study.dataset;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.DateTimeException;
import java.time.Duration;
import java.time.OffsetDateTime;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.base.files.InputFileReader;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.study.session.JournalContent;

/**
 * An event of a session: one line of its journal.
 *
 * @param time when the event was logged, by the wall clock
 * @param seconds from the session's first event to this one, by the monotonic clock; from one run
 *     of the program to the next, and where an older program left it out, by the wall clock, of
 *     which a step backwards counts as none
 * @param event the event's name
 * @param step id of the step in which it happened; empty outside of steps
 * @param members all members of the line's JSON object
 */
public record JournalEvent(
    OffsetDateTime time, double seconds, String event, String step, JsonNode members) {
  /**
   * Reads a journal.
   *
   * @param problems receives each damaged line; the others are used
   * @throws IOException if the file cannot be read
   */
  static List<JournalEvent> read(Path journal, ProblemCollector problems) throws IOException {
    String text = new String(InputFileReader.bytes(journal), StandardCharsets.UTF_8);
    String[] lines = text.split("\n", -1);
    List<JournalEvent> events = new ArrayList<>();
    for (int i = 0; i < lines.length; i++) {
      if (lines[i].isBlank()) {
        continue;
      }
      Optional<JournalEvent> event =
          parse(lines[i], events.isEmpty() ? Optional.empty() : Optional.of(last(events)));
      if (event.isPresent()) {
        events.add(event.get());
      } else if (i == lines.length - 1) {
        problems.info(
            new SourceLocation(journal.toString(), i + 1, 1),
            "the last line is cut off, perhaps by a crash; it is left out");
      } else {
        problems.warning(
            new SourceLocation(journal.toString(), i + 1, 1),
            "this line is damaged, perhaps by a crash; it is left out");
      }
    }
    return events;
  }

  private static JournalEvent last(List<JournalEvent> events) {
    return events.get(events.size() - 1);
  }

  private static Optional<JournalEvent> parse(String line, Optional<JournalEvent> before) {
    try {
      JsonNode node = JsonTree.parse(line);
      if (!JournalContent.isEvent(node)) {
        return Optional.empty();
      }
      OffsetDateTime time = OffsetDateTime.parse(node.path("time").asText());
      return Optional.of(
          new JournalEvent(
              time,
              before.map(last -> last.seconds() + last.until(time, node)).orElse(0.0),
              node.path("event").asText(),
              node.path("step").asText(),
              node));
    } catch (JsonProcessingException | DateTimeException e) {
      return Optional.empty(); // The caller reports the line.
    }
  }

  /** Returns the seconds from this event to the next one of the journal. */
  private double until(OffsetDateTime next, JsonNode node) {
    if (node.path("mono").isNumber() && members.path("mono").isNumber() && !restarts(node)) {
      double elapsed = node.path("mono").asDouble() - members.path("mono").asDouble();
      if (elapsed >= 0) {
        return elapsed;
      }
    }
    return Math.max(0, Duration.between(time, next).toNanos() * 1e-9);
  }

  /** Returns whether another process wrote the next event, with another origin of its clock. */
  private boolean restarts(JsonNode next) {
    return switch (next.path("event").asText()) {
      case "journal-mended" -> true;
      case "resumed" -> !event.equals("journal-mended");
      default -> false;
    };
  }

  /** Returns a member as text; empty if the event has no such member. */
  public String text(String member) {
    return members.path(member).asText("");
  }
}
