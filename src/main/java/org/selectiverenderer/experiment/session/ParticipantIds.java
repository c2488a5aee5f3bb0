package org.selectiverenderer.experiment.session;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.selectiverenderer.experiment.study.Study;

/**
 * The ids of a study's participants, and which of them look like another: {@code 1}, {@code 001},
 * {@code P01} and {@code p01} are easily typed for each other, and a participant who comes under
 * two of them gets two conditions.
 */
public final class ParticipantIds {
  private static final Pattern PARTS = Pattern.compile("([a-z]*)(\\d+)(.*)");

  private final Set<String> known;

  private ParticipantIds(Set<String> known) {
    this.known = known;
  }

  /** Of a study: of all who have a folder or a condition. */
  public static ParticipantIds of(Study study) throws IOException {
    Set<String> known = new LinkedHashSet<>(SessionFolder.participants(study));
    new Participants(study).all().forEach(assigned -> known.add(assigned.participant()));
    return new ParticipantIds(known);
  }

  /** Whether an id is there, letter for letter. */
  public boolean has(String id) {
    return known.contains(id);
  }

  /** An id that nobody has yet, nor one that looks like it: 001 and so on. */
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

  /** One that differs in capitals only: on Windows and macOS both would have the same folder. */
  public Optional<String> sameFolder(String id) {
    return known.stream()
        .filter(other -> !other.equals(id) && other.equalsIgnoreCase(id))
        .findFirst();
  }

  /** One that is there and looks like an id that is not. */
  public Optional<String> alike(String id) {
    return has(id)
        ? Optional.empty()
        : known.stream().filter(other -> alike(id, other)).findFirst();
  }

  /** Whether two ids differ in capitals, leading zeros, or letters that only one begins with. */
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

  /** What follows the letters that it begins with, numbers without leading zeros. */
  private static List<String> numbers(Matcher id) {
    List<String> parts = new ArrayList<>();
    for (String part : (id.group(2) + id.group(3)).split("(?<=\\d)(?=\\D)|(?<=\\D)(?=\\d)")) {
      parts.add(part.replaceFirst("^0+(?=\\d)", ""));
    }
    return parts;
  }
}
