package org.selectiverenderer.browser;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.scene.Node;

class ViewpointFollowerTest {
  private static final String TURN = "0 1 0 1.5707963267948966";

  private static void assertAt(WorldFixture fixture, double x, double y, double z) {
    assertThat(fixture.world.viewer().position().distance(x, y, z))
        .as("at %s", fixture.world.viewer().position())
        .isLessThan(1e-5);
  }

  private static void assertLooks(WorldFixture fixture, double x, double y, double z) {
    Vector3dc ahead = fixture.world.viewer().orientation().transform(new Vector3d(0, 0, -1));
    assertThat(ahead.distance(x, y, z)).as("looks along %s", ahead).isLessThan(1e-5);
  }

  @Test
  void theFirstViewpointIsTheStart() {
    try (WorldFixture fixture =
        new WorldFixture(
            "<Viewpoint position='1 2 3' orientation='"
                + TURN
                + "' fieldOfView='1'/><Viewpoint/>")) {
      fixture.step(0);
      assertAt(fixture, 1, 2, 3);
      assertLooks(fixture, -1, 0, 0);
      assertThat(fixture.world.viewer().fieldOfView()).isEqualTo(1, within(1e-6));
    }
  }

  @Test
  void withoutViewpointTheStandardsDefaultIsTheStart() {
    try (WorldFixture fixture = new WorldFixture("<Group/>")) {
      fixture.step(0);
      assertAt(fixture, 0, 0, 10);
      assertLooks(fixture, 0, 0, -1);
      fixture.world.views().goToViewpoint(+1);
      assertAt(fixture, 0, 0, 10);
    }
  }

  @Test
  void transformationsAboveAViewpointPlaceItAndTheirScaleDoesNotBendIt() {
    try (WorldFixture fixture =
        new WorldFixture(
            """
            <Transform translation='10 0 0' scale='2 3 4'><Transform rotation='%s' translation='1 0 0'>
            <Viewpoint position='0 0 1'/></Transform></Transform>
            """
                .formatted(TURN))) {
      fixture.step(0);
      // (0 0 1) turned to (1 0 0), moved to (2 0 0), scaled to (4 0 0), moved to (14 0 0).
      assertAt(fixture, 14, 0, 0);
      assertThat(fixture.world.viewer().orientation().lengthSquared()).isEqualTo(1, within(1e-9));
      assertLooks(fixture, -1, 0, 0);
    }
  }

  @Test
  void theUserKeepsTheOffsetFromAnAnimatedViewpoint() {
    try (WorldFixture fixture =
        new WorldFixture("<Transform DEF='T'><Viewpoint position='0 0 5'/></Transform>")) {
      fixture.step(0, 1, 0, 5);
      fixture.send("T", "translation", new float[] {0, 2, 0});
      fixture.step(1);
      assertAt(fixture, 1, 2, 5);
      fixture.send("T", "rotation", new float[] {0, 1, 0, (float) (Math.PI / 2)});
      fixture.step(2);
      assertAt(fixture, 5, 2, -1);
      assertLooks(fixture, -1, 0, 0);
      fixture.step(3);
      assertAt(fixture, 5, 2, -1);
    }
  }

  @Test
  void aViewpointMovedByItsOwnFieldTakesTheViewerAlong() {
    try (WorldFixture fixture = new WorldFixture("<Viewpoint DEF='V' position='0 0 5'/>")) {
      fixture.step(0);
      fixture.send("V", "position", new float[] {0, 0, 7});
      fixture.send("V", "fieldOfView", 0.5f);
      fixture.step(1);
      assertAt(fixture, 0, 0, 7);
      assertThat(fixture.world.viewer().fieldOfView()).isEqualTo(0.5, within(1e-6));
    }
  }

  @Test
  void theFieldOfViewFollowsAlthoughTheViewpointStands() {
    try (WorldFixture fixture = new WorldFixture("<Viewpoint DEF='V'/>")) {
      fixture.step(0);
      fixture.send("V", "fieldOfView", 0.5f);
      fixture.step(1);
      assertThat(fixture.world.viewer().fieldOfView()).isEqualTo(0.5, within(1e-6));
    }
  }

  @Test
  void bindingJumpsOnlyWhereTheViewpointSaysSo() {
    try (WorldFixture fixture =
        new WorldFixture(
            """
            <Viewpoint DEF='A' position='1 0 0'/><Viewpoint DEF='B' position='2 0 0'/>
            <Viewpoint DEF='Still' position='3 0 0' jump='false' fieldOfView='2'/>
            """)) {
      fixture.step(0);
      fixture.send("B", "set_bind", true);
      fixture.step(1);
      assertAt(fixture, 2, 0, 0);
      fixture.send("Still", "set_bind", true);
      fixture.step(2);
      assertAt(fixture, 2, 0, 0);
      fixture.send("Still", "position", new float[] {4, 0, 0});
      fixture.step(3);
      assertAt(fixture, 3, 0, 0);
    }
  }

