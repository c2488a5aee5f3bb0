package org.selectiverenderer.walkthrough.budget;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.joml.Vector3d;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.viewer.Viewer;
import org.selectiverenderer.control.ControlEvent;
import org.selectiverenderer.control.SelectiveController.Settings;
import org.selectiverenderer.control.budget.RenderingBudget;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.walkthrough.Walkthrough;
import org.selectiverenderer.walkthrough.timeline.TimelineEvent;
import org.selectiverenderer.walkthrough.timeline.TimelineJson;
import org.selectiverenderer.walkthrough.timeline.TimelineText;

/** The objects that matter most in the view get the triangles that there are. */
class VersionBudgetTest {
  private static final String FLOOR =
      "<Transform translation='0 -1 0'><Shape><Box size='40 0.1 40'/></Shape></Transform>";

  private final List<Problem> problems = new ArrayList<>();
  private final List<TimelineEvent> events = new ArrayList<>();
  private @TempDir Path folder;
  private Walkthrough walk;
  private double time;

  @AfterEach
  void close() {
    walk.close();
  }

  /** An object of 1,200 and of 12 triangles, at (x, 0, z); the first is the inconsistent one. */
  private static String object(String name, double x, double z, String high, String low) {
    return "<Transform DEF='%sPlace' translation='%s 0 %s'>".formatted(name, x, z)
        + "<Switch DEF='%s' whichChoice='1'>".formatted(name)
        + "<Group>"
        + "<Shape><Box size='.5 .5 .5'/></Shape>".repeat(100)
        + "</Group><Shape><Box size='.5 .5 .5'/></Shape>"
        + "<MetadataSet containerField='metadata'>"
        + version("low", high)
        + version("high", low)
        + "</MetadataSet></Switch></Transform>";
  }

  private static String version(String degree, String schema) {
    return "<MetadataSet><MetadataString name='consistencyType' value='\"consistent\"'/>"
        + "<MetadataString name='degreeOfConsistency' value='\"%s\"'/>".formatted(degree)
        + "<MetadataString name='schemaBelonginess' value='\"%s\"'/>".formatted(schema)
        + "</MetadataSet>";
  }

  private static String area(String name, double x, String enter, String exit) {
    return "<Transform translation='%s 0 0'><ProximitySensor DEF='%s' size='2 2 2'>"
            .formatted(x, name)
        + "<MetadataSet containerField='metadata'>"
        + "<MetadataString name='enterTimeSchema' value='\"%s\"'/>".formatted(enter)
        + "<MetadataString name='exitTimeSchema' value='\"%s\"'/>".formatted(exit)
        + "</MetadataSet></ProximitySensor></Transform>";
  }

  private void open(String budget, String... nodes) throws IOException {
    open(Settings.SELECTIVE.within(RenderingBudget.of(budget).orElseThrow()), nodes);
  }

  private void open(Settings settings, String... nodes) throws IOException {
    Path scene =
        Files.writeString(
            folder.resolve("scene.x3d"),
            "<X3D version='4.0' profile='Full'><Scene>"
                + String.join("", nodes)
                + "</Scene></X3D>");
    walk = Walkthrough.open(scene, settings, problems::add, events::add, line -> {});
  }

  /** One frame, with the viewer at (x, 0, z), turned left by a yaw in degrees. */
  private void look(double x, double z, double yaw) {
    time += 0.1;
    walk.step(
        time,
        (viewer, now, dt) -> {
          viewer.moveTo(new Vector3d(x, 0, z));
          viewer.turnTo(Viewer.orientation(Math.toRadians(yaw), 0, 0));
        });
  }

  private List<ControlEvent.SwitchChange> changes() {
    List<ControlEvent.SwitchChange> changes =
        events.stream()
            .filter(TimelineEvent.ControllerEvent.class::isInstance)
            .map(event -> ((TimelineEvent.ControllerEvent) event).event())
            .filter(ControlEvent.SwitchChange.class::isInstance)
            .map(ControlEvent.SwitchChange.class::cast)
            .toList();
    events.clear();
    return changes;
  }

  private Map<String, Integer> changed() {
    Map<String, Integer> to = new TreeMap<>();
    changes().forEach(change -> to.put(change.switchName(), change.to()));
    return to;
  }

  private static final String LEFT = object("Left", -3, -5, "kitchen", "hall");
  private static final String RIGHT = object("Right", 3, -5, "kitchen", "hall");

  @Test
  void whatIsNearerGetsTheTriangles() throws IOException {
    open("triangles:1400", FLOOR, LEFT, RIGHT);
    look(-2, 0, 0);
    assertThat(changed()).isEqualTo(Map.of("Left", 0));
    assertThat(walk.polygons()).isEqualTo(12 + 1200 + 12);
    look(1, 0, 0);
    assertThat(changed()).as("nearly as near is not enough to change").isEmpty();
    look(4, 0, 0);
    assertThat(changed()).isEqualTo(Map.of("Left", 1, "Right", 0));
    assertThat(walk.polygons()).isEqualTo(12 + 1200 + 12);
  }

