package org.selectiverenderer.scriptengine;

import static org.assertj.core.api.Assertions.assertThat;

import java.text.Collator;
import java.text.Normalizer;
import java.util.Locale;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class TextPartsTest {
  /** Letters that become several, whose form depends on the word, marks, pairs of surrogates. */
  private static final String[] WORDS = {
    "straße ",
    "ΟΔΥΣΣΕΥΣ ",
    "a\u0301\u0323b ",
    "𝒳𝒴 ",
    "ﬁne, ",
    "İstanbul ",
    "각 ",
    "\uAC01 ",
    "x",
    ". "
  };

  static Stream<String> texts() {
    Random random = new Random(31);
    return Stream.of(0, 1, 999, 1000, 1001, 5000, 40_000)
        .map(
            length -> {
              StringBuilder text = new StringBuilder();
              while (text.length() < length) {
                text.append(WORDS[random.nextInt(WORDS.length)]);
              }
              return text.toString();
            });
  }

  @ParameterizedTest
  @MethodSource("texts")
  void partsOfWordsBecomeWhatTheWholeBecomes(String text) {
    assertThat(MeteredMethods.toUpperCase(text, Locale.ROOT))
        .isEqualTo(text.toUpperCase(Locale.ROOT));
    assertThat(MeteredMethods.toLowerCase(text, Locale.ROOT))
        .isEqualTo(text.toLowerCase(Locale.ROOT));
    for (Normalizer.Form form : Normalizer.Form.values()) {
      assertThat(MeteredStatics.normalize(text, form)).isEqualTo(Normalizer.normalize(text, form));
    }
  }

  @Test
  void aTextWithoutWordsKeepsItsPairsOfSurrogates() {
    String text = "x" + "\uD83D\uDE00".repeat(3000);

    assertThat(MeteredMethods.toLowerCase(text, Locale.ROOT)).isEqualTo(text);
    assertThat(MeteredStatics.normalize(text, Normalizer.Form.NFC)).isEqualTo(text);
  }

  @Test
  void longTextsAreComparedByTheLanguageAndThenByCharacter() {
    Collator collator = Collator.getInstance(Locale.ENGLISH);
    String same = "e".repeat(TextParts.LENGTH);

    assertThat(MeteredMethods.compare(collator, "a" + same, "B" + same)).isNegative();
    assertThat(MeteredMethods.compare(collator, same + "b", same + "a")).isPositive();
    assertThat(MeteredMethods.compare(collator, same + "a", same + "a")).isZero();
  }
}
