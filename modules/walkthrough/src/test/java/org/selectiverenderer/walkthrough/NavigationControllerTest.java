package org.selectiverenderer.walkthrough;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.apparatus.MouseButtonMapping;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.PointingDeviceState;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.loading.SceneLoader;
import org.selectiverenderer.browser.navigation.KeyboardMouseControls;
import org.selectiverenderer.browser.navigation.NavigationCommand;
import org.selectiverenderer.browser.navigation.NavigationKey;
import org.selectiverenderer.browser.navigation.NavigationMode;
import org.selectiverenderer.browser.nodes.NodeFactory;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.ReadLimits;

/** How a user gets about in a scene: transitions, NavigationInfo and viewpoints. */
class NavigationControllerTest {
  private static final String VIEWPOINTS =
      "<Viewpoint DEF='A'/><Viewpoint DEF='B' position='8 0 10'/>";

  private final SceneLoader loader =
      new SceneLoader(
          NodeCatalogue.load(), new NodeFactory(), ReadLimits.standard(), new ProblemCollector());
  private final List<String> sent = new ArrayList<>();
  private World world;
  private NavigationController walking;
  private KeyboardMouseControls controls;

  private void scene(String nodes) throws IOException {
    String text = "<X3D version='4.0' profile='Immersive'><Scene>" + nodes + "</Scene></X3D>";
    world =
        new World(
            loader.load(
                "test.x3d",
                new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)),
                Path.of("no-such-folder")),
            new ProblemCollector());
    world.epoch(0);
    controls = new KeyboardMouseControls(MouseButtonMapping.WALK);
    walking = new NavigationController(world, controls);
    step(0);
  }

  @AfterEach
  void close() {
    loader.close();
  }

  private Node node(String name) {
    return world.scene().find(name).orElseThrow();
  }

  private void send(String node, String field, Object value) {
    world.cascade().send(node(node), node(node).type().indexOf(field), value);
  }

  private void step(double time) {
    world.step(time, walking);
  }

  private double x() {
    return world.viewer().position().x();
  }

  private void watch(String node, String field) {
    node(node)
        .addListener(
            node(node).type().indexOf(field),
            (from, index, value, time) -> sent.add(time + " " + field + "=" + value));
  }

  @Test
  void aViewpointBoundByAnEventIsReachedByATransition() throws IOException {
    scene("<NavigationInfo DEF='N' type='\"FLY\"' transitionTime='2'/>" + VIEWPOINTS);
    watch("N", "transitionComplete");
    send("B", "set_bind", true);
    step(1);
    assertThat(x()).isZero();
    step(2);
    assertThat(x()).isCloseTo(4, within(1e-9));
    assertThat(sent).isEmpty();
    step(3);
    assertThat(x()).isCloseTo(8, within(1e-9));
    step(4);
    assertThat(x()).isCloseTo(8, within(1e-9));
    assertThat(sent).containsExactly("3.0 transitionComplete=true");
  }

  @Test
  void teleportingTakesNoTime() throws IOException {
    scene("<NavigationInfo DEF='N' type='\"FLY\"' transitionType='\"TELEPORT\"'/>" + VIEWPOINTS);
    watch("N", "transitionComplete");
    send("B", "set_bind", true);
    step(1);
    assertThat(x()).isCloseTo(8, within(1e-9));
    assertThat(sent).containsExactly("1.0 transitionComplete=true");
  }

  @Test
  void aTransitionEndsWhereTheViewpointIsByThen() throws IOException {
    scene(
        "<NavigationInfo type='\"FLY\"'/><Viewpoint/>"
            + "<Transform DEF='T'><Viewpoint DEF='B' position='8 0 10'/></Transform>");
    send("B", "set_bind", true);
    step(1);
    send("T", "translation", new float[] {0, 6, 0});
    step(1.5);
    assertThat(world.viewer().position().y()).isCloseTo(3, within(1e-6));
    send("T", "translation", new float[] {2, 6, 0});
    step(2);
    assertThat(x()).isCloseTo(10, within(1e-6));
    assertThat(world.viewer().position().y()).isCloseTo(6, within(1e-6));
    send("T", "translation", new float[] {3, 6, 0});
    step(3);
    assertThat(x()).isCloseTo(11, within(1e-6));
  }

  @Test
  void theUsersModeStaysWhenHeGoesToAnotherViewpoint() throws IOException {
    scene("<NavigationInfo DEF='N' type='\"FLY\" \"ANY\"'/>" + VIEWPOINTS);
    walking.command(NavigationCommand.NEXT_MODE);
    assertThat(walking.mode()).isEqualTo(NavigationMode.EXAMINE);
    walking.command(NavigationCommand.NEXT_VIEWPOINT);
    step(1);
    assertThat(walking.mode()).isEqualTo(NavigationMode.EXAMINE);
    send("N", "speed", 3f);
    step(2);
    assertThat(walking.mode()).isEqualTo(NavigationMode.EXAMINE);
  }

  @Test
  void anAuthorWhoChangesTheTypesChangesTheMode() throws IOException {
    scene("<NavigationInfo DEF='N' type='\"FLY\" \"ANY\"'/>" + VIEWPOINTS);
    send("N", "type", new String[] {"NONE"});
    step(1);
    assertThat(walking.mode()).isEqualTo(NavigationMode.NONE);
  }

  @Test
  void wallsThatAreSwitchedOffStayOffInAnotherScene() throws IOException {
    scene(VIEWPOINTS);
    walking.command(NavigationCommand.TOGGLE_COLLISIONS);
    assertThat(walking.describe()).isEqualTo("WALK, through walls");
    world.replace(
        loader.load(
            "other.x3d",
            new ByteArrayInputStream(
                "<X3D version='4.0' profile='Immersive'><Scene/></X3D>"
                    .getBytes(StandardCharsets.UTF_8)),
            Path.of("no-such-folder")));
    step(1);
    assertThat(walking.describe()).isEqualTo("WALK, through walls");
  }

  private static final String BOX =
      "<Transform translation='20 0 0'>%s<Shape><Box/></Shape></Transform>";

  /** How far off a Box of 2 it is seen whole. */
  private static final double WHOLE = 1.1 * (1 + 1 / Math.tan(Math.PI / 8));

  private void click() {
    world.point(new PointingDeviceState(Optional.of(new Vector3d(20, 0, -10)), false));
    walking.command(NavigationCommand.LOOK_AT);
  }

  @Test
  void aClickGoesToWhereTheShapeIsSeenAsAWhole() throws IOException {
    scene("<NavigationInfo type='\"LOOKAT\"' transitionTime='2'/>" + BOX.formatted(""));
    click();
    step(1);
    step(3);
    Vector3dc eye = world.viewer().position();
    assertThat(eye.distance(20, 0, 0)).isBetween(WHOLE, 2 * WHOLE);
    Vector3d front = world.viewer().orientation().transform(new Vector3d(0, 0, -1));
    assertThat(front.angle(new Vector3d(20, 0, 0).sub(eye))).isCloseTo(0, within(1e-6));
  }

  @Test
  void theWayThereIsThatOfTheNavigationInfo() throws IOException {
    scene("<NavigationInfo type='\"EXAMINE\" \"ANY\"' transitionTime='4'/>" + BOX.formatted(""));
    click();
    step(2);
    double halfway = x();
    step(4);
    assertThat(halfway).isCloseTo(x() / 2, within(1e-6));
  }

  @Test
  void afterAClickOneTurnsAboutTheShape() throws IOException {
    scene("<NavigationInfo type='\"LOOKAT\"' transitionTime='0'/>" + BOX.formatted(""));
    click();
    step(1);
    double distance = world.viewer().position().distance(20, 0, 0);
    controls.keyDown(NavigationKey.LEFT);
    step(2);
    step(3);
    assertThat(world.viewer().position().distance(20, 0, 0)).isCloseTo(distance, within(1e-6));
    assertThat(x()).isNotCloseTo(20, within(1e-3));
  }

  @Test
  void aClickMovesNobodyWhereTheAuthorDoesNotAllowIt() throws IOException {
    scene("<NavigationInfo type='\"EXAMINE\" \"FLY\"'/>" + BOX.formatted(""));
    click();
    step(1);
    step(2);
    assertThat(world.viewer().position()).isEqualTo(new Vector3d(0, 0, 10));
  }

  @Test
  void aClickOnASensorIsTheScenesOwn() throws IOException {
    scene("<NavigationInfo type='\"LOOKAT\"'/>" + BOX.formatted("<TouchSensor/>"));
    click();
    step(1);
    step(2);
    assertThat(world.viewer().position()).isEqualTo(new Vector3d(0, 0, 10));
  }

  @Test
  void aWalkerWhoWantsToSeeAllExaminesItAndComesBackByTheViewpoint() throws IOException {
    scene(VIEWPOINTS + BOX.formatted(""));
    walking.command(NavigationCommand.VIEW_ALL);
    step(1);
    step(2);
    assertThat(walking.mode()).isEqualTo(NavigationMode.EXAMINE);
    assertThat(world.viewer().position().distance(20, 0, 0)).isBetween(WHOLE, 2 * WHOLE);
    walking.command(NavigationCommand.RESET_VIEWPOINT);
    step(3);
    step(4);
    assertThat(world.viewer().position()).isEqualTo(new Vector3d(0, 0, 10));
    assertThat(world.views().centre()).isEmpty();
  }

  @Test
  void whoMayOnlyWalkOrNotMoveAtAllIsNotTakenUpToSeeAll() throws IOException {
    for (String type : List.of("WALK", "NONE")) {
      scene("<NavigationInfo type='" + type + "'/>" + BOX.formatted(""));
      walking.command(NavigationCommand.VIEW_ALL);
      step(1);
      step(2);
      assertThat(x()).as(type).isZero();
    }
  }

  @Test
  void aSceneThatShowsAllOfItselfIsExamined() throws IOException {
    scene("<Viewpoint viewAll='true'/>" + BOX.formatted(""));
    assertThat(walking.mode()).isEqualTo(NavigationMode.EXAMINE);
    assertThat(world.views().centre()).contains(new Vector3d(20, 0, 0));
  }
}
