package org.selectiverenderer.doctor;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Locale;
import java.util.Optional;
import org.selectiverenderer.base.json.JsonTree;

/**
 * One line about a machine.
 *
 * @param subject what the line is about, in a word or two; not empty
 * @param found what is there, or why nothing is; one line, not empty
 * @param todo what to do about it; empty where nothing is to be done, or {@code found} says it
 * @param needed whether nobody can do without it: drawing, windows, a place to save. What only some
 *     need, a headset say, is not
 */
public record Diagnosis(Status status, String subject, String found, String todo, boolean needed) {
  /** How it stands, best first. */
  public enum Status {
    OK,
    /** There, but it will be felt. */
    WARNING,
    MISSING;

    /** As reports have it. */
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

  /** Something that only some need is not there. */
  public static Diagnosis missing(String subject, String found, String todo) {
    return new Diagnosis(Status.MISSING, subject, found, todo, false);
  }

  /** Something that everybody needs is not there. */
  public static Diagnosis lacking(String subject, String found, String todo) {
    return new Diagnosis(Status.MISSING, subject, found, todo, true);
  }

  /** Whether the program cannot do its work for want of it. */
  public boolean fatal() {
    return status == Status.MISSING && needed;
  }

  /** As an object of {@code doctor.schema.json}. */
  public ObjectNode json() {
    ObjectNode node = JsonTree.object();
    node.put("status", status.word());
    node.put("subject", subject);
    node.put("found", found);
    node.put("todo", todo);
    node.put("needed", needed);
    return node;
  }

  /** What {@link #json} made and a process sent as a text; empty if it is none. */
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
      return Optional.empty(); // A process that crashed within its line.
    }
  }

  /** The user's folder is nobody's business in a report that is published. */
  public Diagnosis without(String home) {
    return home.length() < 2
        ? this
        : new Diagnosis(status, subject, found.replace(home, "~"), todo.replace(home, "~"), needed);
  }

  private static String line(String text) {
    return text.replaceAll("\\s+", " ").strip();
  }
}
