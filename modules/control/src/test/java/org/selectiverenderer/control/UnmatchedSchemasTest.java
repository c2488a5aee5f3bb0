package org.selectiverenderer.control;

import static org.assertj.core.api.Assertions.assertThat;
import static org.selectiverenderer.control.ControlledSceneFixture.area;
import static org.selectiverenderer.control.ControlledSceneFixture.object;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.schema.Condition;

class UnmatchedSchemasTest {
  private static List<String> problems(String nodes) {
    try (var scene = ControlledSceneFixture.under(Condition.SELECTIVE, nodes)) {
      return scene.problems.stream().map(p -> p.severity() + " " + p).toList();
    }
  }

  @Test
  void schemasThatMeetArePassedOverInSilence() {
    assertThat(problems(area("P", 0, "Desk", "Office") + object("DEF='S'", "Desk", "Office")))
        .isEmpty();
  }

  @Test
  void aSlipOfALetterOrOfCaseIsAWarningWithTheNameThatWasMeant() {
    String desk = area("P", 0, "DeskSchema", "OfficeSchema");
    assertThat(
            problems(
                desk
                    + object("DEF='S'", "DeskShema", "officeSchema")
                    + object("DEF='T'", "DeskShema", "OfficeSchema")
                    + object("DEF='U'", "DeskSchema", "OfficeSchema")))
        .containsExactly(
            "WARNING S: no area of the scene activates the schema DeskShema; is DeskSchema meant?"
                + " It has no effect",
            "WARNING S: no area of the scene activates the schema officeSchema; is OfficeSchema"
                + " meant? It has no effect");
  }

  @Test
  void aSchemaWithoutASensorIsWorthALineOnly() {
    assertThat(
            problems(
                area("P", 0, "DeskSchema", "OfficeSchema")
                    + object("DEF='S'", "KitchenSchema", "DeskSchema")
                    + object("DEF='T'", "DeskSchema", "KitchenSchema")))
        .containsExactly(
            "INFO S: no area of the scene activates the schema KitchenSchema; it has no effect");
  }

  @Test
  void aSchemaThatOnlySaysWhatIsShownFromTheStartNeedsNoArea() {
    assertThat(
            problems(
                area("P", 0, "DeskSchema", "OfficeSchema")
                    + object("DEF='S'", "DeskSchema", "KitchenSchema")))
        .isEmpty();
  }

  @Test
  void aSchemaOfAnAreaThatNoSwitchKnowsIsMentionedButNotAnExitSchema() {
    assertThat(
            problems(
                area("P", 0, "Room1", "Hall")
                    + area("Q", 5, "Room2", "Hall")
                    + object("DEF='S'", "Room1", "Room1")))
        .containsExactly(
            "INFO Q: no Switch of the scene belongs to the schema Room2; it has no effect");
  }
}
