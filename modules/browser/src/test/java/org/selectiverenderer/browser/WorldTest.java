package org.selectiverenderer.browser;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.browser.scene.Node;

class WorldTest {
  /** An area of 2 m round the origin and a Switch between one box and two. */
  private static final String AREA =
      """
      <ProximitySensor DEF='Area' size='2 2 2'/>
      <Switch DEF='Versions' whichChoice='0'>
      <Shape><Box/></Shape><Group><Shape><Box/></Shape><Shape><Box/></Shape></Group></Switch>
      """;

  @Test
  void whatAListenerSetsInAFrameIsShownInThatFrame() {
    try (WorldFixture fixture = new WorldFixture(AREA)) {
      Node area = fixture.node("Area");
      area.addListener(
          area.type().indexOf("enterTime"),
          (node, field, value, time) -> fixture.send("Versions", "whichChoice", 1));
      fixture.step(0);
      assertThat(fixture.world.instances().shownPolygons()).isEqualTo(12);
      fixture.step(1, 0, 0, 0);
      assertThat(fixture.world.instances().shownPolygons()).isEqualTo(24);
    }
  }

  @Test
  void thePolygonsOfAllLayersCount() {
    String box = "<Shape><Box/></Shape>";
    String layers =
        "<LayerSet activeLayer='1' order='1'><Layer>%s</Layer><Layer visible='false'>%s</Layer>"
            + "<Layer>%s</Layer></LayerSet>%s";
    try (WorldFixture fixture = new WorldFixture(layers.formatted(box, box, box, box))) {
      fixture.step(0);
      assertThat(fixture.world.instances().shownPolygons()).isEqualTo(12);
      assertThat(fixture.world.shownPolygons()).isEqualTo(36);
    }
  }

  @Test
  void postedWritesComeBeforeSensorsAndBothHaveTheTimeOfTheFrame() {
    try (WorldFixture fixture = new WorldFixture(AREA)) {
      fixture.watch("Versions", "whichChoice");
      fixture.watch("Area", "isActive");
      fixture.watch("Area", "enterTime");
      fixture.step(0);
      fixture.world.post(() -> fixture.send("Versions", "whichChoice", 1));
      fixture.step(0.5, 0, 0, 0);
      assertThat(fixture.log)
          .containsExactly(
              "0.50 Versions.whichChoice=1", "0.50 Area.isActive=true", "0.50 Area.enterTime=0.5");
    }
  }

  @Test
  void aSensorFeelsInTheSameFrameThatItsPlaceWasMoved() {
    try (WorldFixture fixture =
        new WorldFixture("<Transform DEF='T' translation='0 0 100'>" + AREA + "</Transform>")) {
      fixture.watch("Area", "isActive");
      fixture.step(0);
      fixture.world.post(() -> fixture.send("T", "translation", new float[] {0, 0, 10}));
      fixture.step(1);
      assertThat(fixture.log).containsExactly("1.00 Area.isActive=true");
    }
  }

  @Test
  void whatIsPostedDuringAStepWaitsForTheNext() {
    try (WorldFixture fixture = new WorldFixture(AREA)) {
      List<String> order = new ArrayList<>();
      fixture.world.post(
          () -> {
            order.add("first");
            fixture.world.post(() -> order.add("second"));
          });
      fixture.step(0);
      assertThat(order).containsExactly("first");
      fixture.step(1);
      assertThat(order).containsExactly("first", "second");
    }
  }

  @Test
  void aListenerThatThrowsDoesNotSilenceOthers() {
    try (WorldFixture fixture = new WorldFixture(AREA)) {
      Node area = fixture.node("Area");
      area.addListener(
          area.type().indexOf("isActive"),
          (node, field, value, time) -> {
            throw new IllegalStateException("no good");
          });
      fixture.watch("Area", "isActive");
      fixture.step(0, 0, 0, 0);
      fixture.step(1, 0, 0, 10);
      assertThat(fixture.log)
          .containsExactly("0.00 Area.isActive=true", "1.00 Area.isActive=false");
      assertThat(fixture.problems.list())
          .extracting(Problem::toString)
          .containsOnly("test.x3d:2:1: a listener of isActive failed and was skipped: no good");
    }
  }

  @Test
  void whileNotRunningOnlyPostedTasksAreDone() {
    try (WorldFixture fixture = new WorldFixture(AREA)) {
      fixture.step(0);
      fixture.watch("Area", "isActive");
      fixture.watch("Versions", "whichChoice");
      fixture.world.running(false);
      fixture.world.post(() -> fixture.send("Versions", "whichChoice", 1));
      fixture.step(1, 0, 0, 0);
      assertThat(fixture.log).containsExactly("1.00 Versions.whichChoice=1");
      assertThat(fixture.world.instances().shownPolygons()).isEqualTo(24);
      assertThat(fixture.world.viewer().position()).isEqualTo(new Vector3d(0, 0, 10));
      fixture.world.running(true);
      fixture.step(2, 0, 0, 0);
      assertThat(fixture.log).hasSize(2).contains("2.00 Area.isActive=true");
    }
  }

