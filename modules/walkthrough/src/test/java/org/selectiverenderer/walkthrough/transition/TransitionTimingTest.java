package org.selectiverenderer.walkthrough.transition;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.browser.camera.EyeCameras;
import org.selectiverenderer.browser.viewer.Viewer;
import org.selectiverenderer.control.ControlEvent.SwitchChange;
import org.selectiverenderer.control.SelectiveController.Settings;
import org.selectiverenderer.control.SwitchVisibility;
import org.selectiverenderer.schema.SwitchTransition;
import org.selectiverenderer.walkthrough.Walkthrough;
import org.selectiverenderer.walkthrough.timeline.TimelineEvent;

/**
 * When objects change: a box of 1 m, five metres ahead of the origin in the direction of -Z, that
 * changes as the viewer enters the area around the origin, and back as the viewer leaves.
 */
class TransitionTimingTest {
  private static final SwitchTransition UNSEEN = new SwitchTransition.Unseen(180);

  private static final String MATERIAL = "<Appearance><Material transparency='%s'/></Appearance>";

  private static final String BOX =
      "<Shape>" + MATERIAL.formatted(0) + "<Box size='1 1 1'/></Shape>";

  private static final String OBJECT =
      "<Transform translation='0 0 -5'><Switch DEF='Can' whichChoice='1'>"
          + BOX
          + BOX
          + "<MetadataSet containerField='metadata'>"
          + version("low", "near")
          + version("high", "far")
          + "</MetadataSet></Switch></Transform>";

  private static final String AREA =
      "<ProximitySensor DEF='Area' size='2 2 2'><MetadataSet containerField='metadata'>"
          + "<MetadataString name='enterTimeSchema' value='\"near\"'/>"
          + "<MetadataString name='exitTimeSchema' value='\"far\"'/></MetadataSet>"
          + "</ProximitySensor>";

  private static String version(String degree, String schema) {
    return "<MetadataSet><MetadataString name='consistencyType' value='\"consistent\"'/>"
        + "<MetadataString name='degreeOfConsistency' value='\"%s\"'/>".formatted(degree)
        + "<MetadataString name='schemaBelonginess' value='\"%s\"'/>".formatted(schema)
        + "</MetadataSet>";
  }

  private static String wall(double transparency) {
    return "<Transform translation='0 0 -3'><Shape>"
        + MATERIAL.formatted(transparency)
        + "<Box size='6 4 0.1'/></Shape></Transform>";
  }

  @TempDir Path folder;

  private final List<SwitchChange> changes = new ArrayList<>();
  private Optional<TimelineEvent.End> end = Optional.empty();
  private Walkthrough walk;
  private double time;

  private void open(String nodes, SwitchTransition transition) throws IOException {
    Path scene = folder.resolve("scene.x3d");
    Files.writeString(
        scene, "<X3D version='4.0' profile='Full'><Scene>" + nodes + AREA + "</Scene></X3D>");
    walk =
        Walkthrough.open(
            scene, Settings.SELECTIVE.with(transition), problem -> {}, this::heard, text -> {});
    walk.observeSwitches();
  }

  private void heard(TimelineEvent event) {
    if (event instanceof TimelineEvent.ControllerEvent told
        && told.event() instanceof SwitchChange change) {
      changes.add(change);
    } else if (event instanceof TimelineEvent.End over) {
      end = Optional.of(over);
    }
  }

  @AfterEach
  void close() {
    walk.close();
  }

  /** A frame, a second after the last, with the viewer at (x, 0, 0), turned to the left. */
  private void frame(double x, double degrees) {
    frame(1, x, degrees);
  }

  private void frame(double seconds, double x, double degrees) {
    time += seconds;
    walk.step(
        time,
        (viewer, now, dt) -> {
          viewer.moveTo(new Vector3d(x, 0, 0));
          viewer.turnTo(Viewer.orientation(Math.toRadians(degrees), 0, 0));
        });
  }

  private List<Integer> choices() {
    return changes.stream().map(SwitchChange::to).toList();
  }

  private SwitchVisibility seen() {
    return changes.get(changes.size() - 1).seen().orElseThrow();
  }

