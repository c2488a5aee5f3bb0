package org.selectiverenderer.formats.json;

import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.JsonToken;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Edits an array of objects in a hand-written JSON text in place: everything else, including
 * comments and white space, stays character for character.
 */
public final class JsonArrayEditor {
  private record Span(int from, int to) {}

  private record Item(Span place, Map<String, Span> values) {}

  private final String text;
  private final String key;
  private final List<Item> items = new ArrayList<>();
  private Optional<Span> list = Optional.empty();
  private int rootStart;
  private boolean empty = true;

  /**
   * Parses a text.
   *
   * @param text a text that {@link JsonSettingsReader} reads without an error
   * @param key the key of the array in the root object; the text may lack it
   * @throws IllegalArgumentException if the text is not a JSON object
   */
  public JsonArrayEditor(String text, String key) {
    this.text = text;
    this.key = key;
    int mark = text.startsWith(JsonSettingsReader.MARK) ? 1 : 0;
    try (JsonParser parser = JsonSettingsReader.FACTORY.createParser(text.substring(mark))) {
      read(parser, mark);
    } catch (JsonProcessingException e) {
      throw new IllegalArgumentException("no JSON: " + JsonErrorReporter.sentence(e), e);
    } catch (IOException e) {
      throw new UncheckedIOException(e); // reading a string does not fail
    }
  }

  private void read(JsonParser parser, int mark) throws IOException {
    if (parser.nextToken() != JsonToken.START_OBJECT) {
      throw new IllegalArgumentException("no JSON object");
    }
    rootStart = begin(parser) + mark;
    while (parser.nextToken() == JsonToken.FIELD_NAME) {
      empty = false;
      boolean wanted = parser.currentName().equals(key);
      JsonToken value = parser.nextToken();
      int from = begin(parser) + mark;
      if (wanted && value == JsonToken.START_ARRAY) {
        while (parser.nextToken() != JsonToken.END_ARRAY) {
          items.add(item(parser, mark));
        }
      } else {
        parser.skipChildren();
      }
      if (wanted) {
        list = Optional.of(new Span(from, end(parser) + mark));
      }
    }
  }

  private static Item item(JsonParser parser, int mark) throws IOException {
    int from = begin(parser) + mark;
    Map<String, Span> values = new HashMap<>();
    if (parser.currentToken() == JsonToken.START_OBJECT) {
      while (parser.nextToken() == JsonToken.FIELD_NAME) {
        String name = parser.currentName();
        parser.nextToken();
        int valueFrom = begin(parser) + mark;
        parser.skipChildren();
        values.put(name, new Span(valueFrom, end(parser) + mark));
      }
    } else {
      parser.skipChildren();
    }
    return new Item(new Span(from, end(parser) + mark), values);
  }

  private static int begin(JsonParser parser) {
    return (int) parser.currentTokenLocation().getCharOffset();
  }

  /** Returns the offset after the current token, which is read to its end first. */
  static int end(JsonParser parser) throws IOException {
    if (parser.currentToken().isScalarValue()) {
      return begin(parser) + written(parser);
    }
    return (int) parser.currentLocation().getCharOffset();
  }

  /** Returns the length of a scalar; after a number the parser has read ahead. */
  private static int written(JsonParser parser) throws IOException {
    if (parser.currentToken() == JsonToken.VALUE_STRING) {
      parser.finishToken();
      return (int) parser.currentLocation().getCharOffset() - begin(parser);
    }
    return parser.getTextLength();
  }

  /** Returns the number of elements of the array. */
  public int size() {
    return items.size();
  }

  /**
   * Returns the text with another value for a member of an object.
   *
   * @param index the index of the object in the array
   * @param member the key of an existing member
   * @param value the new value as JSON
   */
  public String with(int index, String member, String value) {
    Span at = Optional.ofNullable(items.get(index).values().get(member)).orElseThrow();
    return text.substring(0, at.from()) + value + text.substring(at.to());
  }

  /**
   * Returns the text with an object appended to the array, which is created if it is missing.
   *
   * @param object the object as JSON in one line
   */
  public String added(String object) {
    String line = text.contains("\r\n") ? "\r\n" : "\n";
    if (!items.isEmpty()) {
      Item last = items.get(items.size() - 1);
      String before = indentation(last.place().from());
      String gap = before.isEmpty() ? " " : line + before.substring(1);
      return insert(last.place().to(), "," + gap + object);
    }
    String block = "[" + line + "    " + object + line + "  ]";
    if (list.isPresent()) {
      return text.substring(0, list.get().from()) + block + text.substring(list.get().to());
    }
    String member = line + "  \"" + key + "\": " + block;
    boolean broken = text.startsWith("\n", rootStart + 1) || text.startsWith("\r", rootStart + 1);
    return insert(rootStart + 1, member + (!empty ? "," : broken ? "" : line));
  }

  /**
   * Returns "|" and the indentation if an offset is the first in its line after blanks; else "".
   */
  private String indentation(int at) {
    int start = text.lastIndexOf('\n', at - 1) + 1;
    String before = text.substring(start, at);
    return before.isBlank() && start > 0 ? "|" + before : "";
  }

  private String insert(int at, String more) {
    return text.substring(0, at) + more + text.substring(at);
  }

  /** Returns the text without an object and without the comma that separated it. */
  public String without(int index) {
    Span place = items.get(index).place();
    if (items.size() == 1) { // a trailing comma would be invalid in an empty array
      Span all = list.orElseThrow();
      return text.substring(0, all.from()) + "[]" + text.substring(all.to());
    }
    if (index + 1 < items.size()) {
      return text.substring(0, place.from()) + text.substring(items.get(index + 1).place().from());
    }
    return text.substring(0, items.get(index - 1).place().to()) + text.substring(place.to());
  }
}
