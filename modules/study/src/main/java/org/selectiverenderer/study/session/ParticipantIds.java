package org.selectiverenderer.study.session;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.selectiverenderer.study.definition.Study;

/**
 * The ids of a study's participants, with a search for ids that are easily confused: {@code 1},
 * {@code 001}, {@code P01} and {@code p01} are easily typed for each other, and a participant under
 * two ids gets two conditions.
 */
public final class ParticipantIds {
  private static final Pattern PARTS = Pattern.compile("([a-z]*)(\\d+)(.*)");

  private final Set<String> known;

  private ParticipantIds(Set<String> known) {
    this.known = known;
  }

  /** Returns the ids of all participants of a study who have a folder or a condition. */
  public static ParticipantIds of(Study study) throws IOException {
    Set<String> known = new LinkedHashSet<>(SessionFolder.participants(study));
    new ParticipantsFile(study).all().forEach(assigned -> known.add(assigned.participant()));
    return new ParticipantIds(known);
  }

  /** Returns whether an id exists with exactly this spelling. */
  public boolean has(String id) {
    return known.contains(id);
  }

  /** Returns the first of 001, 002 and so on that neither exists nor resembles an existing id. */
  public String next() {
    int number = 1;
    while (alike(named(number)).isPresent() || has(named(number))) {
      number++;
    }
    return named(number);
  }

  private static String named(int number) {
    return String.format(Locale.ROOT, "%03d", number);
  }

  /**
   * Returns an existing id that differs in letter case only: on Windows and macOS both would have
   * the same folder.
   */
  public Optional<String> sameFolder(String id) {
    return known.stream()
        .filter(other -> !other.equals(id) && other.equalsIgnoreCase(id))
        .findFirst();
  }

  /** Returns an existing id that resembles a new one; empty if the id exists. */
  public Optional<String> alike(String id) {
    return has(id)
        ? Optional.empty()
        : known.stream().filter(other -> alike(id, other)).findFirst();
  }

  /**
   * Returns whether two ids differ only in letter case, leading zeros, or a prefix of letters that
   * one of them lacks.
   */
  static boolean alike(String one, String other) {
    Matcher first = PARTS.matcher(one.toLowerCase(Locale.ROOT));
    Matcher second = PARTS.matcher(other.toLowerCase(Locale.ROOT));
    if (!first.matches() || !second.matches()) {
      return one.equalsIgnoreCase(other);
    }
    String prefix = first.group(1);
    return (prefix.isEmpty() || second.group(1).isEmpty() || prefix.equals(second.group(1)))
        && numbers(first).equals(numbers(second));
  }

  /** Returns the parts of an id after its prefix of letters, numbers without leading zeros. */
  private static List<String> numbers(Matcher id) {
    List<String> parts = new ArrayList<>();
    for (String part : (id.group(2) + id.group(3)).split("(?<=\\d)(?=\\D)|(?<=\\D)(?=\\d)")) {
      parts.add(part.replaceFirst("^0+(?=\\d)", ""));
    }
    return parts;
  }
}
