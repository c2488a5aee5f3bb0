package org.selectiverenderer.formats.json;

import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.base.problem.SourceLocation;

/** A value of a JSON text with its location in the file. */
public final class LocatedJsonValue {
  /** Represents null. */
  private static final Object NOTHING = new Object();

  /** A value and the location of its key. */
  record Member(SourceLocation name, LocatedJsonValue value) {}

  private final Object value;
  private final SourceLocation at;

  /**
   * Creates a value.
   *
   * @param value a {@code String}, {@code Double} or {@code Boolean}, a list of values, a map from
   *     keys to members, or {@link #NOTHING}
   */
  private LocatedJsonValue(Object value, SourceLocation at) {
    this.value = value;
    this.at = at;
  }

  /** Reads the value that begins at the current token of a parser. */
  static LocatedJsonValue read(JsonParser parser, JsonErrorReporter faults) throws IOException {
    SourceLocation at = faults.place(parser.currentTokenLocation());
    return switch (parser.currentToken()) {
      case START_OBJECT -> {
        Map<String, Member> members = new LinkedHashMap<>();
        while (parser.nextToken() != JsonToken.END_OBJECT) {
          SourceLocation name = faults.place(parser.currentTokenLocation());
          String key = parser.currentName();
          parser.nextToken();
          members.put(key, new Member(name, read(parser, faults)));
        }
        yield new LocatedJsonValue(members, at);
      }
      case START_ARRAY -> {
        List<LocatedJsonValue> values = new ArrayList<>();
        while (parser.nextToken() != JsonToken.END_ARRAY) {
          values.add(read(parser, faults));
        }
        yield new LocatedJsonValue(values, at);
      }
      case VALUE_NUMBER_INT, VALUE_NUMBER_FLOAT ->
          new LocatedJsonValue(parser.getDoubleValue(), at);
      case VALUE_TRUE, VALUE_FALSE -> new LocatedJsonValue(parser.getBooleanValue(), at);
      case VALUE_NULL -> new LocatedJsonValue(NOTHING, at);
      default -> new LocatedJsonValue(parser.getText(), at);
    };
  }

  /** Returns where the value begins. */
  public SourceLocation at() {
    return at;
  }

  boolean isNull() {
    return value == NOTHING;
  }

  /** Returns the string; empty if the value is of another type. */
  public Optional<String> text() {
    return value instanceof String text ? Optional.of(text) : Optional.empty();
  }

  /** Returns the number; NaN if the value is of another type. */
  public double number() {
    return value instanceof Double number ? number : Double.NaN;
  }

  /** Returns the boolean; empty if the value is of another type. */
  Optional<Boolean> truth() {
    return value instanceof Boolean truth ? Optional.of(truth) : Optional.empty();
  }

  /** Returns the elements; empty if the value is not an array. */
  Optional<List<LocatedJsonValue>> list() {
    return value instanceof List<?> list
        ? Optional.of(list.stream().map(LocatedJsonValue.class::cast).toList())
        : Optional.empty();
  }

  /** Returns the members in file order; empty if the value is not an object. */
  Optional<Map<String, Member>> members() {
    if (!(value instanceof Map<?, ?> map)) {
      return Optional.empty();
    }
    Map<String, Member> members = new LinkedHashMap<>();
    map.forEach((name, member) -> members.put((String) name, (Member) member));
    return Optional.of(members);
  }

  /** Returns a short form for messages. */
  @Override
  public String toString() {
    return value == NOTHING
        ? "null"
        : value instanceof Map ? "{...}" : value instanceof List ? "[...]" : value.toString();
  }
}