  /** Lets a Group of a running scene have other children. */
  private void replace(String group, String children) {
    Node node = walk.world().scene().find(group).orElseThrow();
    Node other = walk.world().scene().find(children).orElseThrow();
    List<Node> now = new ArrayList<>(other.nodes("children"));
    walk.world().cascade().send(node, node.type().indexOf("children"), now);
  }

  @Test
  void aChangeOfStructureKeepsTheChoices() throws IOException {
    String spare = "<Switch whichChoice='-1'><Group DEF='Spare'><Shape/></Group></Switch>";
    open("triangles:1400", FLOOR, LEFT, RIGHT, "<Group DEF='Late'/>", spare);
    look(-2, 0, 0);
    assertThat(changed()).isEqualTo(Map.of("Left", 0));
    look(1, 0, 0);
    assertThat(changed()).as("nearly as near is not enough to change").isEmpty();
    replace("Late", "Spare");
    look(1, 0, 0);
    look(1, 0, 0);
    assertThat(changed()).as("what came is none of the objects").isEmpty();
  }

  @Test
  void onlyWhatHasChangedIsMeasuredAnew() throws IOException {
    String box = "<Shape><Box size='.5 .5 .5'/></Shape>";
    String spare = "<Switch whichChoice='-1'><Group DEF='Spare'>" + box + "</Group></Switch>";
    String left = LEFT.replaceFirst(box, "<Group DEF='Inner'/>" + box);
    open("triangles:1400", FLOOR, left, RIGHT, "<Group DEF='Late'/>", spare);
    look(-2, 0, 0);
    VersionBudget budget = walk.budget().orElseThrow();
    assertThat(budget.measured()).isEqualTo(2);
    replace("Late", "Spare");
    look(-2, 0, 0);
    assertThat(budget.measured()).as("something else came").isZero();
    replace("Inner", "Spare");
    look(-2, 0, 0);
    assertThat(budget.measured()).as("one of the versions has another shape").isEqualTo(1);
    assertThat(changed()).isEqualTo(Map.of("Left", 0));
    look(4, 0, 0);
    assertThat(changed()).isEqualTo(Map.of("Left", 1, "Right", 0));
  }

  @Test
  void whatIsInViewGetsTheTriangles() throws IOException {
    open("triangles:1400", FLOOR, LEFT, object("Behind", 0, 3, "kitchen", "hall"));
    look(0, 0, 0);
    assertThat(changed()).isEqualTo(Map.of("Left", 0));
    look(0, 0, 180);
    assertThat(changed()).isEqualTo(Map.of("Left", 1, "Behind", 0));
  }

  @Test
  void whatIsUnexpectedInTheAreaGetsTheTriangles() throws IOException {
    open(
        "triangles:1400",
        FLOOR,
        area("Kitchen", 0, "kitchen", "hall"),
        LEFT,
        object("Right", 3, -5, "bath", "kitchen"));
    look(0.5, 5, 0);
    assertThat(changed()).as("the nearer one").isEqualTo(Map.of("Right", 0));
    look(0.5, 0, 0);
    assertThat(changed())
        .as("in the kitchen the left one is inconsistent, the right one is consistent")
        .isEqualTo(Map.of("Left", 0, "Right", 1));
  }

  @Test
  void whatTheEyesLookAtGetsTheTriangles() throws IOException {
    open("triangles:1400", FLOOR, LEFT, RIGHT);
    look(-0.5, 0, 0);
    assertThat(changed()).isEqualTo(Map.of("Left", 0));
    walk.budget().orElseThrow().gaze(() -> Optional.of(new Vector3d(3.5, 0, -5).normalize()));
    look(-0.5, 0, 0);
    assertThat(changed()).isEqualTo(Map.of("Left", 1, "Right", 0));
  }

  @Test
  void allGetTheirBestIfThereIsEnoughAndTheirLeastIfThereIsTooLittle() throws IOException {
    open("triangles:2412", FLOOR, LEFT, RIGHT);
    look(0, 0, 0);
    assertThat(changed()).isEqualTo(Map.of("Left", 0, "Right", 0));
    assertThat(problems).noneMatch(problem -> problem.message().contains("budget"));
    walk.close();

    open("triangles:30", FLOOR, LEFT, RIGHT);
    look(0, 0, 0);
    look(1, 0, 0);
    assertThat(walk.polygons()).isEqualTo(36);
    assertThat(problems)
        .filteredOn(problem -> problem.message().contains("budget"))
        .singleElement()
        .satisfies(
            problem -> {
              assertThat(problem.severity()).isEqualTo(Problem.Severity.INFO);
              assertThat(problem.message())
                  .startsWith("the budget of 30 triangles is less than the 36 of the scene");
            });
  }

