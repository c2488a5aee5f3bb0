package org.selectiverenderer.study.questionnaire;

import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.Reader;
import java.io.StringReader;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.text.MessageFormat;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Properties;
import org.selectiverenderer.base.files.InputFileReader;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;

/**
 * The program's own messages to participants in questionnaires and forms, from a file {@code
 * messages_LANGUAGE.properties}: one beside the study file, else the built-in one. Messages that a
 * file lacks are in English.
 */
public final class ParticipantMessages {
  private final String language;
  private final Properties words;

  private ParticipantMessages(String language, Properties words) {
    this.language = language;
    this.words = words;
  }

  /** Returns the study's own file of messages in a language, which need not exist. */
  public static Path file(String language, Path folder) {
    return folder.resolve(name(language));
  }

  private static String name(String language) {
    return "messages_" + language + ".properties";
  }

  /**
   * Loads the messages of a language.
   *
   * @param folder the study's folder
   * @return empty if there are none for the language, which is then in {@code problems}
   * @throws IOException if a file cannot be read
   */
  public static Optional<ParticipantMessages> of(
      String language, Path folder, ProblemCollector problems) throws IOException {
    Properties words = new Properties(builtIn("messages_en.properties").orElseThrow());
    Path own = file(language, folder);
    if (Files.isRegularFile(own)) {
      try (Reader reader = new StringReader(InputFileReader.text(own))) {
        words.load(reader);
      } catch (CharacterCodingException e) {
        problems.error(
            new SourceLocation(own.toString(), 1, 1),
            "the file is not UTF-8 text; the study is not used");
        return Optional.empty();
      }
      return Optional.of(new ParticipantMessages(language, words));
    }
    Optional<Properties> known = builtIn(name(language));
    if (known.isEmpty()) {
      problems.error(
          SourceLocation.of(own.toString()),
          "there are no messages in the language '"
              + language
              + "'; create this file, or choose the language en or el");
      return Optional.empty();
    }
    known.get().forEach(words::put);
    return Optional.of(new ParticipantMessages(language, words));
  }

  private static Optional<Properties> builtIn(String name) throws IOException {
    try (InputStream in = ParticipantMessages.class.getResourceAsStream(name)) {
      if (in == null) {
        return Optional.empty();
      }
      Properties words = new Properties();
      words.load(new InputStreamReader(in, StandardCharsets.UTF_8));
      return Optional.of(words);
    }
  }

  /** Returns the keys without a message in this language, whose messages are English. */
  public List<String> untranslated() {
    return words.stringPropertyNames().stream()
        .filter(key -> !words.containsKey(key) && !key.startsWith("area."))
        .sorted()
        .toList();
  }

  /** Returns the keys that begin with a text, in alphabetical order. */
  public List<String> keys(String beginning) {
    return words.stringPropertyNames().stream()
        .filter(key -> key.startsWith(beginning))
        .sorted()
        .toList();
  }

  /** Returns the code of the language. */
  public String language() {
    return language;
  }

  /**
   * Returns the message of a key.
   *
   * @throws IllegalArgumentException if there is no such key
   */
  public String of(String key) {
    String text = words.getProperty(key);
    if (text == null) {
      throw new IllegalArgumentException("no texts for " + key);
    }
    return text;
  }

  /** Returns an area's name in the language; without a translation, as the study writes it. */
  public String area(String area) {
    return words.getProperty("area." + area, area);
  }

  /** Returns the message of a key with values for its placeholders. */
  public String filled(String key, Object... values) {
    return new MessageFormat(of(key).replace("'", "''"), Locale.ROOT).format(values);
  }
}
