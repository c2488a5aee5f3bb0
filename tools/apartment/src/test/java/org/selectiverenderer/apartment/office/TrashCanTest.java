package org.selectiverenderer.apartment.office;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.modelling.ParametricModel;

class TrashCanTest {

  @Test
  void hasThePolygonsOfTheThesisWithoutAnyRefinement() {
    assertThat(TrashCan.model().polygons()).isEqualTo(1064);
  }

  @Test
  void standsOnTheFloorAndIsSeenFromBothSides() {
    ParametricModel can = TrashCan.model();
    BoundingBox bounds = can.bounds();

    assertThat(bounds.minY()).isZero();
    assertThat(bounds.height()).isCloseTo(0.32, within(1e-6));
    assertThat(can.parts()).allMatch(part -> part.bothSides());
  }
}
