package org.selectiverenderer.app.start.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Locale;
import java.util.ResourceBundle;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class StartTextsTest {
  /** The name of the program is the same in both. */
  private static final Set<String> SAME = Set.of("title");

  private static ResourceBundle bundle(String language) {
    return ResourceBundle.getBundle(
        "org.selectiverenderer.app.start.window.start",
        Locale.forLanguageTag(language),
        ResourceBundle.Control.getNoFallbackControl(ResourceBundle.Control.FORMAT_PROPERTIES));
  }

  @Test
  void eachTextIsTranslatedWithTheSameArguments() {
    ResourceBundle english = bundle("en");
    ResourceBundle greek = bundle("el");
    for (String key : new TreeSet<>(english.keySet())) {
      if (!SAME.contains(key)) {
        assertThat(greek.getString(key)).as(key).isNotEqualTo(english.getString(key));
      }
      for (String argument : List.of("{0}", "{1}")) {
        assertThat(greek.getString(key).contains(argument))
            .as("%s has %s in both languages", key, argument)
            .isEqualTo(english.getString(key).contains(argument));
      }
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"en", "el"})
  void mnemonicsOfOneWindowAreDifferent(String language) {
    ResourceBundle texts = bundle(language);
    for (List<String> window :
        List.of(
            List.of("open", "enrich", "studies", "doctor", "recent.open", "show", "edit"),
            List.of("copy.folder", "copy.choose", "copy.do", "copy.cancel"),
            List.of("doctor.copy", "doctor.close"))) {
      assertThat(window.stream().map(texts::getString).flatMap(StartTextsTest::letter).toList())
          .as("%s %s", language, window)
          .doesNotHaveDuplicates();
    }
  }

  private static Stream<String> letter(String text) {
    int sign = text.indexOf('&');
    return sign < 0
        ? Stream.empty()
        : Stream.of(text.substring(sign + 1, sign + 2).toLowerCase(Locale.ROOT));
  }
}
