package org.selectiverenderer.formats.json;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.StreamReadFeature;
import com.fasterxml.jackson.core.json.JsonReadFeature;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.CharacterCodingException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Function;
import org.selectiverenderer.base.files.InputFileReader;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;

/**
 * Reads hand-written JSON files of one kind; the package describes the rules.
 *
 * @param subject the noun for such a file in messages, such as {@code a study}
 * @param outcome the consequence of an error, such as {@code the study is not used}
 */
public record JsonSettingsReader(String subject, String outcome) {
  static final JsonFactory FACTORY =
      JsonFactory.builder()
          .enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION)
          .enable(JsonReadFeature.ALLOW_JAVA_COMMENTS)
          .enable(JsonReadFeature.ALLOW_TRAILING_COMMA)
          .build();

  /** The byte order mark that some editors write at the beginning of UTF-8 text. */
  static final String MARK = "\uFEFF";

  /**
   * Reads a file.
   *
   * @param content reads all keys that the file may have; its result is discarded if the file has
   *     errors
   * @return empty if the file has errors, which are then in {@code problems}
   * @throws IOException if it cannot be read at all
   */
  public <T> Optional<T> read(
      Path file, ProblemCollector problems, Function<JsonObjectReader, T> content)
      throws IOException {
    try {
      return parse(file.toString(), InputFileReader.text(file), problems, content);
    } catch (CharacterCodingException e) {
      new JsonErrorReporter(file.toString(), outcome, problems)
          .at(new SourceLocation(file.toString(), 1, 1), "the file is not UTF-8 text");
      return Optional.empty();
    }
  }

  /**
   * Reads a text.
   *
   * @param file its name, for messages
   */
  public <T> Optional<T> parse(
      String file, String text, ProblemCollector problems, Function<JsonObjectReader, T> content) {
    ProblemCollector own = new ProblemCollector(problems::add);
    JsonErrorReporter faults = new JsonErrorReporter(file, outcome, own);
    Optional<T> read =
        root(text.startsWith(MARK) ? text.substring(1) : text, faults)
            .map(
                root -> {
                  JsonObjectReader members = JsonObjectReader.of(root, subject, faults);
                  members.text("$schema", false);
                  return members.all(content);
                });
    return own.any() ? Optional.empty() : read;
  }

  private Optional<LocatedJsonValue> root(String text, JsonErrorReporter faults) {
    try (JsonParser parser = FACTORY.createParser(text)) {
      if (parser.nextToken() == null) {
        faults.at(SourceLocation.of(faults.file()), "the file is empty");
        return Optional.empty();
      }
      LocatedJsonValue root = LocatedJsonValue.read(parser, faults);
      if (parser.nextToken() != null) {
        faults.at(
            faults.place(parser.currentTokenLocation()),
            "there is text after the end of " + subject);
      }
      return Optional.of(root);
    } catch (JsonProcessingException e) {
      faults.noJson(e);
      return Optional.empty();
    } catch (IOException e) {
      throw new UncheckedIOException(e); // reading a string does not fail
    }
  }
}
