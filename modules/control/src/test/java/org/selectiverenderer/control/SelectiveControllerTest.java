package org.selectiverenderer.control;

import static org.assertj.core.api.Assertions.assertThat;
import static org.selectiverenderer.control.ControlledSceneFixture.area;
import static org.selectiverenderer.control.ControlledSceneFixture.object;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.control.ControlEvent.Enter;
import org.selectiverenderer.control.ControlEvent.Exit;
import org.selectiverenderer.control.ControlEvent.Start;
import org.selectiverenderer.control.ControlEvent.SwitchChange;
import org.selectiverenderer.schema.Condition;

class SelectiveControllerTest {
  private static final String DESK = area("DeskProx", 0, "DeskSchema", "OfficeSchema");
  private static final String BOOKCASE = area("BookcaseProx", 1, "BookcaseSchema", "OfficeSchema");
  private static final String TRASH_CAN = object("DEF='TrashCan'", "DeskSchema", "OfficeSchema");
  private static final String PRINTER = object("DEF='Printer'", "BookcaseSchema", "OfficeSchema");
  private static final double OUTSIDE = -5;
  private static final double AT_DESK = -0.5;
  private static final double AT_BOTH = 0.5;
  private static final double AT_BOOKCASE = 1.5;

  @Test
  void enteringAndLeavingTheDeskSwitchesInTheSameFrame() {
    try (var scene = ControlledSceneFixture.under(Condition.SELECTIVE, DESK + TRASH_CAN)) {
      assertThat(scene.news()).containsExactly(new Start(0, Map.of("TrashCan", 1)));
      scene.walkTo(OUTSIDE);
      assertThat(scene.news()).isEmpty();

      scene.walkTo(AT_DESK);
      assertThat(scene.choice("TrashCan")).isZero();
      assertThat(scene.news())
          .containsExactly(
              new Enter(2, "DeskProx", List.of("DeskSchema")),
              new SwitchChange(2, "TrashCan", 1, 0, "DeskSchema"));
      assertThat(scene.controller.enteredAreas()).containsExactly("DeskProx");
      assertThat(scene.controller.activeSchemas()).containsExactly("DeskSchema");

      scene.walkTo(OUTSIDE);
      assertThat(scene.choice("TrashCan")).isEqualTo(1);
      assertThat(scene.news())
          .containsExactly(
              new Exit(3, "DeskProx", List.of("OfficeSchema")),
              new SwitchChange(3, "TrashCan", 0, 1, "OfficeSchema"));
      assertThat(scene.controller.activeSchemas()).containsExactly("OfficeSchema");
    }
  }

  @Test
  void leavingTheDeskInsideTheBookcaseKeepsBookcaseObjectsHigh() {
    try (var scene =
        ControlledSceneFixture.under(Condition.SELECTIVE, DESK + BOOKCASE + TRASH_CAN + PRINTER)) {
      scene.walkTo(OUTSIDE);
      scene.walkTo(AT_DESK);
      scene.walkTo(AT_BOTH);
      assertThat(scene.controller.choices()).isEqualTo(Map.of("TrashCan", 0, "Printer", 0));

      scene.walkTo(AT_BOOKCASE);
      assertThat(scene.choice("TrashCan")).isEqualTo(1);
      assertThat(scene.choice("Printer")).isZero();
    }
  }

  @Test
  void onlyEnrichedNodesCount() {
    String others =
        "<Switch DEF='Menu' whichChoice='0'><Group/></Switch><ProximitySensor size='9 9 9'/>";
    try (var scene = ControlledSceneFixture.under(Condition.HIGH, others + DESK + TRASH_CAN)) {
      assertThat(scene.news()).containsExactly(new Start(0, Map.of("TrashCan", 0)));
      scene.walkTo(AT_DESK);

      assertThat(scene.news()).containsExactly(new Enter(1, "DeskProx", List.of("DeskSchema")));
      assertThat(scene.choice("Menu")).isZero();
    }
  }

