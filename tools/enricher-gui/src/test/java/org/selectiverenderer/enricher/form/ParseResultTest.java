package org.selectiverenderer.enricher.form;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.schema.ConsistencyDegree;

class ParseResultTest {
  private static final List<String> KNOWN = List.of("DeskSchema", "KitchenSchema", "OfficeSchema");

  @Test
  void degreesAreWordsOrNumbersWithPointOrComma() {
    assertThat(DegreeFormat.parse(" HIGH "))
        .isEqualTo(new ParseResult.Valid<>(Optional.of(ConsistencyDegree.HIGH)));
    assertThat(DegreeFormat.parse("0,5"))
        .isEqualTo(new ParseResult.Valid<>(Optional.of(new ConsistencyDegree(0.5))));
    assertThat(DegreeFormat.parse("")).isEqualTo(new ParseResult.Valid<>(Optional.empty()));
    assertThat(DegreeFormat.parse("none")).isEqualTo(new ParseResult.Valid<>(Optional.empty()));
    assertThat(DegreeFormat.format(Optional.of(ConsistencyDegree.LOW))).isEqualTo("low");
  }

  @ParameterizedTest
  @ValueSource(strings = {"1.5", "-0.1", "medium", "NaN", "1 0"})
  void whatIsNoDegreeSaysWhatWouldBe(String text) {
    assertThat(DegreeFormat.parse(text))
        .isInstanceOfSatisfying(
            ParseResult.Wrong.class,
            wrong -> assertThat(wrong.why()).contains("low, high or a number from 0 to 1"));
  }

  @Test
  void schemasAreSeparatedByCommasWithoutRepetition() {
    assertThat(SchemaListFormat.parse(" A ,B,, A, \"C, D\" "))
        .isEqualTo(new ParseResult.Valid<>(List.of("A", "B", "C, D")));
    assertThat(SchemaListFormat.format(List.of("A", "C, D"))).isEqualTo("A, \"C, D\"");
    assertThat(SchemaListFormat.parse("A, \"B")).isInstanceOf(ParseResult.Wrong.class);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "5\" desk",
        "desk \"big\"",
        "\"quoted\"",
        "\"",
        "\"\"",
        "a\", \"b",
        "O'Neill's",
        "a\\b",
        "<&>",
        "a, \"b\"",
      })
  void aNameIsReadAsItIsShown(String name) {
    assertThat(SchemaListFormat.parse(SchemaListFormat.format(List.of("Before", name, "Behind"))))
        .isEqualTo(new ParseResult.Valid<>(List.of("Before", name, "Behind")));
    SchemaListFormat.Completed completed = SchemaListFormat.complete("Before, ", 8, name);
    assertThat(SchemaListFormat.parse(completed.text()))
        .isEqualTo(new ParseResult.Valid<>(List.of("Before", name)));
  }

  @Test
  void aQuotationMarkWithinANameIsPartOfIt() {
    assertThat(SchemaListFormat.parse("5\" desk, the \"big\" one"))
        .isEqualTo(new ParseResult.Valid<>(List.of("5\" desk", "the \"big\" one")));
    assertThat(SchemaListFormat.parse("\"big\" one"))
        .isInstanceOfSatisfying(
            ParseResult.Wrong.class,
            wrong -> assertThat(wrong.why()).contains("followed by a comma"));
  }

  @Test
  void aCommaInQuotationMarksDoesNotEndTheNameAtTheCaret() {
    assertThat(SchemaListFormat.complete("A, \"C, De", 9, "C, Desk"))
        .isEqualTo(new SchemaListFormat.Completed("A, \"C, Desk\"", 12));
    assertThat(SchemaListFormat.proposals("\"C, De", 6, List.of("C, Desk", "Desk")))
        .containsExactly("C, Desk");
  }

  @Test
  void theNameAtTheCaretIsCompleted() {
    String text = "DeskSchema, of, X";
    int caret = "DeskSchema, of".length();
    assertThat(SchemaListFormat.proposals(text, caret, KNOWN)).containsExactly("OfficeSchema");
    assertThat(SchemaListFormat.complete(text, caret, "OfficeSchema"))
        .isEqualTo(new SchemaListFormat.Completed("DeskSchema, OfficeSchema, X", 24));
  }

  @Test
  void whatBeginsSoIsProposedBeforeWhatHasItWithinAndNothingTwice() {
    List<String> known = List.of("KitchenSchema", "OfficeKitchen", "Office");
    assertThat(SchemaListFormat.proposals("kit", 3, known))
        .containsExactly("KitchenSchema", "OfficeKitchen");
    assertThat(SchemaListFormat.proposals("Office, ", 8, known))
        .containsExactly("KitchenSchema", "OfficeKitchen");
  }
}
