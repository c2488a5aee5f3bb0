package org.selectiverenderer.enricher.form;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class SchemaCompletionTest {
  private static final List<String> KNOWN = List.of("Kitchen", "Lounge", "Office");

  @Test
  void aLineNamesSchemasOnceWithoutSpacesAround() {
    assertThat(SchemaCompletion.parse(" Office ,, Dining room,Office"))
        .containsExactly("Office", "Dining room");
  }

  @Test
  void theWordAtTheCaretIsCompletedInAnyCaseByThoseNotNamedYet() {
    assertThat(SchemaCompletion.proposals("Office, k", 9, KNOWN)).containsExactly("Kitchen");
    assertThat(SchemaCompletion.proposals("Office, ", 8, KNOWN))
        .containsExactly("Kitchen", "Lounge");
  }

  @Test
  void acceptingReplacesTheWordAtTheCaretOnly() {
    assertThat(SchemaCompletion.accept("Office, k, Bath", 9, "Kitchen"))
        .isEqualTo("Office, Kitchen, Bath");
    assertThat(SchemaCompletion.accept("", 0, "Kitchen")).isEqualTo("Kitchen");
  }
}
