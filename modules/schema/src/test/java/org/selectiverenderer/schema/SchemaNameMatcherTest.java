package org.selectiverenderer.schema;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class SchemaNameMatcherTest {
  @Test
  void aSlipOfOneOrTwoLettersOrOfCaseIsFound() {
    List<String> others = List.of("OfficeSchema", "DeskSchema");
    assertThat(SchemaNameMatcher.probablyMeant("DeskShema", others)).contains("DeskSchema");
    assertThat(SchemaNameMatcher.probablyMeant("deskSchmea", others)).contains("DeskSchema");
    assertThat(SchemaNameMatcher.probablyMeant("a", List.of("A"))).contains("A");
  }

  @Test
  void namesThatDifferOnPurposeAreNot() {
    assertThat(SchemaNameMatcher.probablyMeant("A", List.of("B"))).isEmpty();
    assertThat(SchemaNameMatcher.probablyMeant("Room1", List.of("Room2", "Room12"))).isEmpty();
    assertThat(SchemaNameMatcher.probablyMeant("KitchenSchema", List.of("DeskSchema"))).isEmpty();
  }
}
