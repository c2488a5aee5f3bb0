package org.selectiverenderer.app.studies.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Locale;
import java.util.ResourceBundle;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.app.studies.ParticipantCheck;
import org.selectiverenderer.study.definition.SessionFlag;
import org.selectiverenderer.study.session.StudyStatus;

class StudyTextsTest {
  private static ResourceBundle bundle(String language) {
    return ResourceBundle.getBundle(
        "org.selectiverenderer.app.studies.window.studies",
        Locale.forLanguageTag(language),
        ResourceBundle.Control.getNoFallbackControl(ResourceBundle.Control.FORMAT_PROPERTIES));
  }

  @Test
  void bothLanguagesHaveTheSameTexts() {
    ResourceBundle greek = bundle("el");
    Set<String> own = new TreeSet<>();
    // The keys of the Greek file itself: those of its parent come through keySet, too.
    bundle("en")
        .keySet()
        .forEach(
            key -> {
              if (!greek.getString(key).equals(bundle("en").getString(key))) {
                own.add(key);
              }
            });
    assertThat(own).containsExactlyInAnyOrderElementsOf(new TreeSet<>(bundle("en").keySet()));
    for (String key : own) {
      for (String argument : List.of("{0}", "{1}", "{2}")) {
        assertThat(greek.getString(key).contains(argument))
            .as("%s has %s in both languages", key, argument)
            .isEqualTo(bundle("en").getString(key).contains(argument));
      }
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"en", "el"})
  void everyStateHasAText(String language) {
    ResourceBundle texts = bundle(language);
    for (ParticipantCheck.Answer answer : ParticipantCheck.Answer.values()) {
      assertThat(texts.containsKey("check." + answer.name().toLowerCase(Locale.ROOT))).isTrue();
    }
    for (StudyStatus.State state : StudyStatus.State.values()) {
      assertThat(texts.containsKey("state." + state.name().toLowerCase(Locale.ROOT))).isTrue();
    }
    for (SessionFlag flag : SessionFlag.values()) {
      assertThat(texts.containsKey("flag." + flag.spelling())).as(flag.spelling()).isTrue();
    }
  }

  /** What shows at the same time: the tabs with one page, and the start page alone. */
  @ParameterizedTest
  @ValueSource(strings = {"en", "el"})
  void mnemonicsOfOnePageAreDifferent(String language) {
    ResourceBundle texts = bundle(language);
    for (List<String> page :
        List.of(
            List.of("start."),
            List.of("new.", "cancel"),
            List.of("tab.", "back", "session.", "live.abort"),
            List.of("tab.", "back", "plan"),
            List.of("tab.", "back", "sessions."),
            List.of("tab.", "back", "check.run", "preview."),
            List.of("tab.", "back", "results."))) {
      List<String> letters =
          texts.keySet().stream()
              .filter(key -> page.stream().anyMatch(key::startsWith))
              .map(texts::getString)
              .flatMap(StudyTextsTest::letter)
              .toList();
      assertThat(letters).as("%s %s", language, page).doesNotHaveDuplicates();
    }
  }

  private static Stream<String> letter(String text) {
    int sign = text.indexOf('&');
    return sign < 0
        ? Stream.empty()
        : Stream.of(text.substring(sign + 1, sign + 2).toLowerCase(Locale.ROOT));
  }

  @Test
  void neighboursOfAPlanAreOne() {
    assertThat(PlanPage.runs(List.of("a", "a", "b", "a")).stream().collect(Collectors.joining(" ")))
        .isEqualTo("2 \u00d7 a b a");
    assertThat(PlanPage.runs(List.of())).isEmpty();
  }
}
