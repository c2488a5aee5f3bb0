package org.selectiverenderer.doctor;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Locale;
import java.util.Optional;
import org.selectiverenderer.formats.json.JsonTree;

/**
 * The result of a check of the machine: one line of the report.
 *
 * @param subject what was checked, in a word or two; not empty
 * @param found what was found, or why nothing was; one line, not empty
 * @param todo what to do; empty where nothing is to be done, or {@code found} says it
 * @param needed whether every user needs it: drawing, windows, a folder for files. A headset, which
 *     only some need, is not
 */
public record Diagnosis(Status status, String subject, String found, String todo, boolean needed) {
  /** The status, best first. */
  public enum Status {
    OK,
    /** Present, but slow or limited. */
    WARNING,
    MISSING;

    /** Returns the status as reports spell it. */
    public String word() {
      return name().toLowerCase(Locale.ROOT);
    }
  }

  public Diagnosis {
    found = line(found);
    todo = line(todo);
  }

  public static Diagnosis ok(String subject, String found) {
    return new Diagnosis(Status.OK, subject, found, "", false);
  }

  public static Diagnosis warning(String subject, String found, String todo) {
    return new Diagnosis(Status.WARNING, subject, found, todo, false);
  }

  /** Creates the result that something optional is missing. */
  public static Diagnosis missing(String subject, String found, String todo) {
    return new Diagnosis(Status.MISSING, subject, found, todo, false);
  }

  /** Creates the result that something every user needs is missing. */
  public static Diagnosis lacking(String subject, String found, String todo) {
    return new Diagnosis(Status.MISSING, subject, found, todo, true);
  }

  /** Returns whether the program cannot work without it. */
  public boolean fatal() {
    return status == Status.MISSING && needed;
  }

  /** Returns the result as an object of {@code doctor.schema.json}. */
  public ObjectNode json() {
    ObjectNode node = JsonTree.object();
    node.put("status", status.word());
    node.put("subject", subject);
    node.put("found", found);
    node.put("todo", todo);
    node.put("needed", needed);
    return node;
  }

  /** Parses the text of {@link #json}, sent by another process; empty if it is invalid. */
  public static Optional<Diagnosis> read(String text) {
    try {
      JsonNode node = JsonTree.parse(text);
      return Optional.of(
          new Diagnosis(
              Status.valueOf(node.path("status").asText().toUpperCase(Locale.ROOT)),
              node.path("subject").asText(),
              node.path("found").asText(),
              node.path("todo").asText(),
              node.path("needed").asBoolean()));
    } catch (JsonProcessingException | IllegalArgumentException e) {
      return Optional.empty(); // The process crashed while it wrote the line.
    }
  }

  /** Replaces the user's home folder by {@code ~}, because reports are published. */
  public Diagnosis without(String home) {
    return home.length() < 2
        ? this
        : new Diagnosis(status, subject, found.replace(home, "~"), todo.replace(home, "~"), needed);
  }

  private static String line(String text) {
    return text.replaceAll("\\s+", " ").strip();
  }
}
