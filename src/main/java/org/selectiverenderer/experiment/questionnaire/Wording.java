package org.selectiverenderer.experiment.questionnaire;

import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.Reader;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.text.MessageFormat;
import java.util.Locale;
import java.util.Optional;
import java.util.Properties;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.base.problem.Problems;

/**
 * The words of the program's own part of questionnaires and forms, from a file of messages: one
 * that lies beside the study file, {@code messages_LANGUAGE.properties}, else the built-in one.
 * What a file of one's own lacks is English.
 */
public final class Wording {
  private final String language;
  private final Properties words;

  private Wording(String language, Properties words) {
    this.language = language;
    this.words = words;
  }

  /**
   * The words of a language.
   *
   * @param folder of the study
   * @return empty when there are none, which is then in {@code problems}
   * @throws IOException if they cannot be read
   */
  public static Optional<Wording> of(String language, Path folder, Problems problems)
      throws IOException {
    String name = "messages_" + language + ".properties";
    Properties words = new Properties(builtIn("messages_en.properties").orElseThrow());
    Path own = folder.resolve(name);
    if (Files.isRegularFile(own)) {
      try (Reader reader = Files.newBufferedReader(own, StandardCharsets.UTF_8)) {
        words.load(reader);
      } catch (CharacterCodingException e) {
        problems.error(
            new Location(own.toString(), 1, 1),
            "the file is not UTF-8 text; the study is not used");
        return Optional.empty();
      }
      return Optional.of(new Wording(language, words));
    }
    Optional<Properties> known = builtIn(name);
    if (known.isEmpty()) {
      problems.error(
          Location.of(own.toString()),
          "there are no texts in the language '"
              + language
              + "': write this file, or choose en or el");
      return Optional.empty();
    }
    known.get().forEach(words::put);
    return Optional.of(new Wording(language, words));
  }

  private static Optional<Properties> builtIn(String name) throws IOException {
    try (InputStream in = Wording.class.getResourceAsStream(name)) {
      if (in == null) {
        return Optional.empty();
      }
      Properties words = new Properties();
      words.load(new InputStreamReader(in, StandardCharsets.UTF_8));
      return Optional.of(words);
    }
  }

  /** The code of the language. */
  public String language() {
    return language;
  }

  /**
   * The words for a key.
   *
   * @throws IllegalArgumentException if no language has that key
   */
  public String of(String key) {
    String text = words.getProperty(key);
    if (text == null) {
      throw new IllegalArgumentException("no texts for " + key);
    }
    return text;
  }

  /** An area's name: that of the words where they have it, else as the study writes it. */
  public String area(String area) {
    return words.getProperty("area." + area, area);
  }

  /** The words for a key, with what their braces stand for. */
  public String filled(String key, Object... values) {
    return new MessageFormat(of(key).replace("'", "''"), Locale.ROOT).format(values);
  }
}
