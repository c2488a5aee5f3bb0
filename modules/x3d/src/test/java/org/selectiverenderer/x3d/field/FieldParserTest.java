package org.selectiverenderer.x3d.field;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Locale;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.Problem;

class FieldParserTest {
  private final FieldParser parser = new FieldParser();

  private Object clean(FieldType type, String text) {
    FieldParser.Parsed parsed = parser.parse(type, text);
    assertThat(parsed.flaws()).isEmpty();
    return parsed.value();
  }

  private FieldParser.Flaw flaw(FieldType type, String text) {
    FieldParser.Parsed parsed = parser.parse(type, text);
    assertThat(parsed.flaws()).hasSize(1);
    return parsed.flaws().get(0);
  }

  @Test
  void readsSingleValues() {
    assertThat(clean(FieldType.SFBool, " true ")).isEqualTo(true);
    assertThat(clean(FieldType.SFInt32, "-12")).isEqualTo(-12);
    assertThat(clean(FieldType.SFInt32, "2147483647")).isEqualTo(Integer.MAX_VALUE);
    assertThat(clean(FieldType.SFInt32, "-2147483648")).isEqualTo(Integer.MIN_VALUE);
    assertThat(clean(FieldType.SFInt32, "0xFF")).isEqualTo(255);
    assertThat(clean(FieldType.SFFloat, "1.5e-3")).isEqualTo(0.0015f);
    assertThat(clean(FieldType.SFFloat, ".5")).isEqualTo(0.5f);
    assertThat(clean(FieldType.SFFloat, "-5.")).isEqualTo(-5f);
    assertThat(clean(FieldType.SFTime, "1e3")).isEqualTo(1000.0);
    assertThat(clean(FieldType.SFString, " \"as it is\\ ")).isEqualTo(" \"as it is\\ ");
    assertThat((float[]) clean(FieldType.SFVec3f, "1, 2 ,3")).containsExactly(1, 2, 3);
    assertThat((double[]) clean(FieldType.SFVec2d, "0.1 0.2")).containsExactly(0.1, 0.2);
    assertThat((float[]) clean(FieldType.SFMatrix3f, "1 0 0 0 1 0 0 0 1")).hasSize(9);
  }

  @Test
  void readsManyValuesWithOrWithoutCommasAndWithAnyWhiteSpace() {
    assertThat((float[]) clean(FieldType.MFVec3f, "0 1 2,3 4\t5\r\n,  6 7 8,"))
        .containsExactly(0, 1, 2, 3, 4, 5, 6, 7, 8);
    assertThat((int[]) clean(FieldType.MFInt32, "0 1 2 -1,+3")).containsExactly(0, 1, 2, -1, 3);
    assertThat((boolean[]) clean(FieldType.MFBool, "true,false true"))
        .containsExactly(true, false, true);
    assertThat((double[]) clean(FieldType.MFTime, "")).isEmpty();
    assertThat((int[]) clean(FieldType.MFInt32, " ")).isEmpty();
    assertThat((int[]) clean(FieldType.MFInt32, "7 ".repeat(5000))).hasSize(5000).containsOnly(7);
    assertThat((float[]) clean(FieldType.MFFloat, "7 ".repeat(5000))).hasSize(5000).containsOnly(7);
  }

  @Test
  void readsQuotedStrings() {
    assertThat((String[]) clean(FieldType.MFString, "\"a b\" \"c\",\"\""))
        .containsExactly("a b", "c", "");
    assertThat(
            (String[]) clean(FieldType.MFString, "\"say \\\"hi\\\"\" \"back\\\\slash\" \"a\\b\""))
        .containsExactly("say \"hi\"", "back\\slash", "a\\b");
    assertThat((String[]) clean(FieldType.MFString, "")).isEmpty();
  }

  @Test
  void takesAStringWithoutQuotesAsOne() {
    FieldParser.Parsed parsed = parser.parse(FieldType.MFString, " my file.png ");
    assertThat((String[]) parsed.value()).containsExactly("my file.png");
    assertThat(parsed.flaws().get(0).severity()).isEqualTo(Problem.Severity.WARNING);
    assertThat(parsed.flaws().get(0).offset()).isEqualTo(1);
  }

  @Test
  void keepsWhatIsReadOfAStringThatIsNotClosed() {
    FieldParser.Parsed parsed = parser.parse(FieldType.MFString, "\"a\" \"b");
    assertThat((String[]) parsed.value()).containsExactly("a", "b");
    assertThat(parsed.flaws().get(0).offset()).isEqualTo(4);
    assertThat((String[]) parser.parse(FieldType.MFString, "\"a\" b \"c\"").value())
        .containsExactly("a", "b", "c");
  }

