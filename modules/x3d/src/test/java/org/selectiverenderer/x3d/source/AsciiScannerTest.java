package org.selectiverenderer.x3d.source;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Blocks are of 512 bytes, which are looked at by eights. */
class AsciiScannerTest {
  private static final int LENGTH = 1100;

  @Test
  void aLetterBeyondAsciiIsFoundWhereverItStands() {
    byte[] text = digits();
    assertThat(AsciiScanner.only(text, 0, LENGTH)).isTrue();
    for (int at = 0; at < LENGTH; at++) {
      text[at] = (byte) 0xc3;
      assertThat(AsciiScanner.only(text, 0, LENGTH)).as("at %d", at).isFalse();
      assertThat(AsciiScanner.only(text, at, LENGTH)).as("at %d", at).isFalse();
      assertThat(AsciiScanner.only(text, at + 1, LENGTH)).as("behind %d", at).isTrue();
      assertThat(AsciiScanner.only(text, 0, at)).as("before %d", at).isTrue();
      text[at] = '7';
    }
  }

  @Test
  void aMarkIsFoundWhereverItStands() {
    byte[] text = digits();
    assertThat(AsciiScanner.mark(text, 0, LENGTH)).isEqualTo(LENGTH);
    for (int at = 0; at < LENGTH; at++) {
      text[at] = (byte) (at % 2 == 0 ? '<' : '=');
      assertThat(AsciiScanner.mark(text, 0, LENGTH)).isEqualTo(at);
      assertThat(AsciiScanner.mark(text, at, LENGTH)).isEqualTo(at);
      assertThat(AsciiScanner.mark(text, at + 1, LENGTH)).as("behind %d", at).isEqualTo(LENGTH);
      assertThat(AsciiScanner.mark(text, 0, at)).as("before %d", at).isEqualTo(at);
      text[at] = '7';
    }
  }

  @Test
  void ofAnyTextTheFirstMarkIsFound() {
    Random random = new Random(5);
    byte[] text = new byte[LENGTH];
    random.nextBytes(text); // Bytes beyond ASCII too, and neighbours of the marks in the alphabet.
    for (int from = 0; from < LENGTH; from++) {
      int expected = from;
      while (expected < LENGTH && text[expected] != '<' && text[expected] != '=') {
        expected++;
      }
      assertThat(AsciiScanner.mark(text, from, LENGTH)).isEqualTo(expected);
    }
  }

  private static byte[] digits() {
    byte[] text = new byte[LENGTH];
    Arrays.fill(text, (byte) '7');
    return text;
  }
}
