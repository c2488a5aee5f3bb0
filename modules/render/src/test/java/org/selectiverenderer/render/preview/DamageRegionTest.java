package org.selectiverenderer.render.preview;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.selectiverenderer.render.draw.PixelRectangle;

class DamageRegionTest {
  private final DamageRegion region = new DamageRegion();

  @Test
  void whatChangesInOnePlaceBeforeAndAfterIsDrawnOnce() {
    PixelRectangle one = new PixelRectangle(500, 200, 23, 20);
    PixelRectangle other = new PixelRectangle(100, 900, 16, 17);
    region.add(one);
    region.add(other);
    region.add(one);
    region.add(other);

    assertThat(region.rectangles()).containsExactlyInAnyOrder(one, other);
  }

  @Test
  void neighboursAreDrawnTogether() {
    region.add(new PixelRectangle(0, 0, 20, 20));
    region.add(new PixelRectangle(30, 0, 20, 20));

    assertThat(region.rectangles()).containsExactly(new PixelRectangle(0, 0, 50, 20));
  }

  @Test
  void aRectangleThatTouchesTwoUnitesThem() {
    region.add(new PixelRectangle(0, 0, 300, 300));
    region.add(new PixelRectangle(0, 700, 300, 300));
    region.add(new PixelRectangle(0, 250, 300, 500));

    assertThat(region.rectangles()).containsExactly(new PixelRectangle(0, 0, 300, 1000));
  }

  @Test
  void ofManyThoseThatLoseLeastAreUnited() {
    for (int i = 0; i < 4; i++) {
      region.add(new PixelRectangle(400 * i, 0, 20, 20));
    }
    region.add(new PixelRectangle(0, 600, 20, 20));
    assertThat(region.rectangles()).hasSizeLessThanOrEqualTo(4);
    region.rectangles().forEach(each -> assertThat(each.area()).isPositive());
    assertThat(region.rectangles().stream().reduce(PixelRectangle::union))
        .contains(new PixelRectangle(0, 0, 1220, 620));
  }
}
