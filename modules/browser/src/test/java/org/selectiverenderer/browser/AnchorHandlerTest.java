package org.selectiverenderer.browser;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.Problem;

@Timeout(60)
class AnchorHandlerTest {
  @TempDir private Path folder;

  private static String anchor(String url, String nodes) {
    return "<Anchor url='\"" + url + "\"'><Shape><Box/></Shape></Anchor>\n" + nodes;
  }

  private static PointingDeviceState ahead(boolean pressed) {
    return new PointingDeviceState(Optional.of(new Vector3d(0, 0, -1)), pressed);
  }

  private static void click(WorldFixture fixture) {
    fixture.world.point(ahead(true));
    fixture.world.point(ahead(false));
    fixture.step(1);
  }

  private void write(String name, String nodes) throws IOException {
    Files.writeString(
        folder.resolve(name), "<X3D version='4.0'><Scene>" + nodes + "</Scene></X3D>");
  }

  /** Steps until what is read in the background has arrived. */
  private static void stepUntilReplaced(WorldFixture fixture) {
    boolean[] replaced = {false};
    fixture.world.onReplace(world -> replaced[0] = true);
    for (double time = 2; !replaced[0]; time++) {
      fixture.step(time);
    }
  }

  @Test
  void anAnchorToAViewpointBindsIt() {
    try (WorldFixture fixture =
        new WorldFixture(
            anchor("#There", "<Viewpoint/><Viewpoint DEF='There' position='1 2 3'/>"))) {
      click(fixture);
      fixture.step(2);
      assertThat(fixture.world.viewer().position()).isEqualTo(new Vector3d(1, 2, 3));
      assertThat(fixture.problems.list()).isEmpty();
    }
  }

  @Test
  void pressingElsewhereAndReleasingOnAnAnchorDoesNothing() {
    try (WorldFixture fixture =
        new WorldFixture(
            anchor("#There", "<Viewpoint/><Viewpoint DEF='There' position='1 2 3'/>"))) {
      fixture.world.point(new PointingDeviceState(Optional.of(new Vector3d(0, 1, 0)), true));
      fixture.world.point(ahead(true));
      fixture.world.point(ahead(false));
      fixture.step(1);
      fixture.step(2);
      assertThat(fixture.world.viewer().position()).isEqualTo(new Vector3d(0, 0, 10));
    }
  }

  @Test
  void aViewpointThatIsMissingIsAProblem() {
    try (WorldFixture fixture = new WorldFixture(anchor("#Nowhere", "<Viewpoint/>"))) {
      click(fixture);
      assertThat(fixture.problems.list())
          .extracting(Problem::toString)
          .containsExactly(
              "test.x3d:2:1: Anchor url '#Nowhere' names no viewpoint of test.x3d; the viewer"
                  + " stays");
    }
  }

  @Test
  void anAnchorInAnInlineMeansItsOwnFile() throws IOException {
    write("inner.x3d", anchor("#There", "<Viewpoint DEF='There' position='4 5 6'/>"));
    try (WorldFixture fixture =
        new WorldFixture(
            folder,
            "<Viewpoint/><Viewpoint DEF='There' position='1 2 3'/><Inline url='\"inner.x3d\"'/>")) {
      click(fixture);
      fixture.step(2);
      assertThat(fixture.world.viewer().position()).isEqualTo(new Vector3d(4, 5, 6));
    }
  }

  @Test
  void anAnchorToAFileShowsThatSceneFromTheViewpointNamed() throws IOException {
    write("other.x3d", "<Viewpoint/><Viewpoint DEF='There' position='1 2 3'/>");
    try (WorldFixture fixture = new WorldFixture(folder, anchor("other.x3d#There", ""))) {
      click(fixture);
      assertThat(fixture.world.instances().shownPolygons()).isEqualTo(12);
      stepUntilReplaced(fixture);
      fixture.step(1000);
      assertThat(fixture.world.instances().shownPolygons()).isZero();
      assertThat(fixture.world.viewer().position()).isEqualTo(new Vector3d(1, 2, 3));
    }
  }

  @Test
  void aSceneLinkedToMayNameWhatTheFirstOneMay() throws IOException {
    Files.createDirectories(folder.resolve("sub"));
    write("sub/other.x3d", "<Inline url='\"../part.x3d\" '/>");
    write("part.x3d", "<Shape><Box/></Shape><Shape><Box/></Shape>");
    try (WorldFixture fixture = new WorldFixture(folder, anchor("sub/other.x3d", ""))) {
      click(fixture);
      stepUntilReplaced(fixture);
      assertThat(fixture.problems.list()).isEmpty();
      assertThat(fixture.world.instances().shownPolygons()).isEqualTo(24);
    }
  }

  @Test
  void whatMayNotBeReadIsAProblemAndTheViewerStays() {
    for (String url : new String[] {"http://example.org/", "../secret.x3d", "none.x3d"}) {
      try (WorldFixture fixture = new WorldFixture(folder, anchor(url, ""))) {
        click(fixture);
        for (double time = 2; fixture.problems.list().isEmpty(); time++) {
          fixture.step(time);
        }
        assertThat(fixture.problems.list().get(0).toString())
            .startsWith("test.x3d:2:1: Anchor url '" + url + "' ")
            .endsWith("; the viewer stays here");
        assertThat(fixture.world.instances().shownPolygons()).isEqualTo(12);
      }
    }
  }

  @Test
  void whereAScriptLeadsLiesBesideItsOwnFile() throws IOException {
    Files.createDirectory(folder.resolve("rooms"));
    write("rooms/next.x3d", "<Group DEF='Next'/>");
    write(
        "rooms/hall.x3d",
        "<Script><![CDATA[ecmascript:"
            + " function initialize() { Browser.loadURL(new MFString('next.x3d')); } ]]></Script>");
    String hall = "<Inline url='\"rooms/hall.x3d\"'/>";
    try (WorldFixture fixture = new WorldFixture(folder, hall)) {
      stepUntilReplaced(fixture);
      assertThat(fixture.world.scene().find("Next")).isPresent();
      assertThat(fixture.problems.list()).isEmpty();
    }
  }
}
