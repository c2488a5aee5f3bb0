package org.selectiverenderer.browser;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

class PointingDeviceHandlerTest {
  private static final PointingDeviceState AHEAD = ahead(false);
  private static final PointingDeviceState PRESSED = ahead(true);

  /** A button of 2 m at the origin; the viewer stands at (0, 0, 10) and looks at it. */
  private static final String BUTTON =
      "<Group><TouchSensor DEF='Touch'/><Transform DEF='T'><Shape><Box/></Shape></Transform></Group>";

  private static PointingDeviceState ahead(boolean pressed) {
    return new PointingDeviceState(Optional.of(new Vector3d(0, 0, -1)), pressed);
  }

  private static WorldFixture button() {
    WorldFixture fixture = new WorldFixture(BUTTON);
    fixture.watch("Touch", "isOver");
    fixture.watch("Touch", "isActive");
    fixture.watch("Touch", "touchTime");
    fixture.step(0);
    return fixture;
  }

  @Test
  void aClickBetweenTwoFramesIsNotLost() {
    try (WorldFixture fixture = button()) {
      fixture.world.point(AHEAD);
      fixture.world.point(PRESSED);
      fixture.world.point(AHEAD);
      fixture.step(1);
      assertThat(fixture.log)
          .containsExactly(
              "1.00 Touch.isOver=true",
              "1.00 Touch.isActive=true",
              "1.00 Touch.isActive=false",
              "1.00 Touch.touchTime=1.0");
    }
  }

  @Test
  void aButtonPressedInOneFrameAndReleasedInAnotherClicksThen() {
    try (WorldFixture fixture = button()) {
      fixture.world.point(AHEAD);
      fixture.step(1);
      fixture.world.point(PRESSED);
      fixture.step(2);
      fixture.step(3);
      fixture.world.point(AHEAD);
      fixture.step(4);
      fixture.world.point(PointingDeviceState.AWAY);
      fixture.step(5);
      assertThat(fixture.log)
          .containsExactly(
              "1.00 Touch.isOver=true",
              "2.00 Touch.isActive=true",
              "4.00 Touch.isActive=false",
              "4.00 Touch.touchTime=4.0",
              "5.00 Touch.isOver=false");
    }
  }

  @Test
  void theSceneMayMoveUnderAPointerThatRests() {
    try (WorldFixture fixture = button()) {
      fixture.world.point(AHEAD);
      fixture.step(1);
      fixture.send("T", "translation", new float[] {5, 0, 0});
      fixture.step(2);
      fixture.step(3, 5, 0, 10);
      assertThat(fixture.log)
          .containsExactly(
              "1.00 Touch.isOver=true", "2.00 Touch.isOver=false", "3.00 Touch.isOver=true");
    }
  }

  @Test
  void theDirectionIsTheViewersOwn() {
    try (WorldFixture fixture =
        new WorldFixture("<Viewpoint position='10 0 0' orientation='0 1 0 1.5707963'/>" + BUTTON)) {
      fixture.watch("Touch", "hitPoint_changed");
      fixture.world.point(AHEAD);
      fixture.step(1);
      assertThat(fixture.log).hasSize(1);
      assertThat(fixture.log.get(0)).startsWith("1.00 Touch.hitPoint_changed=[1.0, ");
    }
  }

  @Test
  void whatTouchingCausesIsShownInTheSameFrame() {
    try (WorldFixture fixture =
        new WorldFixture(
            """
            <Group><TouchSensor DEF='Touch'/><Switch DEF='S' whichChoice='0'><Shape><Box/></Shape>
            <Group><Shape><Box/></Shape><Shape><Box/></Shape></Group></Switch></Group>
            <BooleanFilter DEF='F'/><IntegerTrigger DEF='One' integerKey='1'/>
            <ROUTE fromNode='Touch' fromField='isActive' toNode='F' toField='set_boolean'/>
            <ROUTE fromNode='F' fromField='inputTrue' toNode='One' toField='set_boolean'/>
            <ROUTE fromNode='One' fromField='triggerValue' toNode='S' toField='whichChoice'/>
            """)) {
      fixture.step(0);
      fixture.world.point(PRESSED);
      fixture.step(1);
      assertThat(fixture.world.instances().shownPolygons()).isEqualTo(24);
    }
  }

  @Test
  void aSensorThatComesLaterIsTouchedToo() {
    try (WorldFixture fixture = new WorldFixture("<Group DEF='G'>" + BUTTON + "</Group>")) {
      fixture.watch("Touch", "isOver");
      List<?> children = fixture.node("G").nodes("children");
      fixture.send("G", "children", List.of());
      fixture.world.point(AHEAD);
      fixture.step(0);
      fixture.send("G", "children", children);
      fixture.step(1);
      assertThat(fixture.log).containsExactly("1.00 Touch.isOver=true");
    }
  }
}