  @Test
  void anObjectInViewWaitsUntilTheViewerLooksAway() throws IOException {
    open(OBJECT, UNSEEN);
    frame(5, 0);
    frame(0, 0);
    assertThat(choices()).isEmpty();
    frame(0, 40);
    frame(0, 80);
    assertThat(choices()).containsExactly(0);
    assertThat(seen().visible()).isFalse();
    assertThat(seen().pixels()).isZero();
  }

  @Test
  void anObjectBehindTheViewerChangesAtOnce() throws IOException {
    open(OBJECT, UNSEEN);
    frame(5, 180);
    frame(0, 180);
    assertThat(choices()).containsExactly(0);
  }

  @Test
  void anObjectBehindAWallChangesAtOnce() throws IOException {
    open(OBJECT + wall(0), UNSEEN);
    frame(5, 0);
    frame(0, 0);
    assertThat(choices()).containsExactly(0);
    assertThat(seen().visible()).isFalse();
  }

  @Test
  void glassHidesNothing() throws IOException {
    open(OBJECT + wall(0.8), UNSEEN);
    frame(5, 0);
    frame(0, 0);
    assertThat(choices()).isEmpty();
  }

  @Test
  void aWallWithAnObjectBesideItHidesNotAll() throws IOException {
    String gap = "<Transform translation='-3.3 0 0'>" + wall(0) + "</Transform>";
    open(OBJECT + gap, UNSEEN);
    frame(5, 0);
    frame(0, 0);
    assertThat(choices()).as("the wall ends at -0.3").isEmpty();
  }

  @Test
  void aTurnFasterThanTheRateHidesTheChange() throws IOException {
    open(OBJECT, UNSEEN);
    frame(5, 10);
    frame(0, 10);
    frame(0.1, 0, 0);
    assertThat(choices()).as("100 degrees a second").isEmpty();
    frame(0.1, 0, -19);
    assertThat(choices()).as("190 degrees a second").containsExactly(0);
    assertThat(seen().visible()).isTrue();
    assertThat(seen().turning()).isCloseTo(190, within(1e-6));
  }

  @Test
  void anotherRateCanBeAskedFor() throws IOException {
    open(OBJECT, new SwitchTransition.Unseen(90));
    frame(5, 10);
    frame(0, 10);
    frame(0.1, 0, 0);
    assertThat(choices()).containsExactly(0);
  }

  @Test
  void whoLeavesTheAreaBeforeSeesNoChangeAtAll() throws IOException {
    open(OBJECT, UNSEEN);
    frame(5, 0);
    frame(0, 0);
    frame(5, 0);
    frame(5, 180);
    walk.end();
    assertThat(choices()).isEmpty();
    assertThat(end.orElseThrow().waiting()).isEmpty();
  }

  @Test
  void theEndTellsWhatWaitedInVain() throws IOException {
    open(OBJECT, UNSEEN);
    frame(5, 0);
    frame(0, 0);
    walk.end();
    assertThat(end.orElseThrow().waiting()).containsExactly(Map.entry("Can", 0));
  }

  @Test
  void aHeldChoiceIsShownAlthoughItIsSeen() throws IOException {
    open(OBJECT, UNSEEN);
    frame(5, 0);
    frame(0, 0);
    walk.hold(Map.of("Can", 0));
    frame(0, 180);
    frame(5, 180);
    assertThat(choices()).isEmpty();
  }

  @Test
  void nothingIsSeenBeforeTheFirstFrame() throws IOException {
    open(OBJECT, UNSEEN);
    frame(0, 0);
    assertThat(choices()).containsExactly(0);
    assertThat(seen()).isEqualTo(new SwitchVisibility(false, 0, 0));
  }

  /** The front of the box is 1 m wide and 4.5 m away; the picture is 768 pixels high. */
  @Test
  void thePixelsAreThoseOfThePicture() throws IOException {
    open(OBJECT, SwitchTransition.AT_ONCE);
    frame(5, 0);
    frame(0, 0);
    double side = 1 / 4.5 / (2 * Math.tan(Math.PI / 8)) * 768;
    assertThat(seen().visible()).isTrue();
    assertThat(seen().pixels()).isCloseTo(side * side, within(side * side * 0.3));
  }