  @Test
  void dropsAnIncompleteLastTuple() {
    FieldParser.Parsed parsed = parser.parse(FieldType.MFVec3f, "0 0 0 1 1 1 2 2 2 3 3");
    assertThat((float[]) parsed.value()).containsExactly(0, 0, 0, 1, 1, 1, 2, 2, 2);
    assertThat(parsed.flaws().get(0).offset()).isEqualTo(18);
    assertThat(parsed.flaws().get(0).message())
        .isEqualTo("the last value has only 2 of its 3 numbers; they are left out");
  }

  @Test
  void aSingleValueOfTheWrongLengthIsToldWithItsPlace() {
    assertThat(flaw(FieldType.SFVec3f, "1 2").message()).contains("default");
    assertThat(parser.parse(FieldType.SFVec3f, "1 2").value()).isNull();
    assertThat(flaw(FieldType.SFVec3f, " 1 2 3 4").offset()).isEqualTo(7);
    assertThat((float[]) parser.parse(FieldType.SFVec3f, "1 2 3 4").value())
        .containsExactly(1, 2, 3);
    assertThat(parser.parse(FieldType.SFInt32, "").value()).isNull();
    assertThat(parser.parse(FieldType.SFBool, "").value()).isNull();
  }

  @Test
  void replacesWhatIsNoNumberByZero() {
    FieldParser.Parsed parsed = parser.parse(FieldType.MFFloat, "1 NaN -Infinity abc 1f 1..2 - 2");
    assertThat((float[]) parsed.value()).containsExactly(1, 0, 0, 0, 0, 0, 0, 2);
    assertThat(parsed.flaws())
        .extracting(FieldParser.Flaw::offset)
        .containsExactly(2, 6, 16, 20, 23, 28);
    assertThat(parsed.flaws().get(0).message())
        .isEqualTo("'NaN' is not a finite number; 0 is used instead");
    assertThat(flaw(FieldType.SFFloat, "1e50").message()).contains("too large");
    assertThat(flaw(FieldType.SFDouble, "1e500").message()).contains("too large");
    assertThat(flaw(FieldType.SFDouble, "nan").message()).contains("0 is used");
  }

  @Test
  void integersOutOfRangeOrWithAFractionAreTold() {
    assertThat(flaw(FieldType.MFInt32, "1 2147483648").offset()).isEqualTo(2);
    assertThat((int[]) parser.parse(FieldType.MFInt32, "1 99999999999").value())
        .containsExactly(1, 0);
    assertThat((int[]) parser.parse(FieldType.MFInt32, "1.0 x 0x 0x1FFFFFFFF").value())
        .containsExactly(1, 0, 0, 0);
    assertThat(flaw(FieldType.MFInt32, "9".repeat(1000)).message()).hasSizeLessThan(120);
  }

  @Test
  void aBooleanInCapitalsIsUnderstood() {
    FieldParser.Parsed parsed = parser.parse(FieldType.SFBool, "TRUE");
    assertThat(parsed.value()).isEqualTo(true);
    assertThat(parsed.flaws().get(0).severity()).isEqualTo(Problem.Severity.WARNING);
    assertThat(parser.parse(FieldType.SFBool, "yes").value()).isNull();
  }

  @Test
  void anImageKeepsItsCompleteRows() {
    assertThat((int[]) clean(FieldType.SFImage, "1 2 3 0xFF0000 0x00FF00"))
        .containsExactly(1, 2, 3, 0xff0000, 0xff00);
    assertThat((int[]) clean(FieldType.SFImage, "0 0 0")).containsExactly(0, 0, 0);
    assertThat((int[]) parser.parse(FieldType.SFImage, "2 2 1 1 2 3").value())
        .containsExactly(2, 1, 1, 1, 2);
    assertThat((int[]) parser.parse(FieldType.SFImage, "65535 65535 4 1").value())
        .containsExactly(65535, 0, 4);
    assertThat(parser.parse(FieldType.SFImage, "2").value()).isNull();
    assertThat(parser.parse(FieldType.SFImage, "-2 -2 1 1 1 1 1").value()).isNull();
    assertThat((int[]) clean(FieldType.MFImage, "1 1 1 7 0 0 0")).hasSize(7);
  }

  @Test
  void aMillionBadNumbersGiveFewProblems() {
    FieldParser.Parsed parsed = parser.parse(FieldType.MFFloat, "x ".repeat(1_000_000));
    assertThat((float[]) parsed.value()).hasSize(1_000_000);
    assertThat(parsed.flaws()).hasSize(10);
    assertThat(parsed.flaws().get(9).message()).contains("999990 more");
  }