  @Test
  void fixedConditionsSetTheChoicesBeforeTheFirstFrameAndNeverAgain() {
    for (Condition condition : List.of(Condition.HIGH, Condition.HIGH_LOW)) {
      try (var scene = ControlledSceneFixture.under(condition, DESK + TRASH_CAN)) {
        assertThat(scene.choice("TrashCan")).isZero();
        scene.walkTo(AT_DESK);
        scene.walkTo(OUTSIDE);

        assertThat(scene.choice("TrashCan")).isZero();
        assertThat(scene.news()).noneMatch(SwitchChange.class::isInstance);
      }
    }
  }

  @Test
  void whichChoiceIsWrittenOnlyWhenItDiffers() {
    try (var scene =
        ControlledSceneFixture.under(Condition.SELECTIVE, DESK + BOOKCASE + TRASH_CAN)) {
      List<Double> written = new ArrayList<>();
      scene
          .node("TrashCan")
          .getField("whichChoice")
          .addX3DEventListener(event -> written.add(event.getTime()));
      scene.walkTo(OUTSIDE);
      scene.walkTo(AT_BOOKCASE);
      scene.walkTo(OUTSIDE);
      assertThat(written).isEmpty();
      scene.walkTo(AT_DESK);

      assertThat(written).containsExactly(4.0);
    }
  }

  @Test
  void nodesWithoutANameGetOneByTheirPlaceInTheScene() {
    String anonymous = object("", "DeskSchema", "OfficeSchema");
    try (var scene =
        ControlledSceneFixture.under(
            Condition.SELECTIVE, TRASH_CAN + "<Group>" + anonymous + "</Group>" + anonymous)) {
      assertThat(scene.controller.choices().keySet())
          .containsExactly("TrashCan", "Switch#2", "Switch#3");
    }
  }

  @Test
  void aSwitchThatStandsInTwoPlacesIsSwitchedOnce() {
    try (var scene =
        ControlledSceneFixture.under(
            Condition.SELECTIVE,
            DESK + TRASH_CAN + "<Transform><Switch USE='TrashCan'/></Transform>")) {
      scene.walkTo(OUTSIDE);
      scene.news();
      scene.walkTo(AT_DESK);

      assertThat(scene.news()).filteredOn(SwitchChange.class::isInstance).hasSize(1);
    }
  }

  @Test
  void aViewerWhoIsInAnAreaAlreadyCountsAsEntered() {
    try (var scene = new ControlledSceneFixture(DESK + TRASH_CAN)) {
      scene.walkTo(OUTSIDE);
      scene.walkTo(AT_DESK);

      scene.control(Condition.SELECTIVE);

      assertThat(scene.news())
          .containsExactly(
              new Start(0, Map.of("TrashCan", 1)),
              new Enter(2, "DeskProx", List.of("DeskSchema")),
              new SwitchChange(2, "TrashCan", 1, 0, "DeskSchema"));
    }
  }

  @Test
  void problemsNameTheNodeAndSayWhatIsWrong() {
    String wrong =
        "<Switch DEF='Vase' whichChoice='0'><Group/>"
            + "<MetadataSet containerField='metadata'><MetadataSet>"
            + "<MetadataString name='degreeOfConsistency' value='\"much\"'/>"
            + "<MetadataString name='schemaBelonginess' value='\"A\"'/></MetadataSet></MetadataSet>"
            + "</Switch>";
    try (var scene = ControlledSceneFixture.under(Condition.SELECTIVE, wrong)) {
      assertThat(scene.controller.problems())
          .singleElement()
          .hasToString(
              "Vase: degreeOfConsistency must be low, high or a number from 0 to 1, "
                  + "not \"much\"; it is ignored");
    }
  }

  @Test
  void afterClosingNothingIsSwitchedAnyMore() {
    try (var scene = ControlledSceneFixture.under(Condition.SELECTIVE, DESK + TRASH_CAN)) {
      scene.walkTo(OUTSIDE);
      scene.controller.close();
      scene.news();
      scene.walkTo(AT_DESK);

      assertThat(scene.choice("TrashCan")).isEqualTo(1);
      assertThat(scene.news()).isEmpty();
    }
  }
}