  /** It is so large that hardly any of its points are in the view. */
  @Test
  void aLargeObjectNearTheEyeFillsThePicture() throws IOException {
    String carpet = OBJECT.replace("0 0 -5", "0 0 -1.2").replace("1 1 1", "400 400 0.1");
    open(carpet, UNSEEN);
    frame(5, 180);
    frame(5, 0);
    frame(0, 0);
    assertThat(choices()).isEmpty();
    walk.close();
    changes.clear();
    open(carpet, SwitchTransition.AT_ONCE);
    frame(5, 0);
    frame(0, 0);
    assertThat(seen().pixels()).isCloseTo(1024 * 768, within(1024 * 768 * 0.05));
  }

  @Test
  void whatOneEyeSeesIsSeen() throws IOException {
    open(OBJECT, UNSEEN);
    frame(5, 50);
    Matrix4d narrow = new Matrix4d().setPerspective(Math.toRadians(20), 1, 0.1, 100);
    Matrix4d view = walk.world().viewer().view();
    Matrix4d turned = new Matrix4d().rotateY(Math.toRadians(50)).mul(view);
    List<Camera> eyes =
        List.of(
            new Camera(view, narrow, 0, 0, 100, 100), new Camera(turned, narrow, 100, 0, 100, 100));
    walk.world().seenBy(EyeCameras.frames(eyes, 1, walk.world().viewer()), eyes.get(0).angle());
    frame(0, 50);
    assertThat(choices()).as("the second eye squints at it").isEmpty();
    frame(0, 90);
    assertThat(choices()).containsExactly(0);
  }

  @Test
  void aFadeIsToldAsItBeginsAndLastsItsTime() throws IOException {
    open(OBJECT, new SwitchTransition.Fade(2000));
    frame(5, 0);
    frame(0, 0);
    assertThat(choices()).containsExactly(0);
    assertThat(walk.world().instances().fades().versions()).hasSize(2);
    frame(0, 0);
    assertThat(walk.world().instances().fades().versions().get(1).threshold()).isEqualTo(0.5);
    frame(0, 0);
    assertThat(walk.world().instances().fades().versions()).isEmpty();
  }

  /** A layer before that of the viewer, whose own viewpoint is 10 m before its origin. */
  private static final String LAYERED =
      "<LayerSet activeLayer='0' order='0 1'><Layer>" + OBJECT + "</Layer></LayerSet>";

  @Test
  void anObjectInAnotherLayerIsSeenFromThere() throws IOException {
    open(LAYERED, UNSEEN);
    frame(5, 180);
    frame(0, 180);
    frame(0, 90);
    assertThat(choices()).as("the viewer does not turn in that layer").isEmpty();
    walk.close();
    open(LAYERED, SwitchTransition.AT_ONCE);
    frame(5, 180);
    frame(0, 180);
    double side = 1 / 14.5 / (2 * Math.tan(Math.PI / 8)) * 768;
    assertThat(seen().visible()).isTrue();
    assertThat(seen().pixels()).isCloseTo(side * side, within(side * side * 0.3));
  }

  @Test
  void anObjectInAnotherLayerFadesThere() throws IOException {
    open(LAYERED, new SwitchTransition.Fade(2000));
    frame(5, 0);
    frame(0, 0);
    assertThat(walk.world().instances().fades().versions()).isEmpty();
    assertThat(walk.world().layers().get(1).instances().fades().versions()).hasSize(2);
    frame(0, 0);
    assertThat(walk.world().layers().get(1).instances().fades().versions().get(1).threshold())
        .isEqualTo(0.5);
  }

  @Test
  void thousandsOfObjectsAreLookedAtInTurn() throws IOException {
    StringBuilder many = new StringBuilder(wall(0));
    for (int i = 0; i < 300; i++) {
      many.append(OBJECT.replace("DEF='Can'", "DEF='Can" + i + "'"));
    }
    open(many.toString(), UNSEEN);
    frame(5, 0);
    frame(0, 0);
    assertThat(changes).as("within the rays of a frame").hasSizeBetween(10, 150);
    for (int i = 0; i < 30; i++) {
      frame(0, 0);
    }
    assertThat(changes).hasSize(300);
  }
}
