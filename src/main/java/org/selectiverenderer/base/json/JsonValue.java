package org.selectiverenderer.base.json;

import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.base.problem.Location;

/** A value of a JSON text that knows where it stands. */
public final class JsonValue {
  /** What null reads as. */
  private static final Object NOTHING = new Object();

  /** A value and where its name stands. */
  record Member(Location name, JsonValue value) {}

  private final Object value;
  private final Location at;

  /**
   * @param value a {@code String}, {@code Double} or {@code Boolean}, a list of values, a map from
   *     names to members, or {@link #NOTHING}
   */
  private JsonValue(Object value, Location at) {
    this.value = value;
    this.at = at;
  }

  /** Reads the value that a parser has come to. */
  static JsonValue read(JsonParser parser, JsonFault faults) throws IOException {
    Location at = faults.place(parser.currentTokenLocation());
    return switch (parser.currentToken()) {
      case START_OBJECT -> {
        Map<String, Member> members = new LinkedHashMap<>();
        while (parser.nextToken() != JsonToken.END_OBJECT) {
          Location name = faults.place(parser.currentTokenLocation());
          String key = parser.currentName();
          parser.nextToken();
          members.put(key, new Member(name, read(parser, faults)));
        }
        yield new JsonValue(members, at);
      }
      case START_ARRAY -> {
        List<JsonValue> values = new ArrayList<>();
        while (parser.nextToken() != JsonToken.END_ARRAY) {
          values.add(read(parser, faults));
        }
        yield new JsonValue(values, at);
      }
      case VALUE_NUMBER_INT, VALUE_NUMBER_FLOAT -> new JsonValue(parser.getDoubleValue(), at);
      case VALUE_TRUE, VALUE_FALSE -> new JsonValue(parser.getBooleanValue(), at);
      case VALUE_NULL -> new JsonValue(NOTHING, at);
      default -> new JsonValue(parser.getText(), at);
    };
  }

  /** Where it begins. */
  public Location at() {
    return at;
  }

  boolean isNull() {
    return value == NOTHING;
  }

  /** Empty when it is no text. */
  public Optional<String> text() {
    return value instanceof String text ? Optional.of(text) : Optional.empty();
  }

  /** NaN when it is no number. */
  public double number() {
    return value instanceof Double number ? number : Double.NaN;
  }

  /** Empty when it is neither true nor false. */
  Optional<Boolean> truth() {
    return value instanceof Boolean truth ? Optional.of(truth) : Optional.empty();
  }

  /** Empty when it is no list. */
  Optional<List<JsonValue>> list() {
    return value instanceof List<?> list
        ? Optional.of(list.stream().map(JsonValue.class::cast).toList())
        : Optional.empty();
  }

  /** In their order; empty when it is no object. */
  Optional<Map<String, Member>> members() {
    if (!(value instanceof Map<?, ?> map)) {
      return Optional.empty();
    }
    Map<String, Member> members = new LinkedHashMap<>();
    map.forEach((name, member) -> members.put((String) name, (Member) member));
    return Optional.of(members);
  }

  /** For messages. */
  @Override
  public String toString() {
    return value == NOTHING
        ? "null"
        : value instanceof Map ? "{...}" : value instanceof List ? "[...]" : value.toString();
  }
}
