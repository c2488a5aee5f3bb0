package org.selectiverenderer.apartment.office;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.geometry.Bounds;
import org.selectiverenderer.modelling.Part;

class ShelvesTest {
  private static final double INSIDE = Shelves.WIDTH / 2 - Shelves.BOARD;

  @Test
  void theBookcaseIsAsLargeAsSaid() {
    Bounds b = Bookcase.model().bounds();

    assertThat(b.width()).isCloseTo(Shelves.WIDTH, within(1e-6));
    assertThat(b.height()).isCloseTo(Shelves.HEIGHT, within(1e-6));
    assertThat(b.depth()).isCloseTo(Shelves.DEPTH, within(1e-6));
  }

  @Test
  void theBookcaseHasBoardsAtTheShelvesHeights() {
    Part boards =
        Bookcase.model().parts().stream().filter(p -> p.name().equals("boards")).findAny().get();

    for (int shelf = 0; shelf < Shelves.COUNT; shelf++) {
      float top = (float) Shelves.top(shelf);
      assertThat(boards.mesh().positions()).usingComparatorWithPrecision(1e-5f).contains(top);
    }
    assertThat(Shelves.top(Shelves.COUNT - 1) + Shelves.CLEAR)
        .isCloseTo(Shelves.HEIGHT - 0.034, within(1e-6));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "printer",
        "mug",
        "laptop",
        "libraryMouse",
        "telephoneLibrary",
        "libraryPencilHolder",
        "folders"
      })
  void whatStandsOnShelvesFitsIntoBay(String object) {
    Bounds b = OfficeObjects.all().get(object).get().bounds();

    assertThat(b.width()).isLessThan(Shelves.BAY);
    assertThat(b.height()).isLessThan(Shelves.CLEAR);
    assertThat(b.depth()).isLessThan(Shelves.DEPTH);
  }

  @Test
  void booksStandBetweenTheBoardsWithoutTouchingThem() {
    double base = Shelves.top(LibraryBooks.LOWEST_SHELF);
    for (Part part : LibraryBooks.model().parts()) {
      for (int i = 0; i < part.mesh().pointCount(); i++) {
        Vector3d p = part.mesh().point(i);
        double above = (p.y + base - Shelves.top(0) + 1e-6) % (Shelves.CLEAR + Shelves.BOARD);
        assertThat(above).isLessThan(Shelves.CLEAR);
        assertThat(Math.abs(p.x)).isBetween(Shelves.BOARD / 2, INSIDE);
        assertThat(p.z).isBetween(-0.15, Shelves.DEPTH / 2 - 0.025);
      }
    }
  }
}