  @Test
  void numbersAreRoundedCorrectly() {
    Random random = new Random(42);
    for (int i = 0; i < 300_000; i++) {
      String text =
          switch (i % 6) {
            case 0 -> String.format(Locale.ROOT, "%.5f", random.nextGaussian() * 10);
            case 1 -> Float.toString(Float.intBitsToFloat(random.nextInt()));
            case 2 -> Double.toString(random.nextDouble());
            case 3 -> Double.toString(Double.longBitsToDouble(random.nextLong()));
            // Close to the middle between two floats, where rounding twice would show.
            case 4 ->
                Double.toString(
                    Math.nextUp(1 + random.nextFloat()) + Math.scalb(random.nextInt(3) - 1, -24));
            default -> random.nextInt() + "e" + (random.nextInt(60) - 30);
          };
      float expected = Float.parseFloat(text);
      if (Float.isFinite(expected)) {
        assertThat((Float) parser.parse(FieldType.SFFloat, text).value())
            .as(text)
            .isEqualTo(expected);
      }
      double wide = Double.parseDouble(text);
      if (Double.isFinite(wide)) {
        assertThat((Double) parser.parse(FieldType.SFDouble, text).value())
            .as(text)
            .isEqualTo(wide);
      }
    }
    // The middle between 1 and the next float, and a decimal just above that a double cannot tell.
    assertThat(clean(FieldType.SFFloat, "1.00000005960464477539062501"))
        .isEqualTo(Float.parseFloat("1.00000005960464477539062501"));
    assertThat(clean(FieldType.SFFloat, "1.0000000596046448")).isEqualTo(Math.nextUp(1f));
    assertThat(Float.floatToRawIntBits((Float) clean(FieldType.SFFloat, "-0")))
        .isEqualTo(Float.floatToRawIntBits(-0f));
  }

  @Test
  void nodesHaveNoTextForm() {
    assertThatThrownBy(() -> parser.parse(FieldType.SFNode, "NULL"))
        .isInstanceOf(IllegalArgumentException.class);
  }

  /** Words in any form and number, so that usual ones and others follow each other at any place. */
  @Test
  void numbersOfUsualAndOtherFormsAreReadAlikeWhereverTheyStand() {
    Random random = new Random(5);
    String[] odd = {"1e2", "-3.5E-1", "0.12345678901", "123456789012", "+.5", "16777217", "-0"};
    for (int round = 0; round < 400; round++) {
      int count = random.nextInt(round % 4 == 0 ? 3000 : 600);
      int rare = 1 + random.nextInt(300);
      StringBuilder text = new StringBuilder();
      float[] expected = new float[count];
      for (int i = 0; i < count; i++) {
        boolean usual = random.nextInt(rare) > 0;
        String word =
            usual
                ? String.format(
                    Locale.ROOT,
                    "%." + random.nextInt(6) + "f",
                    (random.nextInt(1 << 1 + random.nextInt(20)) - 900) / 1000.0)
                : odd[random.nextInt(odd.length)];
        expected[i] = Float.parseFloat(word);
        text.append(word).append(" ,\n ".charAt(random.nextInt(4)));
      }
      float[] read = (float[]) clean(FieldType.MFFloat, text.toString());
      assertThat(read).hasSameSizeAs(expected);
      for (int i = 0; i < count; i++) {
        assertThat(Float.floatToRawIntBits(read[i]))
            .isEqualTo(Float.floatToRawIntBits(expected[i]));
      }
    }
  }

  @Test
  void integersOfUsualAndOtherFormsAreReadAlikeWhereverTheyStand() {
    Random random = new Random(6);
    for (int round = 0; round < 200; round++) {
      int count = random.nextInt(2000);
      int rare = 1 + random.nextInt(300);
      StringBuilder text = new StringBuilder();
      int[] expected = new int[count];
      for (int i = 0; i < count; i++) {
        boolean usual = random.nextInt(rare) > 0;
        expected[i] = usual ? random.nextInt(1 << 1 + random.nextInt(29)) - 1 : random.nextInt();
        boolean hexadecimal = !usual && random.nextBoolean();
        text.append(
                hexadecimal
                    ? "0x" + Integer.toHexString(expected[i])
                    : Integer.toString(expected[i]))
            .append(" ,\t ".charAt(random.nextInt(4)));
      }
      assertThat((int[]) clean(FieldType.MFInt32, text.toString())).isEqualTo(expected);
    }
  }

  @Test
  void faultBehindManyUsualNumbersIsFoundAtItsPlace() {
    for (int before : new int[] {0, 1, 255, 256, 257, 1023, 1024, 1025, 4096}) {
      assertThat(flaw(FieldType.MFFloat, "1.5 ".repeat(before) + "x2 3").offset())
          .isEqualTo(4 * before);
      assertThat(flaw(FieldType.MFInt32, "15 ".repeat(before) + "2.5 3").offset())
          .isEqualTo(3 * before);
      assertThat((float[]) parser.parse(FieldType.MFFloat, "1 ".repeat(before) + "- 3").value())
          .hasSize(before + 2)
          .endsWith(0, 3);
    }
  }
}
