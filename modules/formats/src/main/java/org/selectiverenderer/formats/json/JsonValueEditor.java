package org.selectiverenderer.formats.json;

import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.io.JsonStringEncoder;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Optional;
import java.util.function.BinaryOperator;

/**
 * Changes values in a hand-written JSON text: everything else, including comments and white space,
 * stays character for character.
 */
public final class JsonValueEditor {
  /** Returns the JSON of a value's replacement; empty for a value that stays. */
  @FunctionalInterface
  private interface Replacement {
    Optional<String> of(JsonParser parser) throws IOException;
  }

  private JsonValueEditor() {}

  /**
   * Changes strings at any depth.
   *
   * @param text a text that {@link JsonSettingsReader} reads without an error
   * @param change returns the new string for a key, empty in an array, and a string
   * @throws IllegalArgumentException if the text is not JSON
   */
  public static String withStrings(String text, BinaryOperator<String> change) {
    return edited(
        text,
        parser -> {
          if (parser.currentToken() != JsonToken.VALUE_STRING) {
            return Optional.empty();
          }
          String name = parser.currentName();
          String before = parser.getText();
          String after = change.apply(name == null ? "" : name, before);
          return after.equals(before)
              ? Optional.empty()
              : Optional.of(
                  '"' + String.valueOf(JsonStringEncoder.getInstance().quoteAsString(after)) + '"');
        });
  }

  /**
   * Changes a number of the root object.
   *
   * @param text a text that {@link JsonSettingsReader} reads without an error
   * @throws IllegalArgumentException if the text is not JSON, or has no such number
   */
  public static String withNumber(String text, String key, long number) {
    boolean[] found = new boolean[1];
    String changed =
        edited(
            text,
            parser -> {
              boolean root =
                  parser.getParsingContext().getParent() != null
                      && parser.getParsingContext().getParent().inRoot();
              boolean meant =
                  root && parser.currentToken().isNumeric() && key.equals(parser.currentName());
              found[0] |= meant;
              return meant ? Optional.of(Long.toString(number)) : Optional.empty();
            });
    if (!found[0]) {
      throw new IllegalArgumentException("the text has no number " + key);
    }
    return changed;
  }

  private static String edited(String text, Replacement replacement) {
    int mark = text.startsWith(JsonSettingsReader.MARK) ? 1 : 0;
    StringBuilder edited = new StringBuilder();
    int at = 0;
    try (JsonParser parser = JsonSettingsReader.FACTORY.createParser(text.substring(mark))) {
      while (parser.nextToken() != null) {
        Optional<String> after =
            parser.currentToken().isScalarValue() ? replacement.of(parser) : Optional.empty();
        if (after.isPresent()) {
          int from = (int) parser.currentTokenLocation().getCharOffset() + mark;
          edited.append(text, at, from).append(after.get());
          at = JsonArrayEditor.end(parser) + mark;
        }
      }
    } catch (JsonProcessingException e) {
      throw new IllegalArgumentException("no JSON: " + JsonErrorReporter.sentence(e), e);
    } catch (IOException e) {
      throw new UncheckedIOException(e); // reading a string does not fail
    }
    return edited.append(text, at, text.length()).toString();
  }
}
