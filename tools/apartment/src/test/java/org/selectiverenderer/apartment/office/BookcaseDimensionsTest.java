package org.selectiverenderer.apartment.office;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.modelling.Part;

class BookcaseDimensionsTest {
  private static final double INSIDE = BookcaseDimensions.WIDTH / 2 - BookcaseDimensions.BOARD;

  @Test
  void theBookcaseIsAsLargeAsSaid() {
    BoundingBox b = Bookcase.model().bounds();

    assertThat(b.width()).isCloseTo(BookcaseDimensions.WIDTH, within(1e-6));
    assertThat(b.height()).isCloseTo(BookcaseDimensions.HEIGHT, within(1e-6));
    assertThat(b.depth()).isCloseTo(BookcaseDimensions.DEPTH, within(1e-6));
  }

  @Test
  void theBookcaseHasBoardsAtTheShelvesHeights() {
    Part boards =
        Bookcase.model().parts().stream().filter(p -> p.name().equals("boards")).findAny().get();

    for (int shelf = 0; shelf < BookcaseDimensions.COUNT; shelf++) {
      float top = (float) BookcaseDimensions.top(shelf);
      assertThat(boards.mesh().positions()).usingComparatorWithPrecision(1e-5f).contains(top);
    }
    assertThat(BookcaseDimensions.top(BookcaseDimensions.COUNT - 1) + BookcaseDimensions.CLEAR)
        .isCloseTo(BookcaseDimensions.HEIGHT - 0.034, within(1e-6));
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
    BoundingBox b = OfficeRecipes.all().get(object).get().bounds();

    assertThat(b.width()).isLessThan(BookcaseDimensions.BAY);
    assertThat(b.height()).isLessThan(BookcaseDimensions.CLEAR);
    assertThat(b.depth()).isLessThan(BookcaseDimensions.DEPTH);
  }

  @Test
  void booksStandBetweenTheBoardsWithoutTouchingThem() {
    double base = BookcaseDimensions.top(LibraryBooks.LOWEST_SHELF);
    for (Part part : LibraryBooks.model().parts()) {
      for (int i = 0; i < part.mesh().pointCount(); i++) {
        Vector3d p = part.mesh().point(i);
        double above =
            (p.y + base - BookcaseDimensions.top(0) + 1e-6)
                % (BookcaseDimensions.CLEAR + BookcaseDimensions.BOARD);
        assertThat(above).isLessThan(BookcaseDimensions.CLEAR);
        assertThat(Math.abs(p.x)).isBetween(BookcaseDimensions.BOARD / 2, INSIDE);
        assertThat(p.z).isBetween(-0.15, BookcaseDimensions.DEPTH / 2 - 0.025);
      }
    }
  }
}