  @Test
  void theSameTimesAndMotionGiveTheSameEvents() {
    String nodes =
        AREA
            + """
            <TimeSensor DEF='Clock' cycleInterval='0.7' loop='true'/>
            <PositionInterpolator DEF='Way' key='0 0.5 1' keyValue='0 0 0 3 0 0 0 0 0'/>
            <Transform DEF='T'><ProximitySensor DEF='Moving' size='1 1 1'/></Transform>
            <ROUTE fromNode='Clock' fromField='fraction_changed' toNode='Way' toField='set_fraction'/>
            <ROUTE fromNode='Way' fromField='value_changed' toNode='T' toField='translation'/>
            """;
    List<List<String>> runs = new ArrayList<>();
    for (int run = 0; run < 3; run++) {
      try (WorldFixture fixture = new WorldFixture(nodes)) {
        fixture.watch("Way", "value_changed");
        fixture.watch("Area", "isActive");
        fixture.watch("Moving", "isActive");
        fixture.watch("Moving", "position_changed");
        for (int i = 0; i < 200; i++) {
          fixture.step(i / 30.0, 2 * Math.sin(i * 0.1), 0, 0);
        }
        runs.add(List.copyOf(fixture.log));
      }
    }
    assertThat(runs.get(0))
        .hasSizeGreaterThan(200)
        .anyMatch(line -> line.contains("Moving.isActive"));
    assertThat(runs.get(1)).isEqualTo(runs.get(0));
    assertThat(runs.get(2)).isEqualTo(runs.get(0));
  }

  @Test
  void sensorsThatComeAndGoWithTheSceneAreAskedAndNoLonger() {
    try (WorldFixture fixture = new WorldFixture("<Group DEF='G'>" + AREA + "</Group>")) {
      fixture.watch("Area", "position_changed");
      List<Node> all = fixture.node("G").nodes("children");
      fixture.step(0, 0, 0, 0);
      fixture.send("G", "children", List.of());
      fixture.step(1, 0.1, 0, 0);
      fixture.send("G", "children", all);
      fixture.step(2, 0.2, 0, 0);
      assertThat(fixture.log)
          .containsExactly(
              "0.00 Area.position_changed=[0.0, 0.0, 0.0]",
              "2.00 Area.position_changed=[0.2, 0.0, 0.0]");
    }
  }

  @Test
  void theClockOfAPrototypeRunsThoughItStandsNowhere() {
    String prototype =
        """
        <ProtoDeclare name='Blinking'><ProtoBody>
        <Transform DEF='T'/>
        <TimeSensor DEF='Clock' cycleInterval='1' loop='true'/>
        <PositionInterpolator DEF='Way' key='0 1' keyValue='0 0 0 1 0 0'/>
        <ROUTE fromNode='Clock' fromField='fraction_changed' toNode='Way' toField='set_fraction'/>
        <ROUTE fromNode='Way' fromField='value_changed' toNode='T' toField='translation'/>
        </ProtoBody></ProtoDeclare>
        <ProtoInstance name='Blinking' DEF='B'/>
        """;
    try (WorldFixture fixture = new WorldFixture(prototype)) {
      fixture.step(10);
      fixture.step(10.25);
      assertThat(fixture.problems.list()).isEmpty();
      assertThat(fixture.node("B").floats("translation")[0]).isEqualTo(0.25f, within(1e-6f));
    }
  }

  @Test
  void anotherSceneIsShownFromItsOwnViewpointAndListenersHearOfIt() {
    try (WorldFixture fixture = new WorldFixture(AREA)) {
      List<String> heard = new ArrayList<>();
      fixture.world.onReplace(world -> heard.add("replaced"));
      fixture.step(0, 5, 5, 5);
      fixture.world.replace(
          fixture.load(
              Path.of("no-such-folder"),
              "<Viewpoint position='1 2 3'/><ProximitySensor DEF='Other' center='1 2 3' size='1 1 1'/>"));
      assertThat(heard).containsExactly("replaced");
      fixture.watch("Other", "isActive");
      fixture.step(1);
      assertThat(fixture.world.viewer().position()).isEqualTo(new Vector3d(1, 2, 3));
      assertThat(fixture.world.instances().shownPolygons()).isZero();
      assertThat(fixture.log).containsExactly("1.00 Other.isActive=true");
    }
  }

  @Test
  void stepListenersAreCalledAfterEverythingElse() {
    try (WorldFixture fixture = new WorldFixture(AREA)) {
      fixture.watch("Area", "isActive");
      fixture.world.onStep(() -> fixture.log.add("end of step"));
      fixture.step(0, 0, 0, 0);
      assertThat(fixture.log).containsExactly("0.00 Area.isActive=true", "end of step");
    }
  }
}
