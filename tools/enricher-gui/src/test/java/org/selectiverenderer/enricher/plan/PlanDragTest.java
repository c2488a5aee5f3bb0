package org.selectiverenderer.enricher.plan;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.authoring.area.SnapGrid;
import org.selectiverenderer.enricher.area.FloorPlanImage;
import org.selectiverenderer.geometry.BoundingBox;

class PlanDragTest {
  private static final BoundingBox START = new BoundingBox(1, 0, 1, 3, 2.5, 2);
  private static final PlanDrag.Snapping GRID = (axis, value) -> new SnapGrid(0.5).nearest(value);

  @Test
  void aGripMovesItsEdgesToTheGridAndNoFurtherThanTheOthers() {
    PlanDrag corner = new PlanDrag(START, 1, -1, 3, 1);
    assertThat(corner.at(4.2, 0.6, GRID)).isEqualTo(new BoundingBox(1, 0, 0.5, 4, 2.5, 2));
    BoundingBox least = corner.at(-9, 9, GRID);
    assertThat(least.width()).isCloseTo(PlanDrag.LEAST, within(1e-9));
    assertThat(least.depth()).isCloseTo(PlanDrag.LEAST, within(1e-9));
    assertThat(new PlanDrag(START, 0, 1, 2, 2).at(9, 3, GRID))
        .isEqualTo(new BoundingBox(1, 0, 1, 3, 2.5, 3));
  }

  @Test
  void movingKeepsTheSizeAndSnapsByTheEdgeThatIsNearer() {
    BoundingBox uneven = new BoundingBox(1, 0, 1, 3.2, 2.5, 2);
    PlanDrag move = new PlanDrag(uneven, 0, 0, 2, 1.5);
    BoundingBox moved = move.at(2.3, 1.5, GRID);
    assertThat(moved.maxX()).as("3.5 is on the grid").isCloseTo(3.5, within(1e-9));
    assertThat(moved.width()).isCloseTo(2.2, within(1e-9));
  }

  @Test
  void aCoordinateKeepsToAWallThatIsNearAndBesideIt() {
    float[] walls = {
      2.03f, 0, 2.03f, 4, /* short */ 5.02f, 0, 5.02f, 0.1f, /* slanted */ 7, 0, 8, 4
    };
    BufferedImage none = new BufferedImage(1, 1, BufferedImage.TYPE_INT_ARGB);
    PlanMouseController.WallSnapper snap =
        new PlanMouseController.WallSnapper(new FloorPlanImage(START, none, walls, 1));
    assertThat(snap.wall(0, 2.1, 2, 0.2).orElseThrow()).isCloseTo(2.03, within(1e-6));
    assertThat(snap.wall(0, 2.1, 9, 0.2)).as("beyond its end").isEmpty();
    assertThat(snap.wall(0, 2.4, 2, 0.2)).as("too far").isEmpty();
    assertThat(snap.wall(0, 5.1, 0, 0.2)).as("short").isEmpty();
    assertThat(snap.wall(0, 7.5, 2, 0.2)).as("slanted").isEmpty();
    assertThat(snap.wall(1, 2.1, 2, 0.2)).as("the other axis").isEmpty();
  }

  @Test
  void theScaleShowsAllAndZoomsAboutAPlace() {
    PlanTransform scale = PlanTransform.fitting(new BoundingBox(-10, 0, -5, 10, 0, 5), 400, 400);
    assertThat(scale.toX(-10)).isBetween(0.0, 40.0);
    assertThat(scale.toX(10)).isBetween(360.0, 400.0);
    assertThat(scale.toY(0)).isCloseTo(200, within(1e-9));
    PlanTransform nearer = scale.zoomed(2, 100, 50);
    assertThat(nearer.x(100)).isCloseTo(scale.x(100), within(1e-9));
    assertThat(nearer.z(50)).isCloseTo(scale.z(50), within(1e-9));
    assertThat(nearer.shifted(10, 0).toX(0)).isCloseTo(nearer.toX(0) + 10, within(1e-9));
  }
}
