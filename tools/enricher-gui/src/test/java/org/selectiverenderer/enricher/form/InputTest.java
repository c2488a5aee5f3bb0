package org.selectiverenderer.enricher.form;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.schema.Degree;

class InputTest {
  private static final List<String> KNOWN = List.of("DeskSchema", "KitchenSchema", "OfficeSchema");

  @Test
  void degreesAreWordsOrNumbersWithPointOrComma() {
    assertThat(DegreeInput.parse(" HIGH ")).isEqualTo(new Input.Valid<>(Optional.of(Degree.HIGH)));
    assertThat(DegreeInput.parse("0,5")).isEqualTo(new Input.Valid<>(Optional.of(new Degree(0.5))));
    assertThat(DegreeInput.parse("")).isEqualTo(new Input.Valid<>(Optional.empty()));
    assertThat(DegreeInput.parse("none")).isEqualTo(new Input.Valid<>(Optional.empty()));
    assertThat(DegreeInput.format(Optional.of(Degree.LOW))).isEqualTo("low");
  }

  @ParameterizedTest
  @ValueSource(strings = {"1.5", "-0.1", "medium", "NaN", "1 0"})
  void whatIsNoDegreeSaysWhatWouldBe(String text) {
    assertThat(DegreeInput.parse(text))
        .isInstanceOfSatisfying(
            Input.Wrong.class,
            wrong -> assertThat(wrong.why()).contains("low, high or a number from 0 to 1"));
  }

  @Test
  void schemasAreSeparatedByCommasWithoutRepetition() {
    assertThat(SchemaList.parse(" A ,B,, A, \"C, D\" "))
        .isEqualTo(new Input.Valid<>(List.of("A", "B", "C, D")));
    assertThat(SchemaList.format(List.of("A", "C, D"))).isEqualTo("A, \"C, D\"");
    assertThat(SchemaList.parse("A, \"B")).isInstanceOf(Input.Wrong.class);
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
    assertThat(SchemaList.parse(SchemaList.format(List.of("Before", name, "Behind"))))
        .isEqualTo(new Input.Valid<>(List.of("Before", name, "Behind")));
    SchemaList.Completed completed = SchemaList.complete("Before, ", 8, name);
    assertThat(SchemaList.parse(completed.text()))
        .isEqualTo(new Input.Valid<>(List.of("Before", name)));
  }

  @Test
  void aQuotationMarkWithinANameIsPartOfIt() {
    assertThat(SchemaList.parse("5\" desk, the \"big\" one"))
        .isEqualTo(new Input.Valid<>(List.of("5\" desk", "the \"big\" one")));
    assertThat(SchemaList.parse("\"big\" one"))
        .isInstanceOfSatisfying(
            Input.Wrong.class, wrong -> assertThat(wrong.why()).contains("followed by a comma"));
  }

  @Test
  void aCommaInQuotationMarksDoesNotEndTheNameAtTheCaret() {
    assertThat(SchemaList.complete("A, \"C, De", 9, "C, Desk"))
        .isEqualTo(new SchemaList.Completed("A, \"C, Desk\"", 12));
    assertThat(SchemaList.proposals("\"C, De", 6, List.of("C, Desk", "Desk")))
        .containsExactly("C, Desk");
  }

  @Test
  void theNameAtTheCaretIsCompleted() {
    String text = "DeskSchema, of, X";
    int caret = "DeskSchema, of".length();
    assertThat(SchemaList.proposals(text, caret, KNOWN)).containsExactly("OfficeSchema");
    assertThat(SchemaList.complete(text, caret, "OfficeSchema"))
        .isEqualTo(new SchemaList.Completed("DeskSchema, OfficeSchema, X", 24));
  }

  @Test
  void whatBeginsSoIsProposedBeforeWhatHasItWithinAndNothingTwice() {
    List<String> known = List.of("KitchenSchema", "OfficeKitchen", "Office");
    assertThat(SchemaList.proposals("kit", 3, known))
        .containsExactly("KitchenSchema", "OfficeKitchen");
    assertThat(SchemaList.proposals("Office, ", 8, known))
        .containsExactly("KitchenSchema", "OfficeKitchen");
  }
}
