package org.selectiverenderer.browser;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.browser.viewer.OrthographicExtent;

/** Tests nodes whose layout depends on the size of the picture or the display, without drawing. */
class LayoutTest {
  private static final String LAYER =
      """
      <LayerSet order='0 1'><LayoutLayer>
        <Layout containerField='layout' align='"LEFT" "TOP"' size='100 50' sizeUnits='"PIXEL"'/>
        <Shape><Rectangle2D size='1 1'/></Shape>
      </LayoutLayer></LayerSet>
      """;

  private static final String SCREEN =
      "<ScreenGroup><Shape><Rectangle2D size='10 10'/></Shape></ScreenGroup>";

  @Test
  void withoutAPictureItIsAsWideAsAWindowIs() {
    try (WorldFixture fixture = new WorldFixture(LAYER)) {
      fixture.step(0);
      assertThat(corners(fixture, 1)).isEqualTo(box(-4 / 3.0, 1 - 50 / 384.0, 100 / 384.0, 1));
    }
  }

  @Test
  void aPictureOfAnotherSizeIsFollowedAtOnce() {
    try (WorldFixture fixture = new WorldFixture(LAYER)) {
      fixture.step(0);
      fixture.world.seenIn(800, 400, Optional.empty());
      assertThat(corners(fixture, 1)).isEqualTo(box(-2, 1 - 50 / 200.0, 100 / 200.0, 1));
      fixture.world.seenIn(200, 400, Optional.empty());
      assertThat(corners(fixture, 1)).isEqualTo(box(-1, 2 - 50 / 100.0, 1, 2));
    }
  }

  @Test
  void aPixelOfADisplayIsAsLargeAsItsAngle() {
    try (WorldFixture fixture = new WorldFixture(SCREEN)) {
      fixture.step(0);
      fixture.world.seenIn(100, 100, Optional.of(new OrthographicExtent(-0.5, -0.5, 0.5, 0.5)));
      // The viewer stands 10 away, where 100 pixels are 10 high.
      assertThat(corners(fixture, 0)).isEqualTo(box(-0.5, -0.5, 1, 0.5));
    }
  }

  @Test
  void aSceneWithoutSuchNodesDoesNotDependOnThePicture() {
    try (WorldFixture fixture = new WorldFixture("<Shape><Box/></Shape>")) {
      InstanceTree tree = fixture.world.instances();
      long before = tree.placementVersion();
      fixture.step(0);
      fixture.world.seenIn(300, 100, Optional.empty());
      assertThat(tree.dependsOnPicture()).isFalse();
      assertThat(tree.placementVersion()).isEqualTo(before);
    }
  }

  @Test
  void whatStandsStillInThePictureMovesNothing() {
    try (WorldFixture fixture = new WorldFixture(LAYER + SCREEN)) {
      fixture.step(0);
      InstanceTree tree = fixture.world.layers().get(1).instances();
      long before = tree.placementVersion();
      fixture.step(1);
      assertThat(tree.placementVersion()).isEqualTo(before);
    }
  }

  /** Left, bottom, width and top of the first shape of a layer, in hundred thousandths. */
  private static List<Long> corners(WorldFixture fixture, int layer) {
    double[] box = fixture.world.layers().get(layer).instances().shapes().get(0).bounds();
    assertThat(box[2]).isEqualTo(0, within(1e-9));
    return box(box[0], box[1], box[3] - box[0], box[4]);
  }

  private static List<Long> box(double left, double bottom, double width, double top) {
    return DoubleStream.of(left, bottom, width, top)
        .mapToObj(value -> Math.round(value * 1e5))
        .toList();
  }
}
