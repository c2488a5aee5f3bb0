package org.selectiverenderer.enricher.text;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.Reader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.text.MessageFormat;
import java.util.List;
import java.util.Locale;
import java.util.Properties;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.ResourceLock;
import org.junit.jupiter.api.parallel.Resources;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** What the window says, in both languages. */
class TextsTest {
  private static final Path FOLDER =
      Path.of("tools/enricher-gui/src/main/resources/org/selectiverenderer/enricher/text");
  private static final Path SOURCES =
      Path.of("tools/enricher-gui/src/main/java/org/selectiverenderer/enricher");
  private static final Pattern ARGUMENT = Pattern.compile("\\{(\\d+)");
  private static final Pattern USED =
      Pattern.compile("\\b(?:Texts\\.of|command|menu)\\(\\s*\"([a-z]+)\\.([^\"]+)\"");

  static List<String> bundles() throws IOException {
    try (Stream<Path> files = Files.list(FOLDER)) {
      return files
          .map(file -> file.getFileName().toString())
          .filter(name -> !name.contains("_"))
          .map(name -> name.replace(".properties", ""))
          .sorted()
          .toList();
    }
  }

  @ParameterizedTest
  @MethodSource("bundles")
  void bothLanguagesHaveTheSameTextsWithTheSameArguments(String bundle) throws IOException {
    Properties english = read(bundle + ".properties");
    Properties greek = read(bundle + "_el.properties");
    assertThat(greek.stringPropertyNames()).isEqualTo(english.stringPropertyNames());
    for (String key : english.stringPropertyNames()) {
      assertThat(arguments(greek.getProperty(key)))
          .as(key)
          .isEqualTo(arguments(english.getProperty(key)));
    }
  }

  @ParameterizedTest
  @MethodSource("bundles")
  void apostrophesAreDoubledAndFormatsCanBeRead(String bundle) throws IOException {
    for (String language : List.of("", "_el")) {
      Properties texts = read(bundle + language + ".properties");
      for (String key : texts.stringPropertyNames()) {
        String text = texts.getProperty(key);
        assertThat(text.replace("''", "")).as(key).doesNotContain("'").isNotBlank();
        assertThat(new MessageFormat(text, Locale.ROOT).toPattern()).as(key).isNotEmpty();
      }
    }
  }

  @Test
  void everyTextThatIsNamedIsThere() throws IOException {
    List<Path> sources;
    try (Stream<Path> files = Files.walk(SOURCES)) {
      sources = files.filter(file -> file.toString().endsWith(".java")).toList();
    }
    for (Path source : sources) {
      Matcher used = USED.matcher(Files.readString(source));
      while (used.find()) {
        String key = used.group(2);
        assertThat(read(used.group(1) + ".properties").stringPropertyNames())
            .as(source + " names " + used.group())
            .anyMatch(each -> key.endsWith(".") ? each.startsWith(key) : each.equals(key));
      }
    }
  }

  @Test
  @ResourceLock(Resources.LOCALE)
  void speaksTheLanguageOfTheDisplayAndElseEnglish() {
    Locale before = Locale.getDefault(Locale.Category.DISPLAY);
    try {
      Locale.setDefault(Locale.Category.DISPLAY, Locale.forLanguageTag("el-GR"));
      assertThat(Texts.of("menu.file")).isEqualTo("&Αρχείο");
      Locale.setDefault(Locale.Category.DISPLAY, Locale.FRENCH);
      assertThat(Texts.of("menu.file")).isEqualTo("&File");
    } finally {
      Locale.setDefault(Locale.Category.DISPLAY, before);
    }
  }

  private static TreeSet<String> arguments(String text) {
    TreeSet<String> numbers = new TreeSet<>();
    Matcher argument = ARGUMENT.matcher(text);
    while (argument.find()) {
      numbers.add(argument.group(1));
    }
    return numbers;
  }

  private static Properties read(String name) throws IOException {
    Properties texts = new Properties();
    try (Reader reader = Files.newBufferedReader(FOLDER.resolve(name), StandardCharsets.UTF_8)) {
      texts.load(reader);
    }
    return texts;
  }
}