  @Test
  void objectsInOtherLayersAreLeftAsTheyAreWhichIsTold() throws IOException {
    String layer = "<LayerSet activeLayer='0' order='0 1'><Layer>" + RIGHT + "</Layer></LayerSet>";
    open("triangles:5000", FLOOR, LEFT, layer);
    look(0, 0, 0);
    look(1, 0, 0);
    assertThat(changed()).isEqualTo(Map.of("Left", 0));
    assertThat(problems)
        .filteredOn(problem -> problem.message().contains("layer"))
        .singleElement()
        .satisfies(
            problem ->
                assertThat(problem.message())
                    .contains("\"Right\" is in a layer that is not the active one"));
  }

  @Test
  void theTimeLineNamesTheBudgetAsTheCause() throws IOException {
    open("triangles:1400", FLOOR, LEFT, RIGHT);
    look(-2, 0, 0);
    TimelineEvent change = events.get(events.size() - 1);
    assertThat(new TimelineJson().line(change))
        .isEqualTo(
            "{\"t\":0.1,\"event\":\"switch\",\"switch\":\"Left\",\"from\":1,\"to\":0,"
                + "\"schema\":\"\",\"cause\":\"budget\"}");
    assertThat(new TimelineText().line(change)).endsWith("Left: choice 1 -> 0 (budget)");
  }

  @Test
  void whatIsHeldOrNotEnrichedIsPaidFirst() throws IOException {
    Settings held = new Settings(Condition.SELECTIVE, 0, Map.of("Left", 0));
    open(held.within(RenderingBudget.of("triangles:2400").orElseThrow()), FLOOR, LEFT, RIGHT);
    look(2, 0, 0);
    assertThat(changed()).isEmpty();
    assertThat(walk.polygons()).isEqualTo(12 + 1200 + 12);
  }

  @Test
  void anObjectInTwoPlacesCostsTwice() throws IOException {
    String twice = LEFT + "<Transform translation='0 0 -3'><Switch USE='Left'/></Transform>";
    open("triangles:2000", FLOOR, twice, RIGHT);
    look(0, 0, 0);
    assertThat(changed()).isEqualTo(Map.of("Right", 0));
    walk.close();
    open("triangles:2500", FLOOR, twice, RIGHT);
    look(0, 0, 0);
    assertThat(changed()).isEqualTo(Map.of("Left", 0));
  }

  @Test
  void anObjectThatMovesIsWeighedWhereItIs() throws IOException {
    open(
        "triangles:1400",
        FLOOR,
        object("Left", -3, -9, "kitchen", "hall"),
        object("Right", 3, -19, "kitchen", "hall"),
        "<TimeSensor DEF='Clock' cycleInterval='1' loop='true'/>",
        "<PositionInterpolator DEF='Way' key='0 .5 1' keyValue='3 0 -19 3 0 -3 3 0 -3'/>",
        "<ROUTE fromNode='Clock' fromField='fraction_changed' toNode='Way'"
            + " toField='set_fraction'/>",
        "<ROUTE fromNode='Way' fromField='value_changed' toNode='RightPlace'"
            + " toField='translation'/>");
    look(0, 3, 0);
    assertThat(changed()).isEqualTo(Map.of("Left", 0));
    for (int frame = 0; frame < 7; frame++) {
      look(0, 3, 0);
    }
    assertThat(changed()).isEqualTo(Map.of("Left", 1, "Right", 0));
  }

  @Test
  void aWalkNeverCostsMoreThanTheBudgetAndIsTheSameEveryTime() throws IOException {
    StringBuilder many = new StringBuilder(FLOOR);
    for (int i = 0; i < 40; i++) {
      many.append(object("O" + i, i % 8 * 2 - 7, -2.0 * (i / 8), "kitchen", "hall"));
    }
    List<String> first = List.of();
    for (int round = 0; round < 2; round++) {
      open("triangles:12000", many.toString());
      time = 0;
      events.clear();
      for (int frame = 0; frame < 100; frame++) {
        look(7 * Math.cos(0.05 * frame), 4 * Math.sin(0.05 * frame), 3.6 * frame);
        assertThat(walk.polygons()).isBetween(10_000L, 12_000L);
      }
      List<String> lines = events.stream().map(new TimelineJson()::line).toList();
      assertThat(lines).hasSizeGreaterThan(40);
      if (round == 1) {
        assertThat(lines).isEqualTo(first);
      } else {
        first = lines;
        walk.close();
      }
    }
  }

  @Test
  void millisecondsAreKeptByFewerTriangles() throws IOException {
    open("ms:10", FLOOR, LEFT, RIGHT);
    double clock = 0;
    for (int frame = 0; frame < 400; frame++) {
      look(-2, 0, 0);
      clock += walk.polygons() * 0.005e-3;
      walk.budget().orElseThrow().drawn(clock);
    }
    assertThat(walk.polygons()).isEqualTo(12 + 1200 + 12);
  }
}
