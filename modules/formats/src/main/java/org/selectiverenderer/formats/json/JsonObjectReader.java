package org.selectiverenderer.formats.json;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.base.problem.SpellingSuggester;
import org.selectiverenderer.formats.json.LocatedJsonValue.Member;

/**
 * Reads the members of a JSON object by key. An error is reported at its location and a default
 * value returned, so that all errors of a file are found in one pass. Keys that the caller never
 * reads are errors, too.
 */
public final class JsonObjectReader {
  private final Map<String, Member> members;
  private final SourceLocation at;
  private final String subject;
  private final JsonErrorReporter faults;
  private final Set<String> asked = new TreeSet<>();

  private JsonObjectReader(
      Map<String, Member> members, SourceLocation at, String subject, JsonErrorReporter faults) {
    this.members = members;
    this.at = at;
    this.subject = subject;
    this.faults = faults;
  }

  /**
   * Returns a reader of a value that should be an object; without members if it is not.
   *
   * @param subject the noun for the object in messages, such as {@code an area}
   */
  static JsonObjectReader of(LocatedJsonValue value, String subject, JsonErrorReporter faults) {
    Optional<Map<String, Member>> members = value.members();
    if (members.isEmpty()) {
      faults.at(value.at(), subject + " must be an object in braces");
    }
    return new JsonObjectReader(members.orElse(Map.of()), value.at(), subject, faults);
  }

  /** Reads the content, then reports every key that was not read as unknown. */
  <T> T all(Function<JsonObjectReader, T> content) {
    T read = content.apply(this);
    members.forEach(
        (name, member) -> {
          if (!asked.contains(name)) {
            faults.at(member.name(), unknown(name));
          }
        });
    return read;
  }

  private String unknown(String name) {
    return "%s has no \"%s\"%s"
        .formatted(
            subject,
            name,
            SpellingSuggester.nearest(name, asked)
                .map(near -> "; did you mean \"%s\"?".formatted(near))
                .orElse(" (known keys: %s)".formatted(String.join(", ", asked))));
  }

  /** Returns all keys, for an object that may have any. */
  public List<String> names() {
    asked.addAll(members.keySet());
    return List.copyOf(members.keySet());
  }

  /** Returns whether the object has a member with this key that is not null. */
  public boolean has(String key) {
    return find(key).isPresent();
  }

  private Optional<LocatedJsonValue> find(String key) {
    asked.add(key);
    return Optional.ofNullable(members.get(key))
        .map(Member::value)
        .filter(value -> !value.isNull());
  }

  private Optional<LocatedJsonValue> find(String key, boolean needed) {
    Optional<LocatedJsonValue> found = find(key);
    if (found.isEmpty() && needed) {
      faults.at(at, subject + " needs \"" + key + "\"");
    }
    return found;
  }

  /** Returns a value of any type; empty if it is missing. */
  public Optional<LocatedJsonValue> value(String key) {
    return find(key);
  }

  /** Reports an error of the object as a whole. */
  public void fault(String message) {
    faults.at(at, message);
  }

  /** Reports an error at a member's value, or at the object if there is no such member. */
  public void fault(String key, String message) {
    Member member = members.get(key);
    faults.at(member == null ? at : member.value().at(), message);
  }

  /** Reports an error at an array element. */
  public void fault(LocatedJsonValue value, String message) {
    faults.at(value.at(), message);
  }

  /** Returns a string that must be present and not blank; "" after an error. */
  public String text(String key) {
    return text(key, true).orElse("");
  }

  /** Returns a string that is not blank; a missing or blank one is an error if it is needed. */
  public Optional<String> text(String key, boolean needed) {
    Optional<String> text = find(key, needed).flatMap(value -> textOf(key, value));
    if (text.isPresent() && text.get().isBlank()) {
      if (needed) {
        fault(key, subject + " needs \"" + key + "\"");
      }
      return Optional.empty();
    }
    return text;
  }

  private Optional<String> textOf(String key, LocatedJsonValue value) {
    if (value.text().isEmpty()) {
      fault(key, "\"" + key + "\" must be a text in quotes");
    }
    return value.text();
  }

  /**
   * Returns a number in a closed range.
   *
   * @param otherwise the default if it is missing; NaN if it is required
   * @return {@code least} after an error
   */
  public double number(String key, double least, double most, double otherwise) {
    Optional<LocatedJsonValue> found = find(key, Double.isNaN(otherwise));
    if (found.isEmpty()) {
      return Double.isNaN(otherwise) ? least : otherwise;
    }
    double number = found.get().number();
    if (number >= least && number <= most && Double.isFinite(number)) {
      return number;
    }
    String range = tidy(least) + (most == Double.POSITIVE_INFINITY ? "" : " to " + tidy(most));
    fault(key, "\"%s\" must be a number from %s".formatted(key, range));
    return least;
  }

  /** Returns an integer in a closed range, with a default as in {@link #number}. */
  public long whole(String key, double least, double most, double otherwise) {
    double number = number(key, least, most, otherwise);
    if (number != Math.rint(number)) {
      fault(key, "\"%s\" must be a whole number, not %s".formatted(key, number));
    }
    return (long) number;
  }

  private static String tidy(double number) {
    return number == Math.rint(number) ? Long.toString((long) number) : Double.toString(number);
  }

  /** Returns a boolean; {@code otherwise} if it is missing or after an error. */
  public boolean truth(String key, boolean otherwise) {
    Optional<LocatedJsonValue> found = find(key);
    if (found.isPresent() && found.get().truth().isEmpty()) {
      fault(key, "\"" + key + "\" must be true or false");
    }
    return found.flatMap(LocatedJsonValue::truth).orElse(otherwise);
  }

  /** Returns whether a member is present and is an object. */
  public boolean hasObject(String key) {
    return find(key).flatMap(LocatedJsonValue::members).isPresent();
  }

  /** Returns the known value with this spelling; {@code otherwise} if it is missing or unknown. */
  public <T> T choice(String key, List<T> known, Function<T, String> spelling, T otherwise) {
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
        "'%s' is not one of %s"
            .formatted(text.get(), known.stream().map(spelling).collect(Collectors.joining(", "))));
    return otherwise;
  }

  /**
   * Reads an object; empty if it is missing.
   *
   * @param what the noun for the object in messages, such as {@code the display}
   */
  public <T> Optional<T> object(String key, String what, Function<JsonObjectReader, T> content) {
    return find(key).map(value -> of(value, what, faults).all(content));
  }

  /** Returns the elements of an array; none if it is missing. */
  public List<LocatedJsonValue> list(String key, boolean needed) {
    Optional<LocatedJsonValue> found = find(key, needed);
    Optional<List<LocatedJsonValue>> list = found.flatMap(LocatedJsonValue::list);
    if (found.isPresent() && list.isEmpty()) {
      fault(key, "\"" + key + "\" must be a list in brackets");
    }
    return list.orElse(List.of());
  }

  /** Returns the elements of an array of strings; none if it is missing. */
  public List<String> texts(String key) {
    List<String> texts = new ArrayList<>();
    for (LocatedJsonValue value : list(key, false)) {
      value
          .text()
          .ifPresentOrElse(
              texts::add, () -> fault(value, "\"" + key + "\" must be a list of texts in quotes"));
    }
    return texts;
  }

  /** Reads the elements of an array of objects; none if it is missing. */
  public <T> List<T> objects(String key, String what, Function<JsonObjectReader, T> content) {
    return list(key, false).stream().map(value -> of(value, what, faults).all(content)).toList();
  }
}