  @Test
  void userOffsetsAreKeptWhereTheViewpointSaysSo() {
    try (WorldFixture fixture =
        new WorldFixture(
            """
            <Viewpoint position='1 0 0'/>
            <Viewpoint DEF='Keeping' position='0 0 20' retainUserOffsets='true'/>
            <Viewpoint DEF='Plain' position='0 0 30'/>
            """)) {
      fixture.step(0, 1, 2, 3);
      fixture.send("Keeping", "set_bind", true);
      fixture.step(1);
      assertAt(fixture, 0, 2, 23);
      fixture.send("Plain", "set_bind", true);
      fixture.step(2);
      assertAt(fixture, 0, 0, 30);
    }
  }

  @Test
  void unbindingGoesBackToTheViewpointBefore() {
    try (WorldFixture fixture =
        new WorldFixture("<Viewpoint position='1 0 0'/><Viewpoint DEF='B' position='2 0 0'/>")) {
      fixture.send("B", "set_bind", true);
      fixture.step(0);
      fixture.send("B", "set_bind", false);
      fixture.step(1);
      assertAt(fixture, 1, 0, 0);
    }
  }

  @Test
  void whenTheBoundViewpointLeavesTheSceneTheOneBeforeIsBound() {
    try (WorldFixture fixture =
        new WorldFixture(
            "<Viewpoint position='1 0 0'/><Group DEF='G'><Viewpoint DEF='B' position='2 0 0'/></Group>")) {
      fixture.send("B", "set_bind", true);
      fixture.step(0);
      fixture.send("G", "children", List.of());
      fixture.step(1);
      assertAt(fixture, 1, 0, 0);
      assertThat(fixture.world.views().viewpoints()).hasSize(1);
    }
  }

  @Test
  void aViewpointThatComesInAGroupThatCameInTheSameFrameIsOffered() {
    try (WorldFixture fixture = new WorldFixture("<Viewpoint position='1 0 0'/><Group DEF='G'/>")) {
      fixture.step(0);
      Node viewpoint = fixture.make("Viewpoint");
      Node group = fixture.make("Group");
      fixture.send("G", "addChildren", List.of(group));
      fixture.world.cascade().send(group, group.type().indexOf("children"), List.of(viewpoint));
      fixture.step(1);
      assertThat(fixture.world.views().viewpoints()).hasSize(2).endsWith(viewpoint);
      Node later = fixture.make("Viewpoint");
      fixture.world.cascade().send(group, group.type().indexOf("children"), List.of(later));
      fixture.step(2);
      assertThat(fixture.world.views().viewpoints()).hasSize(2).endsWith(later);
    }
  }

  @Test
  void whenTheOnlyViewpointLeavesTheViewerStays() {
    try (WorldFixture fixture =
        new WorldFixture("<Group DEF='G'><Viewpoint position='2 0 0'/></Group>")) {
      fixture.step(0, 3, 0, 0);
      List<Node> viewpoints = fixture.node("G").nodes("children");
      fixture.send("G", "children", List.of());
      fixture.step(1);
      assertAt(fixture, 3, 0, 0);
      fixture.send("G", "children", viewpoints);
      fixture.step(2);
      assertAt(fixture, 3, 0, 0);
    }
  }

  @Test
  void goingToAViewpointForgetsWhereTheUserWent() {
    try (WorldFixture fixture =
        new WorldFixture(
            "<Viewpoint DEF='A' position='1 0 0'/><Viewpoint DEF='B' position='2 0 0' jump='false'/>")) {
      fixture.step(0, 9, 9, 9);
      fixture.world.views().goTo(fixture.node("A"));
      assertAt(fixture, 1, 0, 0);
      fixture.world.views().goTo(fixture.node("B"));
      assertAt(fixture, 2, 0, 0);
      fixture.step(1);
      assertAt(fixture, 2, 0, 0);
    }
  }

  @Test
  void steppingThroughViewpointsGoesRoundInDocumentOrder() {
    try (WorldFixture fixture =
        new WorldFixture(
            "<Viewpoint position='1 0 0'/><Group><Viewpoint position='2 0 0'/></Group><Viewpoint position='3 0 0'/>")) {
      fixture.step(0);
      double[] expected = {2, 3, 1, 2};
      for (double x : expected) {
        fixture.world.views().goToViewpoint(+1);
        fixture.step(1);
        assertAt(fixture, x, 0, 0);
      }
      fixture.world.views().goToViewpoint(-1);
      fixture.world.views().goToViewpoint(-1);
      assertAt(fixture, 3, 0, 0);
    }
  }

  @Test
  void aFlattenedViewpointIsStillAPlace() {
    try (WorldFixture fixture =
        new WorldFixture("<Transform scale='0 0 0'><Viewpoint position='1 0 0'/></Transform>")) {
      fixture.step(0);
      assertThat(fixture.world.viewer().position().isFinite()).isTrue();
      assertThat(fixture.world.viewer().orientation().isFinite()).isTrue();
    }
  }
}
