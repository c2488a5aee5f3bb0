package org.selectiverenderer.experiment.study;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.selectiverenderer.experiment.study.JsonPart.Member;
import org.selectiverenderer.x3d.Location;
import org.selectiverenderer.x3d.Problems;

/**
 * The members of a JSON object, asked for one by one. What is wrong is an error at its place; a
 * value that stands in for it is returned, so that all faults of a file are found at once.
 */
final class JsonKeys {
  private static final String UNUSED = "; the study is not used";

  private final Map<String, Member> members;
  private final Location at;
  private final String subject;
  private final Problems problems;
  private final Set<String> asked = new HashSet<>();

  private JsonKeys(Map<String, Member> members, Location at, String subject, Problems problems) {
    this.members = members;
    this.at = at;
    this.subject = subject;
    this.problems = problems;
  }

  /**
   * The members of a part that is to be an object; none of another.
   *
   * @param subject what it is, for messages, such as {@code an area}
   */
  static JsonKeys of(JsonPart part, String subject, Problems problems) {
    Map<String, Member> members = Map.of();
    if (part.value() instanceof Map<?, ?> map) {
      members =
          map.entrySet().stream()
              .collect(
                  Collectors.toMap(
                      entry -> (String) entry.getKey(),
                      entry -> (Member) entry.getValue(),
                      (a, b) -> a,
                      LinkedHashMap::new));
    } else {
      problems.error(part.at(), subject + " is to be an object in braces" + UNUSED);
    }
    return new JsonKeys(members, part.at(), subject, problems);
  }

  /** Where the object begins. */
  Location at() {
    return at;
  }

  /** Where a member's value stands; the object where there is none. */
  Location at(String key) {
    Member member = members.get(key);
    return member == null ? at : member.part().at();
  }

  boolean has(String key) {
    asked.add(key);
    return members.containsKey(key);
  }

  /** A fault at a member. */
  void fault(String key, String message) {
    problems.error(at(key), message + UNUSED);
  }

  private Optional<JsonPart> part(String key, boolean needed) {
    asked.add(key);
    Member member = members.get(key);
    if (member == null && needed) {
      problems.error(at, subject + " needs \"" + key + "\"" + UNUSED);
    }
    return Optional.ofNullable(member).map(Member::part);
  }

  /** A text that must be there. */
  String text(String key) {
    return text(key, true).orElse("");
  }

  /** A text that may be missing. */
  Optional<String> text(String key, boolean needed) {
    Optional<JsonPart> part = part(key, needed);
    if (part.isPresent() && !(part.get().value() instanceof String found && !found.isBlank())) {
      fault(key, "\"" + key + "\" is to be a text in quotes");
      return Optional.empty();
    }
    return part.map(found -> (String) found.value());
  }

  /** A number in a range; the default where it is missing, needed where that is NaN. */
  double number(String key, double least, double most, double otherwise) {
    Optional<JsonPart> part = part(key, Double.isNaN(otherwise));
    if (part.isEmpty()) {
      return Double.isNaN(otherwise) ? least : otherwise;
    }
    if (part.get().value() instanceof Double number && number >= least && number <= most) {
      return number;
    }
    fault(key, "\"%s\" is to be a number from %s to %s".formatted(key, tidy(least), tidy(most)));
    return least;
  }

  /** A whole number in a range. */
  long whole(String key, double least, double most, double otherwise) {
    double number = number(key, least, most, otherwise);
    if (number != Math.rint(number)) {
      fault(key, "\"" + key + "\" is to be a whole number");
    }
    return (long) number;
  }

  private static String tidy(double number) {
    return number == Math.rint(number) ? Long.toString((long) number) : Double.toString(number);
  }

  /** One of some spellings. */
  <T> T choice(String key, List<T> known, Function<T, String> spelling, T otherwise) {
    Optional<String> text = text(key, false);
    if (text.isEmpty()) {
      return otherwise;
    }
    for (T value : known) {
      if (spelling.apply(value).equals(text.get())) {
        return value;
      }
    }
    fault(
        key,
        "'%s' is none of %s"
            .formatted(text.get(), known.stream().map(spelling).collect(Collectors.joining(", "))));
    return otherwise;
  }

  /** An object; empty where it is missing. */
  Optional<JsonKeys> object(String key, String what) {
    return part(key, false).map(part -> of(part, what, problems));
  }

  /** The parts of a list; none where it is missing. */
  List<JsonPart> list(String key, boolean needed) {
    Optional<JsonPart> part = part(key, needed);
    if (part.isPresent() && !(part.get().value() instanceof List<?>)) {
      fault(key, "\"" + key + "\" is to be a list in brackets");
      return List.of();
    }
    return part.map(found -> ((List<?>) found.value()).stream().map(JsonPart.class::cast).toList())
        .orElse(List.of());
  }

  /** The objects of a list. */
  Stream<JsonKeys> objects(String key, String what) {
    return list(key, false).stream().map(part -> of(part, what, problems));
  }

  /** Finds fault with every member that nobody asked for. */
  void nothingElse() {
    members.forEach(
        (name, member) -> {
          if (!asked.contains(name)) {
            problems.error(
                member.name(),
                "%s has no \"%s\" (it has %s)%s"
                    .formatted(
                        subject,
                        name,
                        asked.stream().sorted().collect(Collectors.joining(", ")),
                        UNUSED));
          }
        });
  }
}
