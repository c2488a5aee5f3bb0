package org.selectiverenderer.experiment.study;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonLocation;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.StreamReadFeature;
import com.fasterxml.jackson.core.json.JsonReadFeature;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.x3d.Location;
import org.selectiverenderer.x3d.Problems;

/**
 * A value of a JSON text that knows where it stands. Comments ({@code //} and {@code /* *}{@code
 * /}) and a comma after the last value are allowed.
 *
 * @param value a {@code String}, {@code Double} or {@code Boolean}, a list of parts, or a map from
 *     names to members; JSON's null is the empty string's like: {@link #NOTHING}
 */
record JsonPart(Object value, Location at) {
  /** What null reads as. */
  static final Object NOTHING = new Object();

  /** A value and where its name stands. */
  record Member(Location name, JsonPart part) {}

  private static final JsonFactory FACTORY =
      JsonFactory.builder()
          .enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION)
          .enable(JsonReadFeature.ALLOW_JAVA_COMMENTS)
          .enable(JsonReadFeature.ALLOW_TRAILING_COMMA)
          .build();

  /** Reads a text; empty when it is no JSON, which is then in {@code problems}. */
  static Optional<JsonPart> parse(String file, String text, Problems problems) {
    try (JsonParser parser = FACTORY.createParser(text)) {
      if (parser.nextToken() == null) {
        problems.error(Location.of(file), "the file is empty; the study is not used");
        return Optional.empty();
      }
      JsonPart part = read(file, parser);
      if (parser.nextToken() != null) {
        problems.error(
            place(file, parser.currentTokenLocation()),
            "there is more after the end of the study; the study is not used");
        return Optional.empty();
      }
      return Optional.of(part);
    } catch (JsonProcessingException e) {
      problems.error(
          place(file, e.getLocation()),
          "this is no JSON: " + e.getOriginalMessage() + "; the study is not used");
      return Optional.empty();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static JsonPart read(String file, JsonParser parser) throws IOException {
    Location at = place(file, parser.currentTokenLocation());
    return switch (parser.currentToken()) {
      case START_OBJECT -> {
        Map<String, Member> members = new LinkedHashMap<>();
        while (parser.nextToken() != JsonToken.END_OBJECT) {
          Location name = place(file, parser.currentTokenLocation());
          String key = parser.currentName();
          parser.nextToken();
          members.put(key, new Member(name, read(file, parser)));
        }
        yield new JsonPart(members, at);
      }
      case START_ARRAY -> {
        List<JsonPart> parts = new ArrayList<>();
        while (parser.nextToken() != JsonToken.END_ARRAY) {
          parts.add(read(file, parser));
        }
        yield new JsonPart(parts, at);
      }
      case VALUE_NUMBER_INT, VALUE_NUMBER_FLOAT -> new JsonPart(parser.getDoubleValue(), at);
      case VALUE_TRUE, VALUE_FALSE -> new JsonPart(parser.getBooleanValue(), at);
      case VALUE_NULL -> new JsonPart(NOTHING, at);
      default -> new JsonPart(parser.getText(), at);
    };
  }

  private static Location place(String file, JsonLocation at) {
    return at == null
        ? Location.of(file)
        : new Location(file, Math.max(1, at.getLineNr()), Math.max(1, at.getColumnNr()));
  }
}
