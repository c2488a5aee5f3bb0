package org.selectiverenderer.schema;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class SchemaNamesTest {
  @Test
  void aSlipOfOneOrTwoLettersOrOfCaseIsFound() {
    List<String> others = List.of("OfficeSchema", "DeskSchema");
    assertThat(SchemaNames.probablyMeant("DeskShema", others)).contains("DeskSchema");
    assertThat(SchemaNames.probablyMeant("deskSchmea", others)).contains("DeskSchema");
    assertThat(SchemaNames.probablyMeant("a", List.of("A"))).contains("A");
  }

  @Test
  void namesThatDifferOnPurposeAreNot() {
    assertThat(SchemaNames.probablyMeant("A", List.of("B"))).isEmpty();
    assertThat(SchemaNames.probablyMeant("Room1", List.of("Room2", "Room12"))).isEmpty();
    assertThat(SchemaNames.probablyMeant("KitchenSchema", List.of("DeskSchema"))).isEmpty();
  }
}
